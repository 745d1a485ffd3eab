#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "io/image/phase_map.hpp"
#include "solid/peridynamics/load.hpp"
#include "thermal/imaging/label_grains.hpp"

namespace {
using namespace arenite;
using namespace arenite::peridynamics;

const std::string examples = ARENITE_SOURCE_DIR "/examples/";

PhaseMap electrode(int slice, imaging::Labelling way = imaging::Labelling::watershed) {
  io::PhaseMapOptions options;
  options.phases = io::parse_phase_table("0=void,85=particle,170=matrix");
  options.image.slice = slice;
  PhaseMap map = io::read_phase_map(examples + "30-electrode/electrode.tiff", options).map;
  imaging::label_grains(map, {way, 1});
  return map;
}
PhaseMap sandstone(std::optional<io::Crop> crop) {
  io::PhaseMapOptions options;
  options.phases = io::parse_phase_table("0=void,1=particle,2=matrix");
  options.crop = crop;
  PhaseMap map = io::read_phase_map(examples + "31-sandstone/OffshoreMiocene_20_1_mask.png", options).map;
  imaging::label_grains(map, {});
  return map;
}

/// Shares of void, matrix, particle.
std::array<double, 3> shares(const PhaseMap& map) {
  std::array<double, 3> share{};
  for (const Phase p : map.phase) share[static_cast<std::size_t>(p)] += 1 / static_cast<double>(map.size());
  return share;
}

/// What holds for any sample in equilibrium, whatever it looks like.
void expect_equilibrium(const PhaseMap& map, Loading loading) {
  LoadOptions options;
  options.loading = loading;
  options.tolerance = 1e-10;  // of uniform strain, where these samples are a hundred to a thousand times softer
  options.max_iterations = 200;
  const LoadReport r = load(map, options).report;
  EXPECT_EQ(r.ending, Ending::solved) << r.sentence;
  EXPECT_LE(std::abs(r.identity_defect), 1e-6) << r.sentence;
  const auto [empty, matrix, particle] = shares(map);
  const double voigt = matrix * options.stiffness.matrix + particle * options.stiffness.particle;
  EXPECT_GT(r.modulus, 0);  // Reuss's bound of a sample with void
  EXPECT_LT(r.modulus, voigt);
  EXPECT_LT(std::hypot(r.top_force.x + r.bottom_force.x, r.top_force.y + r.bottom_force.y),
            1e-6 * std::hypot(r.top_force.x, r.top_force.y));
}

TEST(Electrode, HasTheSharesOfItsSourceInEverySlice) {
  // Of the volume, by the source: pore 44.99, particle 40.05, binder 14.96 %; a slice scatters about them.
  std::array<double, 3> mean{};
  for (int slice = 0; slice < 256; slice += 8)
    for (std::size_t p = 0; const double share : shares(electrode(slice))) mean[p++] += share / 32;
  EXPECT_NEAR(mean[0], 0.4499, 2e-3);
  EXPECT_NEAR(mean[1], 0.1496, 2e-3);
  EXPECT_NEAR(mean[2], 0.4005, 2e-3);
}

TEST(Electrode, TouchingParticlesComeApart) {
  const PhaseMap together = electrode(64, imaging::Labelling::components), apart = electrode(64);
  EXPECT_GT(apart.grain_class.size(), together.grain_class.size() + 10);
  EXPECT_LT(apart.grain_class.size(), 2 * together.grain_class.size());
}

TEST(Electrode, SlicesAreSolvedInTension) {
  for (const int slice : {0, 64, 128, 255}) {
    SCOPED_TRACE(slice);
    expect_equilibrium(electrode(slice), Loading::tension);
  }
}

TEST(Sandstone, HasTheSharesOfItsSource) {
  const auto map = sandstone({});
  EXPECT_EQ(map.width, 4980);
  EXPECT_EQ(map.height, 2640);
  const auto [empty, matrix, particle] = shares(map);
  EXPECT_NEAR(empty, 0.257, 5e-4);
  EXPECT_NEAR(matrix, 0.108, 5e-4);
  EXPECT_NEAR(particle, 0.635, 5e-4);
}

TEST(Sandstone, APartIsSolvedInTensionAndCompressionAlike) {
  const auto map = sandstone(io::Crop{1900, 700, 512, 512});
  expect_equilibrium(map, Loading::tension);
  expect_equilibrium(map, Loading::compression);
}

}  // namespace
