#pragma once
#include "report/figures/figure_document.hpp"
#include "report/number_block.hpp"
#include "report/page.hpp"

namespace arenite::report {

/// Adds "spheres" (one a stage of a sample of spheres) to the page's document: container and materials, and of its last
/// state place, radius, material, contacts, mean stress (Pa, tension positive) and speed of every sphere, with the
/// 100 000 largest forces between them.
void add_spheres(Numbers& document, const PageData& data, NumberBlock& block, const figures::WriteList& write);

}  // namespace arenite::report
