#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <numbers>

#include "core/random.hpp"
#include "grains/texture/oscillation.hpp"
#include "grains/texture/view.hpp"
#include "support/numbers_of.hpp"
#include "unit/grains/texture/packings.hpp"

namespace arenite::texture {
namespace {

using test::add_contact;
using test::add_grain;
using test::empty_box;

double fabric(const Texture& t, const std::string& name) { return test::value_of(t.numbers, "fabric/" + name); }

/// Grains along rays from a central one, so that contact orientations and forces are what one asks for.
Packing star(const std::vector<double>& degrees, const std::vector<double>& forces) {
  Packing p = empty_box(0, 0);
  add_grain(p, {0, 0}, 1);
  for (std::size_t k = 0; k < degrees.size(); ++k) {
    const double a = degrees[k] * std::numbers::pi / 180;
    add_grain(p, {2 * std::cos(a), 2 * std::sin(a)}, 1);
    add_contact(p, 0, k + 1, forces[k]);
  }
  return p;
}

/// Grains along a random network: contacts of random direction whose forces know nothing of it.
Packing random_network(std::uint64_t seed, std::size_t contacts) {
  RandomStream random(seed, Purpose::test);
  std::vector<double> degrees, forces;
  for (std::size_t c = 0; c < contacts; ++c) {
    degrees.push_back(random.uniform(0, 360));
    forces.push_back(-std::log(1 - random.uniform()));
  }
  return star(degrees, forces);
}

// The axis of compression of the same contacts leans to where the strong ones happen to point: about it even chance has
// a sign.
TEST(Fabric, SignedAnisotropyOfARandomNetworkIsZeroAboutTheLoadsAxisOnly) {
  const int trials = 60;
  double about_load = 0, square = 0, about_own = 0;
  for (int seed = 1; seed <= trials; ++seed) {
    const Packing network = random_network(static_cast<std::uint64_t>(seed), 400);
    Options options;
    options.load_axis = std::numbers::pi / 2;
    const double a = fabric(measure(network, options), "sets/strong/a_c_signed");
    about_load += a / trials;
    square += a * a / trials;
    about_own += fabric(measure(network), "sets/strong/a_c_signed") / trials;
  }
  const double error = std::sqrt(square / trials);
  EXPECT_LT(std::abs(about_load), 3 * error);
  EXPECT_GT(about_own, 6 * error);
}

TEST(Fabric, SaysWhereItsSignsHaveNoAxisFromOutside) {
  Options options;
  options.load_axis = 0;
  const auto says = [](const Texture& t) {
    return std::any_of(t.notes.begin(), t.notes.end(),
                       [](const std::string& note) { return note.find("direction of the load") != std::string::npos; });
  };
  EXPECT_TRUE(says(measure(random_network(1, 50))));
  EXPECT_FALSE(says(measure(random_network(1, 50), options)));
}

TEST(Fabric, OfASquareLatticeIsIsotropicWithFullFourfoldOrder) {
  const Texture t = measure(test::square_lattice(8));
  EXPECT_NEAR(fabric(t, "phi/value/0/0"), 0.5, 1e-15);
  EXPECT_NEAR(fabric(t, "phi/value/0/1"), 0, 1e-15);
  EXPECT_NEAR(fabric(t, "a_c"), 0, 1e-14);
  EXPECT_NEAR(fabric(t, "modes/4/amplitude"), 1, 1e-14);
  EXPECT_NEAR(std::remainder(fabric(t, "modes/4/phase_deg"), 90), 0, 1e-10);
}

TEST(Fabric, OfATriangularLatticeIsIsotropicWithPeaksAt0_60_120) {
  const Texture t = measure(test::triangular_lattice(8));
  EXPECT_NEAR(fabric(t, "a_c"), 0, 1e-14);
  EXPECT_NEAR(fabric(t, "modes/4/amplitude"), 0, 1e-14);
  EXPECT_NEAR(fabric(t, "modes/6/amplitude"), 1, 1e-13);
  EXPECT_NEAR(std::remainder(fabric(t, "modes/6/phase_deg"), 60), 0, 1e-10);
  for (std::size_t s = 0; s < 18; ++s)
    EXPECT_EQ(test::list_of(t.numbers, "fabric/sectors")[s], s % 6 == 0 ? 64 : 0) << "sector " << s;
  EXPECT_NEAR(test::value_of(t.numbers, "local_order/psi6"), 1, 1e-13);
  EXPECT_EQ(test::value_of(t.numbers, "local_order/triangular_share/A"), 1);
}

TEST(Fabric, CountsDirectionsInAsManySectorsAsAsked) {
  Options options;
  options.sectors = 12;
  const Texture t = measure(test::triangular_lattice(8), options);
  ASSERT_EQ(test::list_of(t.numbers, "fabric/sectors").size(), 12u);
  for (std::size_t s = 0; s < 12; ++s)
    EXPECT_EQ(test::list_of(t.numbers, "fabric/sectors")[s], s % 4 == 0 ? 64 : 0) << "sector " << s;
}

TEST(Fabric, OfOneDirectionHasTheLargestAnisotropyAlongIt) {
  const Texture t = measure(star({30, 30.0 + 180, 30}, {1, 1, 1}));
  EXPECT_NEAR(fabric(t, "a_c"), 2, 1e-14);
  EXPECT_NEAR(fabric(t, "theta_c_deg"), 30, 1e-12);
}

TEST(Fabric, SignedAnisotropyIsNegativeAcrossTheLoad) {
  Options across;
  across.load_axis = std::numbers::pi / 2;
  EXPECT_NEAR(fabric(measure(star({0, 180}, {1, 1}), across), "a_c_signed"), -2, 1e-14);
  Options along;
  along.load_axis = 0;
  EXPECT_NEAR(fabric(measure(star({0, 180}, {1, 1}), along), "a_c_signed"), 2, 1e-14);
}

TEST(Fabric, MechanicalAnisotropyIsThatOfTheForcesWhateverTheCounts) {
  std::vector<double> degrees, forces;
  RandomStream random(3, Purpose::test);
  for (int k = 0; k < 400; ++k) {
    degrees.push_back(k < 300 ? random.uniform(0, 90) : random.uniform(0, 180));  // counts lean to 45 degrees
    forces.push_back(5 * (1 + 0.4 * std::cos(2 * (degrees.back() - 120) * std::numbers::pi / 180)));
  }
  const Texture t = measure(star(degrees, forces));
  EXPECT_NEAR(fabric(t, "a_n"), 0.4, 1e-10);
  EXPECT_NEAR(fabric(t, "theta_n_deg"), 120, 1e-8);
  EXPECT_GT(fabric(t, "a_c"), 0.5);
}

TEST(Fabric, OfRandomDirectionsScattersLikeItsNoise) {
  double mean = 0;
  const int trials = 200, contacts = 200;
  for (int s = 0; s < trials; ++s) {
    RandomStream random(static_cast<std::uint64_t>(s), Purpose::test);
    std::vector<double> degrees(contacts);
    for (double& d : degrees) d = random.uniform(0, 360);
    const Texture t = measure(star(degrees, std::vector<double>(contacts, 1)));
    mean += fabric(t, "a_c") / trials;
    EXPECT_NEAR(fabric(t, "a_c_noise"), 2 * 0.886 / std::sqrt(contacts), 1e-3 * fabric(t, "a_c_noise"));
  }
  EXPECT_NEAR(mean, 2 * 0.886 / std::sqrt(contacts),
              4 * 0.463 * 2 / std::sqrt(contacts * trials));  // 4 standard errors
}

TEST(Fabric, StrongContactsAreThoseAboveTheMeanForce) {
  const Texture t = measure(star({90, 90, 0, 0, 0}, {10, 10, 1, 1, 1}));
  EXPECT_EQ(fabric(t, "sets/strong/contacts"), 2);
  EXPECT_NEAR(fabric(t, "sets/strong/theta_c_deg"), 90, 1e-12);
  EXPECT_EQ(fabric(t, "sets/weak/contacts"), 3);
}

RC_GTEST_PROP(Fabric, TurnsWithTheSampleAndMirrorsWithIt, ()) {
  const Packing p = [&] {
    Packing q = test::random_network(*rc::gen::inRange(0u, 1000u));
    q.domain.wall = {};  // without a box nothing singles out a direction
    return q;
  }();
  const double turn = *rc::gen::inRange(0, 360) * std::numbers::pi / 180;
  const bool mirror = *rc::gen::arbitrary<bool>();
  Packing q = p;
  const auto move = [&](Vec2 v) {
    if (mirror) v.x = -v.x;
    return Vec2{std::cos(turn) * v.x - std::sin(turn) * v.y, std::sin(turn) * v.x + std::cos(turn) * v.y};
  };
  for (std::size_t g = 0; g < q.grains.size(); ++g) {
    const Vec2 c = move(p.grains.position[g]);
    q.grains.position[g] = c;
  }
  for (std::size_t c = 0; c < q.contacts.size(); ++c) {
    const Vec2 n = move(p.contacts.normal[c]);
    q.contacts.normal[c].x = n.x;
    q.contacts.normal[c].y = n.y;
    if (mirror) q.contacts.ft[c] = -p.contacts.ft[c];
  }
  const Texture a = measure(p), b = measure(q);
  RC_ASSERT(std::abs(fabric(a, "a_c") - fabric(b, "a_c")) < 1e-12);
  const double expected =
      (mirror ? 180 - fabric(a, "theta_c_deg") : fabric(a, "theta_c_deg")) + turn * 180 / std::numbers::pi;
  RC_ASSERT(std::abs(std::remainder(expected - fabric(b, "theta_c_deg"), 180)) < 1e-8);
  RC_ASSERT(std::abs(fabric(a, "a_n") - fabric(b, "a_n")) < 1e-10);
  RC_ASSERT(std::abs(fabric(a, "a_c_signed") - fabric(b, "a_c_signed")) <
            1e-10);  // the load axis turns with the stress
  for (std::size_t g = 0; g < p.grains.size(); ++g)
    RC_ASSERT(std::abs(a.per_grain.sigma_hyd[g] - b.per_grain.sigma_hyd[g]) <
              1e-10 * (1 + std::abs(a.per_grain.sigma_hyd[g])));
}

TEST(Oscillation, HasTheErrorsThatOtherSamplesScatterBy) {
  for (const double truth : {0.0, 1.0, 2.7, 4.0}) {
    RandomStream random(3, Purpose::test);
    constexpr int samples = 4000;
    double sum = 0, squares = 0, told = 0, off = 0, off_told = 0;
    for (int k = 0; k < samples; ++k) {
      const Oscillation o = oscillation({truth + random.normal(), 1}, {random.normal(), 1}, 2);
      const double turned = std::remainder(o.direction_deg.value, 180);
      sum += o.amplitude.value, squares += o.amplitude.value * o.amplitude.value;
      told += o.amplitude.error * o.amplitude.error;
      off += turned * turned, off_told += o.direction_deg.error * o.direction_deg.error;
    }
    EXPECT_NEAR(std::sqrt((squares - sum * sum / samples) / told), 1, 0.2) << truth;
    EXPECT_GT(std::sqrt(off / off_told), 0.7) << truth;
    EXPECT_LT(std::sqrt(off / off_told), 1.3) << truth;
  }
  const Oscillation exact = oscillation({0.3, 0}, {0.4, 0}, 2);
  EXPECT_EQ(exact.amplitude.error, 0);
  EXPECT_EQ(exact.direction_deg.error, 0);
  EXPECT_TRUE(std::isnan(oscillation({1}, {0}, 4).direction_deg.error));
}

}  // namespace
}  // namespace arenite::texture
