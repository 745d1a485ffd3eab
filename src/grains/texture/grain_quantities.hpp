#pragma once
#include <optional>
#include <string_view>
#include <vector>

#include "model/colour_scale.hpp"
#include "model/packing.hpp"

namespace arenite::texture {

/// A number that every grain of a state has: pictures are coloured by it, and grains are compared by it. `of` is null
/// where it takes more than the state: a state before, or the coefficient of friction; or, with `of_spheres`, where
/// disks do not have it; `of_spheres` is null where spheres do not. What it is called is said here alone, for
/// page and print.
struct GrainQuantity {
  std::string_view name, label, symbol, unit;
  ColourScale colours = ColourScale::even;
  std::vector<double> (*of)(const Packing& packing) = nullptr;
  /// Instead of `of`, of other numbers here (core/formula.hpp).
  std::string_view formula = {};
  std::vector<double> (*of_spheres)(const PackingIn<3>& packing) = nullptr;
  bool is_magnitude = false;  ///< never below 0, so that no scale is centred
};

/// All, in the order of the page. A new one is one more row.
const std::vector<GrainQuantity>& grain_quantities();

/// The one of this name. Throws InputError for another.
const GrainQuantity& grain_quantity(std::string_view name);

/// The values of the one of this name. Throws InputError for another, and for one that takes more than the state.
std::vector<double> values_of(const Packing& packing, std::string_view name);
/// The same of spheres. Throws InputError also for what they do not have.
std::vector<double> values_of(const PackingIn<3>& packing, std::string_view name);

/// Mean |F_t|/F_n of the contacts of each grain that push, 0 without such; over `friction`, where it is given: the
/// fraction of Coulomb's limit that is mobilised, 0 without friction.
std::vector<double> mobilisations(const Packing& packing, std::optional<double> friction = {});
std::vector<double> mobilisations(const PackingIn<3>& packing, std::optional<double> friction = {});

/// A state and how far its cell is sheared, du_x/dy.
template <int D> struct ShearedIn {
  const PackingIn<D>* packing;
  double strain = 0;
};
using Sheared = ShearedIn<2>;

/// Displacements of grains since the first of these states, m, of each state; without the shear of a sheared cell. In a
/// periodic cell the way from state to state is the shortest, so that grains must not move farther than half a cell
/// between them. Grains are known by their ids; one that came in later counts from the state where it is first seen.
std::vector<std::vector<Vec2>> displacements(const std::vector<Sheared>& states);
std::vector<std::vector<Vec3>> displacements(const std::vector<ShearedIn<3>>& states);

/// Rotations likewise, rad.
std::vector<std::vector<double>> rotations(const std::vector<const Packing*>& states);

}  // namespace arenite::texture
