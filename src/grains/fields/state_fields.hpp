#pragma once
#include "grains/fields/coarse_grained.hpp"
#include "model/result.hpp"

namespace arenite::fields {

/// How fast a stage sheared its cell at a time, 1/s, from its history; 0 where it did not.
double shear_rate_at(const History& history, double time);

/// Mean diameter of the grains, m; 0 without grains.
double mean_diameter(const Grains& grains);

/// Whether a state has what fields need: grains, a box and its thickness.
bool has_fields(const Packing& packing);

/// Fields of a state over its whole box, smeared by Lucy's function of that width, at points so far apart (m).
CoarseFields coarse_fields(const Packing& packing, double shear_rate, double width, double spacing);

}  // namespace arenite::fields
