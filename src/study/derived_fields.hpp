#pragma once
#include <vector>

#include "io/export_frame.hpp"

namespace arenite::study {

/// What texture knows of every grain, as columns for exports: contacts, rattler, sigma_norm, psi6, and with a known
/// length sigma_hyd and the components of sigma (Pa, tension positive).
std::vector<io::GrainField> derived_fields(const Packing& packing);

}  // namespace arenite::study
