#include <gtest/gtest.h>

#include "core/error.hpp"
#include "grains/texture/rev.hpp"
#include "grains/texture/texture.hpp"
#include "support/numbers_of.hpp"
#include "unit/grains/texture/packings.hpp"

namespace arenite::texture {
namespace {

using test::value_of;

double z(const Texture& t, const std::string& name) { return value_of(t.numbers, "coordination/" + name); }

TEST(Coordination, IsFourOnASquareAndSixOnATriangularLattice) {
  EXPECT_DOUBLE_EQ(z(measure(test::square_lattice(6)), "all"), 4);
  EXPECT_DOUBLE_EQ(z(measure(test::triangular_lattice(6)), "all"), 6);
}

TEST(Coordination, OfAStripedLatticeHasItsPartsByBothDefinitions) {
  Packing p = test::square_lattice(6);  // columns A A B A A B: N_A = 24, N_B = 12
  for (std::size_t g = 0; g < p.grains.size(); ++g) p.grains.material[g] = g % 6 % 3 == 2 ? 1 : 0;
  const Texture t = measure(p);
  // Along a row A touches A once and B once, B touches A twice; along a column like touches like twice.
  EXPECT_DOUBLE_EQ(z(t, "A-A"), 3);
  EXPECT_DOUBLE_EQ(z(t, "A-B"), 1);
  EXPECT_DOUBLE_EQ(z(t, "B-B"), 2);
  EXPECT_DOUBLE_EQ(z(t, "B-A"), 2);
  EXPECT_DOUBLE_EQ(z(t, "A-ANY"), 4);
  EXPECT_DOUBLE_EQ(z(t, "B-ANY"), 4);
  EXPECT_DOUBLE_EQ(z(t, "unlike_contacts_twice/A-ANY"), 2.0 * (36 + 24) / 24);  // T 4.3.1: N_AA = 36, N_AB = 24
  EXPECT_DOUBLE_EQ(z(t, "unlike_contacts_twice/B-ANY"), 2.0 * (12 + 24) / 12);
  double parts = 0, share = 0;
  for (const char* pair : {"A-A", "A-B", "B-B"}) {
    parts += z(t, std::string("parts_of_z/") + pair);
    share += z(t, std::string("share_of_contacts/") + pair);
  }
  EXPECT_DOUBLE_EQ(parts, 4);
  EXPECT_DOUBLE_EQ(share, 1);
  EXPECT_DOUBLE_EQ(z(t, "parts_of_z/A-B"), 2.0 * 24 / 36);
}

TEST(Coordination, WithoutRattlersForgetsGrainsThatLeanOnRattlersOnly) {
  Packing p = test::square_lattice(6);
  p.domain.periodic[1] =
      false;  // a finger of two grains above the top row: the outer one has one contact, then so has the inner
  p.domain.wall[top].position = 9;
  p.contacts = {};
  for (std::size_t y = 0; y < 6; ++y)
    for (std::size_t x = 0; x < 6; ++x) {
      test::add_contact(p, y * 6 + x, y * 6 + (x + 1) % 6, 1);
      if (y < 5) test::add_contact(p, y * 6 + x, y * 6 + x + 6, 1);
    }
  test::add_grain(p, {0.5, 6.5}, 0.5);
  test::add_grain(p, {0.5, 7.5}, 0.5);
  test::add_contact(p, 30, 36, 1);
  test::add_contact(p, 36, 37, 1);
  Options whole;
  whole.border = 0;
  const Texture t = measure(p, whole);
  EXPECT_EQ(t.per_grain.rattler[36], 1);
  EXPECT_EQ(t.per_grain.rattler[37], 1);
  EXPECT_DOUBLE_EQ(z(t, "rattlers"), 2.0 / 38);
  EXPECT_DOUBLE_EQ(z(t, "all"), 2.0 * 68 / 38);
  EXPECT_DOUBLE_EQ(z(t, "without_rattlers"), 2.0 * 66 / 36);
}

TEST(Coordination, CountsOnlyGrainsBeyondTwoAndAHalfDiametersFromWalls) {
  Packing p = test::square_lattice(12);
  p.domain.periodic[0] = p.domain.periodic[1] = false;
  p.contacts = {};
  for (std::size_t y = 0; y < 12; ++y)
    for (std::size_t x = 0; x < 12; ++x) {
      if (x < 11) test::add_contact(p, y * 12 + x, y * 12 + x + 1, 1);
      if (y < 11) test::add_contact(p, y * 12 + x, y * 12 + x + 12, 1);
    }
  const Texture t = measure(p);
  EXPECT_EQ(t.numbers["considered"]["grains"], 64);  // centres 2.5 .. 9.5 in both directions, the edges included
  EXPECT_DOUBLE_EQ(t.window.x_min, 2.5);
  EXPECT_DOUBLE_EQ(t.window.y_max, 9.5);
  EXPECT_DOUBLE_EQ(z(t, "all"), 4);  // the border's grains with fewer contacts are left out
  EXPECT_EQ(value_of(t.numbers, "grains"), 144);
  EXPECT_EQ(value_of(t.numbers, "contacts"), 264);
}

TEST(Coordination, OfASampleSmallerThanItsBorderIsTakenWholeAndSaysSo) {
  Packing p = test::empty_box(2, 1);
  test::add_grain(p, {0.5, 0.5}, 0.5);
  test::add_grain(p, {1.5, 0.5}, 0.5);
  test::add_contact(p, 0, 1, 1);
  const Texture t = measure(p);
  EXPECT_DOUBLE_EQ(z(t, "all"), 1);
  ASSERT_FALSE(t.notes.empty());
  EXPECT_TRUE(std::any_of(t.notes.begin(), t.notes.end(),
                          [](const std::string& note) { return note.find("too small") != std::string::npos; }));
}

TEST(SolidFraction, OfGrainsWiderThanTheirPeriodicCellIsRefused) {
  Packing p = test::square_lattice(4);
  for (double& r : p.grains.radius) r = 2;  // each meets itself, just so
  EXPECT_GT(measure(p).solid_fraction.value, 1);
  p.grains.radius[7] = 80;
  EXPECT_THROW(measure(p), InputError);
  p.domain.periodic[0] = p.domain.periodic[1] = false;
  EXPECT_NO_THROW(measure(p));
}

TEST(SolidFraction, OfLatticesHasItsClosedForm) {
  EXPECT_NEAR(measure(test::square_lattice(8)).solid_fraction.value, std::acos(-1.0) / 4, 1e-14);
  EXPECT_NEAR(measure(test::triangular_lattice(8)).solid_fraction.value, std::acos(-1.0) / (2 * std::sqrt(3.0)), 1e-14);
}

/// Disks of two sizes put down at random without overlaps.
Packing scattered(std::uint64_t seed) {
  Packing p = test::empty_box(30, 30);
  RandomStream random(seed, Purpose::test);
  for (int trial = 0; trial < 4000; ++trial) {
    const double r = random.uniform() < 0.3 ? 0.9 : 0.4;
    const Vec2 centre{random.uniform(r, 30 - r), random.uniform(r, 30 - r)};
    bool fits = true;
    for (std::size_t g = 0; g < p.grains.size() && fits; ++g)
      fits = norm(centre - p.grains.position[g]) > r + p.grains.radius[g];
    if (fits) test::add_grain(p, centre, r);
  }
  return p;
}

// Fifty windows of nine tenths of the box are nearly one window: their own scatter over sqrt(50) would be a tenth of
// the error.
TEST(SolidFraction, TheErrorsOfWindowsCoverTheScatterOfSamples) {
  Options options;
  options.rev.sizes = 4;
  std::vector<std::vector<double>> mean(4), error(4);
  for (std::uint64_t seed = 1; seed <= 24; ++seed) {
    const Rev rev = measure(scattered(seed), options).rev;
    for (std::size_t s = 0; s < 4; ++s) {
      mean[s].push_back(rev.mean[s]);
      error[s].push_back(rev.error[s]);
    }
  }
  for (std::size_t s = 0; s < 4; ++s) {
    double centre = 0, square = 0, told = 0;
    for (const double m : mean[s]) centre += m / 24;
    for (const double m : mean[s]) square += (m - centre) * (m - centre) / 23;
    for (const double e : error[s]) told += e * e / 24;
    EXPECT_GT(std::sqrt(told / square), 0.65) << s;
    EXPECT_LT(std::sqrt(told / square), 2.0) << s;
  }
}

TEST(SolidFraction, OfWindowsSettlesAsTheyGrow) {
  const Packing lattice = test::square_lattice(12);
  for (const double fraction : window_fractions(lattice, 0.72, 20)) EXPECT_NEAR(fraction, std::acos(-1.0) / 4, 0.02);
  EXPECT_EQ(window_fractions(lattice, 0.72, 20), window_fractions(lattice, 0.72, 20));
  const Rev rev = measure(lattice).rev;
  ASSERT_EQ(rev.mean.size(), 20u);
  EXPECT_LT(rev.deviation.back(), 0.1 * rev.deviation.front());
  EXPECT_NEAR(rev.mean.back(), std::acos(-1.0) / 4, 0.01);
  EXPECT_NEAR(rev.mean.front(), std::acos(-1.0) / 4, 5 * rev.error.front());  // small windows are unbiased, only noisy
}

}  // namespace
}  // namespace arenite::texture
