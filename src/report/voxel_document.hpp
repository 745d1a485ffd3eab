#pragma once
#include "report/figures/figure_document.hpp"
#include "report/number_block.hpp"
#include "report/page.hpp"

namespace arenite::report {

/// Adds "volumes" (one a sample in space) to the page's document: phases and quantities of every voxel, of large
/// samples of every second or third along each axis; a quantity as codes of one byte, 0 for the void and 1 to 255 from
/// its 0.001 quantile to its 0.999 quantile.
void add_volumes(Numbers& document, const PageData& data, NumberBlock& block, const figures::WriteList& write);

}  // namespace arenite::report
