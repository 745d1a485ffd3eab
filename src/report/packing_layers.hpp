#pragma once
#include "report/number_block.hpp"
#include "report/page.hpp"

/// What the page shows of a packing beside its grains and contacts.
namespace arenite::report {

/// The coarse-grained fields of a state on a grid over its box: {bounds, columns, rows, width of the kernel} and arrays of solid fraction,
/// density, velocity, pressure and deviator of the whole stress, its shear and the kinetic pressure. The kernel is as wide as the mean grain,
/// or as a cell where the sample has many. `shear_rate`, 1/s: of a cell that is sheared. Not known without grains or box.
Numbers coarse_fields_of(const Packing& packing, double shear_rate, NumberBlock& block);

/// Asked and measured size curve of the grains that the recipe asked a size law for; not known where it asked for none.
Numbers size_curves_of(const Packing& packing, const std::string& recipe, NumberBlock& block);

}  // namespace arenite::report
