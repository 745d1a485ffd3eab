#pragma once
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "geometry/rectangle.hpp"
#include "grains/texture/force_scale.hpp"
#include "grains/texture/texture.hpp"
#include "model/result.hpp"
#include "report/number_block.hpp"

namespace arenite::report {

/// Places of the grains of each contact, "i" and "j"; walls are numbered after the grains by their side.
Numbers pairs_of(const Packing& packing, NumberBlock& block);

Numbers materials_of(const Materials& materials);
/// What is the same of all states: names, radii, materials, zones and shapes of the grains.
Numbers grains_of(const Grains& grains, NumberBlock& block);

/// One state: its container, grains, contacts, bonds and pulls, with the rows by grain of its texture, and `numbers`
/// (figures::state_numbers), where they are known.
Numbers snapshot_of(const Snapshot& snapshot, std::size_t stage, const texture::Texture& texture,
                    const Numbers& numbers, NumberBlock& block);
/// What a picture of a state shows, m: its grains, closed boundaries, and of others, of sides and of the edges of a
/// periodic cell what lies near them.
geometry::Rectangle seen_of(const Packing& packing);
/// What a picture's forces are told apart by: {mean, tension}, N.
Numbers numbers_of(const texture::ForceScale& scale);

/// The coarse-grained fields of a state on a grid over its box: {bounds, columns, rows, width of the kernel} and arrays
/// of solid fraction, density, velocity, pressure and deviator of the whole stress, its shear and the kinetic pressure.
/// The kernel is as wide as the mean grain, or as a cell where the sample has many. `shear_rate`, 1/s: of a cell that
/// is sheared. Not known without grains or box.
Numbers coarse_fields_of(const Packing& packing, double shear_rate, NumberBlock& block);

/// The grains that a page knows: those of its last state, and where grains came in or left those of all other states
/// behind them, each once.
class ShownGrains {
 public:
  /// Of these stages, whose last state is the last one of all.
  explicit ShownGrains(const std::vector<const StageResult*>& stages);

  const Grains& all() const { return all_; }
  /// Whether a state can be shown: its grains are among these.
  bool has(const Grains& grains) const;
  /// The states of a stage that can.
  std::vector<const Snapshot*> states_of(const StageResult& stage) const;
  /// Where the grains of a state are among all; empty where each is at its own place. Grains put back elsewhere take
  /// the place of what they were.
  std::vector<std::uint32_t> places_of(const Grains& grains) const;
  bool exchanged() const { return exchanged_; }

 private:
  bool fits_last(const Grains& grains) const;

  Grains all_;
  std::size_t last_ = 0;  ///< how many the last state has
  bool exchanged_ = false;
  std::unordered_map<std::int64_t, std::uint32_t> place_;
};

}  // namespace arenite::report
