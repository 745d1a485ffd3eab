#pragma once
#include <string>

#include "io/sample/sample.hpp"
#include "model/measuring.hpp"
#include "model/result.hpp"

namespace arenite::workflow {

/// Gives a sample whose files have no contacts those between surfaces no further apart than a gap, m, without forces;
/// `told` is the gap in words. What it says of them ends without a full stop. Throws InputError for a gap wider than
/// the mean radius.
template <int D> std::string propose_contacts(io::SampleIn<D>& sample, double gap, const std::string& told);

/// Spheres as the only stage of a result, with one state, measured; `title` says where they come from.
SphereResult measured_stage(io::SampleIn<3> sample, const Measuring& how, const std::string& title);

}  // namespace arenite::workflow
