#pragma once
#include "model/phase_map.hpp"
#include "report/document_parts.hpp"
#include "report/thinned_map.hpp"

namespace arenite::report {

/// "voids" and "pores" of a map: label of every node on the page (0: none), nodes of each, and the density of their
/// volumes over that of a mean large grain (any grain where there are no classes).
Json cavities_of(const PhaseMap& map, const Thinning& kept, NumberBlock& block);

}  // namespace arenite::report
