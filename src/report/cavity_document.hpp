#pragma once
#include "model/phase_map.hpp"
#include "report/document_parts.hpp"
#include "report/thinned_map.hpp"

namespace arenite::report {

/// "voids" and "pores" of a map: label of every node on the page (0: none), nodes of each, and the density of their
/// volumes, by the rules and over the reference radius that the result's numbers state; without these by the rules'
/// defaults, over the mean radius of the large grains (of any where there are no classes).
Numbers cavities_of(const PhaseMap& map, const Numbers& numbers, const Thinning& kept, NumberBlock& block);

}  // namespace arenite::report
