#pragma once
#include "report/figures/figure_document.hpp"
#include "report/number_block.hpp"
#include "report/page.hpp"

namespace arenite::report {

/// Adds "spheres" (one a stage of a sample of spheres) to the page's document: of its states container, and place,
/// radius, material and some quantities (grain_quantities.hpp) of every sphere, with the 100 000 largest forces between
/// them; of many states of many spheres so many as the page can carry. The last state says what its quantities are
/// called and what they are in the mean. Some states, the last among them, have coarse-grained fields.
void add_spheres(Numbers& document, const PageData& data, NumberBlock& block, const figures::WriteList& write);

/// The last state of a stage under way, for the page that watches it.
Numbers state_of_now(const SphereResult& stage, NumberBlock& block);

}  // namespace arenite::report
