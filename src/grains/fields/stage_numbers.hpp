#pragma once
#include <optional>
#include <vector>

#include "grains/dem/stage.hpp"
#include "grains/texture/texture.hpp"
#include "model/packing.hpp"
#include "model/result.hpp"

namespace arenite::fields {

/// The end of a stage, which its statistics are of.
struct StageEnd {
  const StageResult& result;
  const dem::Stage& stage;  ///< as it was asked for; nothing drives that of a packing
  const Packing* before;    ///< the state of a loaded sample that it began with; null where none was loaded before
  const texture::Texture& texture;            ///< of its last state
  const texture::Options* options = nullptr;  ///< how its states are measured; null: none but the last
};
using StageStatistic = Numbers(const StageEnd& end);

/// The sides of a sample row by row of a history: where they are, and the mean stresses on opposite ones times the
/// thickness, N/m. Normal stresses are positive where they press.
struct SideStresses {
  std::vector<double> time, width, height;  ///< s, m
  std::vector<double> xx, yy;               ///< on left and right, on bottom and top
  std::vector<double> along_x,
      along_y;  ///< shear on bottom and top, on left and right: positive where the top, or the right, is held back
  std::vector<double> pressure() const;  ///< mean of the two normal ones
};

/// Nothing without the sides' places or with fewer than two rows; a force that the history lacks counts as 0.
std::optional<SideStresses> side_stresses(const History& history);

/// Whether a stage ends while its sample is strained or flows, not in equilibrium: its states are moments in time.
bool ends_in_motion(const dem::Stage& stage);

/// How far the stress of one moment lies from the mean over time, by the second half of a history. Nothing where
/// nothing presses on the sides. It is how far another sample's lies from it, too, as long as both flow for long enough
/// to forget how they were made.
std::optional<texture::TimeScatter> stress_in_time(const History& history, double thickness);

/// How the texture of a stage's states is measured. Signs refer to the axis along which its sides load, where they load
/// along one only; of a stage that ends in motion the history tells how its stress fluctuates.
texture::Options texture_options(const StageResult& made);

/// All numbers of a stage with states. Of one that ends in motion between sides that press, errors are those by blocks
/// of its last state or, where it is clearly larger, the scatter of its states in time: blocks cannot see a sample
/// fluctuate as a whole. With too few states they are unknown where its pressure fluctuates by more than a tenth. A new
/// statistic is one file and one word in the list of stage_numbers.cpp.
StageStatistic stage_numbers;

/// "loads" of a stage whose sides press: by side what was asked for and what was reached beside it, with its error
/// and spread, and whether that is within 5 %. The load of a side, and of a cell's edge, is that of contact forces:
/// what grains carry across a cell by their motion, about I^2 of the pressure in a flow, is not in it, and is not
/// what a servo holds.
StageStatistic load_numbers;
/// The same of a stage of disks or spheres, which has a state.
template <int D> Numbers loads_of(const StageResultIn<D>& result, const dem::Stage& stage);

/// "energy_balance" of a stage whose energies were tracked: by how much it is open since the first row of the history.
StageStatistic energy_numbers;
Numbers energy_balance(const History& history);

/// Numbers of what flows under its weight, each with its error: "discharge" of a stage that counts what passes;
/// "surface" of one that weighs and on which no side presses: angle of repose, ends, and the run-out since the state
/// before; "floor" of one that lasts a time between walls: pressure at the bottom; "boundary_loads" of one with
/// boundaries: the mean force of the grains on each. Empty where it is none of these.
StageStatistic flow_numbers;
/// Those of disks or spheres alike: "discharge", "surface" and "boundary_loads".
template <int D> Numbers flows_of(const StageResultIn<D>& result, const dem::Stage& stage, const PackingIn<D>* before);

/// Numbers of a sample whose grains cohere: pairs joined at the end of the stage and those of them that are apart, the
/// mean pull of touching grains F_c, N, and the granular Bond number, F_c over a grain's weight, or, without gravity,
/// over the force p d t that the pressure of the state before puts on a grain. Where a stage draws sides apart: the
/// largest tension on one of them, Pa, and beside it Rumpf's estimate for the state before (H. Rumpf, Chem. Ing. Tech.
/// 42, 538, 1970), in the plane phi z F_c/(pi d t): solid fraction, joined neighbours a grain, mean diameter and
/// thickness; both over that pressure as well. Empty where nothing coheres.
StageStatistic cohesion_numbers;

}  // namespace arenite::fields
