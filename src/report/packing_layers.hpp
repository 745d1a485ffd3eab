#pragma once
#include <cstddef>

#include "grains/texture/texture.hpp"
#include "model/result.hpp"
#include "report/number_block.hpp"

namespace arenite::report {

/// Places of the grains of each contact, "i" and "j"; walls are numbered after the grains by their side.
Numbers pairs_of(const Packing& packing, NumberBlock& block);

Numbers materials_of(const Materials& materials);
/// What is the same of all states: names, radii, materials, zones and shapes of the grains.
Numbers grains_of(const Grains& grains, NumberBlock& block);

/// One state: its container, grains, contacts, bonds and pulls, and its texture, where that is known, with what else
/// is.
Numbers snapshot_of(const Snapshot& snapshot, std::size_t stage, const texture::Texture* texture,
                    const Numbers& also_known, NumberBlock& block);

/// The coarse-grained fields of a state on a grid over its box: {bounds, columns, rows, width of the kernel} and arrays
/// of solid fraction, density, velocity, pressure and deviator of the whole stress, its shear and the kinetic pressure.
/// The kernel is as wide as the mean grain, or as a cell where the sample has many. `shear_rate`, 1/s: of a cell that
/// is sheared. Not known without grains or box.
Numbers coarse_fields_of(const Packing& packing, double shear_rate, NumberBlock& block);

}  // namespace arenite::report
