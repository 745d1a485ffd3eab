#include <gtest/gtest.h>

#include <cmath>

#include "solid/peridynamics/bonds.hpp"
#include "solid/peridynamics/damage.hpp"
#include "solid/peridynamics/lattice.hpp"
#include "solid/peridynamics/load.hpp"
#include "support/cemented_sample.hpp"
#include "support/crack_energy.hpp"
#include "support/homogeneous_sample.hpp"
#include "support/lattice_moduli.hpp"
#include "verification/damage.hpp"

namespace arenite::peridynamics {
namespace {

/// A plate cut in two, or not, loaded until its first bond breaks.
DamageResult cut_plate(Loading loading, std::vector<Cut> cuts, bool stays_open = false) {
  DamageOptions options = of_weak_bonds(loading, 1);
  options.cracks_stay_open = stays_open;
  options.tolerance = 1e-10;
  options.cuts = std::move(cuts);
  return load_to_failure(test::homogeneous_sample(40, 32), options);
}

TEST(ClosingCracks, CutPlateIsAsStiffAsAWholeOneInCompressionAndCarriesNothingInTension) {
  // Of the bonds across the cut those along (2, 1) lie so flat that the plate's bulging stretches them, by (4 nu - 1)/5
  // of the compression, a fifteenth: these do not pull, which costs less than 1e-4.
  const std::vector<Cut> across = {{{-1, 15.5}, {41, 15.5}}};
  EXPECT_NEAR(cut_plate(Loading::compression, across).modulus / cut_plate(Loading::compression, {}).modulus, 1, 1e-4);
  EXPECT_EQ(cut_plate(Loading::tension, across).ending, DamageResult::Ending::no_path);
  EXPECT_EQ(cut_plate(Loading::compression, across, true).ending, DamageResult::Ending::no_path);
  const std::vector<Cut> notch = {{{-1, 15.5}, {20, 15.5}}};
  const double whole = cut_plate(Loading::compression, {}).modulus;
  EXPECT_NEAR(cut_plate(Loading::compression, notch).modulus / whole, 1, 1e-4);
  EXPECT_LT(cut_plate(Loading::tension, notch).modulus / whole, 0.9);
  EXPECT_NEAR(cut_plate(Loading::tension, notch).modulus / cut_plate(Loading::tension, notch, true).modulus, 1, 0.02);
}

/// Energy of a sample with parted bonds at displacements of unit strain, by its definition: of every bond that is whole
/// or shortened.
double least_energy_by_descent(const Bonds& whole, const Bonds& uncut, Field<double>& u) {
  const Grid& grid = whole.grid;
  const auto each = [&](const auto& visit) {
    each_bond(uncut, [&](const Bond& b) {
      const Offset e = b.step();
      const double extension = e.x * (u.x[b.j] - u.x[b.i]) + e.y * (u.y[b.j] - u.y[b.i]);
      if (whole.type(b.i, b.d) || extension < 0) visit(b, extension, uncut.modulus(b.type) / std::pow(length(e), 3));
    });
  };
  // Plain damped motion with unit masses: no solver of the program's takes part.
  Field<double> v(grid.padded_size()), f(grid.padded_size());
  for (int step = 0; step < 5000; ++step) {
    set_zero(f);
    each([&](const Bond& b, double extension, double k) {
      const Vec2 pull = k * extension * Vec2{static_cast<double>(b.step().x), static_cast<double>(b.step().y)};
      f.set(b.i, f.at(b.i) + pull);
      f.set(b.j, f.at(b.j) - pull);
    });
    for (int y = 1; y + 1 < grid.height; ++y)
      for (std::ptrdiff_t i = grid.row(y), end = i + grid.width; i < end; ++i) {
        v.set(i, 0.97 * v.at(i) + 0.5 * f.at(i));
        u.set(i, u.at(i) + v.at(i));
      }
  }
  double energy = 0;
  each([&](const Bond&, double extension, double k) { energy += k * extension * extension / 2; });
  return energy;
}

TEST(ClosingCracks, SlantedCrackComesToRestWhereDampedMotionDoes) {
  const PhaseMap map = test::homogeneous_sample(14, 14);
  const std::vector<Cut> slanted = {{{2.2, 3.1}, {11.3, 9.4}}};
  for (const Loading loading : {Loading::tension, Loading::compression, Loading::shear}) {
    DamageOptions options = of_weak_bonds(loading, 1);
    options.tolerance = 1e-11;
    options.cuts = slanted;
    const auto result = load_to_failure(map, options);
    Bonds uncut = make_bonds(map, {}), whole = uncut;
    make_cuts(whole, slanted);
    const Vec2 way = loading == Loading::tension       ? Vec2{0, 1}
                     : loading == Loading::compression ? Vec2{0, -1}
                                                       : Vec2{1, 0};
    Field<double> u(whole.grid.padded_size());
    whole.grid.each([&](std::ptrdiff_t i, int y) { u.set(i, y * map.dx * way); });
    const double energy = least_energy_by_descent(whole, uncut, u), height = (map.height - 1) * map.dx;
    // Work of the clamp at unit strain is twice the energy: sigma^2/(2 E) times the area.
    EXPECT_NEAR(result.modulus * height * map.width * map.dx / (2 * energy), 1, 1e-6) << static_cast<int>(loading);
  }
}

TEST(ClosingCracks, EnergyIsBalancedThroughTestsThatPartAndCloseFaces) {
  // A plate with two slanted cracks, whose faces press and slide: as they cannot do where cracks stay open.
  const PhaseMap plate = test::homogeneous_sample(40, 40),
                 packing = test::cemented_sample({.nodes = 64, .size_ratio = 2, .bridge = 0.4});
  for (const PhaseMap* map : {&plate, &packing})
    for (const Loading loading : {Loading::compression, Loading::shear}) {
      DamageOptions options = of_weak_bonds(loading, 120);
      if (map == &plate) options.cuts = {{{8.2, 8.1}, {19.3, 15.4}}, {{20.4, 30.2}, {33.1, 25.3}}};
      const auto closing = load_to_failure(*map, options);
      options.cracks_stay_open = true;
      const auto open = load_to_failure(*map, options);
      EXPECT_NE(closing.ending, DamageResult::Ending::not_converged) << closing.sentence;
      EXPECT_LT(closing.energy_defect, 1e-4);
      EXPECT_GE(closing.curve.back().released, closing.curve.back().bond_energy * (1 - 1e-6));
      if (map != &plate) continue;
      EXPECT_GT(closing.modulus, 1.01 * open.modulus) << static_cast<int>(loading);
      EXPECT_GT(closing.strength, 1.01 * open.strength) << static_cast<int>(loading);
    }
}

}  // namespace
}  // namespace arenite::peridynamics
