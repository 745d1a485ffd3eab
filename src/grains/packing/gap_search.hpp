#pragma once
#include <cstdint>

#include "geometry/rectangle.hpp"
#include "grains/packing/bidisperse.hpp"
#include "grains/packing/two_classes.hpp"

namespace arenite::packing {

/// The gap at which the volume ratio asked for comes out, by a line through the ratios that samplings reach; gap 0
/// where even that leaves too many small ones. Throws InputError where the ratio is below what the widest gap gives.
template <int D>
TwoClasses<D> find_gap(const BidisperseParameters& parameters, const geometry::Box<D>& box, std::uint64_t seed);

}  // namespace arenite::packing
