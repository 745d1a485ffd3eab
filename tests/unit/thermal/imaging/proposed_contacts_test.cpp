#include "thermal/imaging/proposed_contacts.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "core/random.hpp"
#include "io/sample/sample.hpp"
#include "support/drawn_picture.hpp"
#include "support/pictures.hpp"

namespace {
using namespace arenite;
using imaging::propose_contacts;

Grains grains_at(const std::vector<Vec2>& centres, const std::vector<double>& radii) {
  Grains grains;
  grains.resize(centres.size());
  for (std::size_t g = 0; g < centres.size(); ++g) {
    grains.position[g] = centres[g];
    grains.radius[g] = radii[g];
  }
  return grains;
}

Domain box(double width, double height) {
  Domain domain;
  domain.wall[right].position = width;
  domain.wall[top].position = height;
  return domain;
}

Domain no_walls(double width, double height) {
  Domain domain = box(width, height);
  for (Wall& wall : domain.wall) wall.present = false;
  return domain;
}

std::set<std::pair<int, int>> pairs_of(const Contacts& contacts) {
  std::set<std::pair<int, int>> pairs;
  for (std::size_t c = 0; c < contacts.size(); ++c) pairs.emplace(contacts.i[c], contacts.j[c]);
  return pairs;
}

TEST(ProposedContacts, PointFromTheSecondGrainToTheFirstWithTheContactInTheMiddleOfTheOverlap) {
  const Contacts c = propose_contacts(grains_at({{1, 1}, {3.9, 1}}, {1, 2}), no_walls(9, 9));
  ASSERT_EQ(c.size(), 1u);
  EXPECT_EQ(c.normal[0].x, -1);
  EXPECT_EQ(c.normal[0].y, 0);
  EXPECT_NEAR(c.overlap[0], 0.1, 1e-12);
  EXPECT_NEAR(c.arm_i[0], 0.95, 1e-12);
  EXPECT_NEAR(c.arm_j[0], 1.95, 1e-12);
  EXPECT_EQ(c.fn[0], 0);
  EXPECT_EQ(c.ft[0], 0);
}

TEST(ProposedContacts, AreOfferedUpToTheirErrorAndTheFloor) {
  const Grains apart = grains_at({{1, 1}, {3.1, 1}}, {1, 1});
  const auto offered = [&](const imaging::GrainErrors& errors, const imaging::ContactTolerance& how) {
    return propose_contacts(apart, no_walls(9, 9), errors, how).size();
  };
  EXPECT_EQ(offered({}, {}), 0u);
  EXPECT_EQ(offered({}, {.floor = 0.11, .pixel = 1}), 1u);
  EXPECT_EQ(offered({}, {.floor = 0.09, .pixel = 1}), 0u);
  // Four errors of 0.025 give 0.05 for the gap.
  const imaging::GrainErrors errors{{0.025, 0.025}, {0.025, 0.025}};
  EXPECT_EQ(offered(errors, {.errors = 2.1}), 1u);
  EXPECT_EQ(offered(errors, {.errors = 1.9}), 0u);
  EXPECT_EQ(offered(errors, {.errors = 1.9, .floor = 0.1, .pixel = 0.1}), 1u);
}

TEST(ProposedContacts, WithWallsPointInwardAndLieInTheirPlane) {
  const Grains grains = grains_at({{1.05, 2.95}}, {1});
  Domain domain = box(2, 4);  // touches the right wall by 0.05 of overlap; 0.05 from left and top
  const auto tolerance = [](double wall_error) {
    return imaging::ContactTolerance{.errors = 3, .wall_error = wall_error};
  };
  const Contacts one = propose_contacts(grains, domain, {}, tolerance(0));
  ASSERT_EQ(one.size(), 1u);
  EXPECT_EQ(one.wall_side(0), right);
  EXPECT_EQ(one.normal[0].x, -1);
  EXPECT_NEAR(one.arm_i[0], 0.95, 1e-12);
  EXPECT_EQ(one.arm_j[0], 0);
  EXPECT_NEAR(one.overlap[0], 0.05, 1e-12);
  EXPECT_EQ(pairs_of(propose_contacts(grains, domain, {}, tolerance(0.02))),
            (std::set<std::pair<int, int>>{{0, wall_partner(left)}, {0, wall_partner(right)}, {0, wall_partner(top)}}));
  domain.wall[right].present = false;
  EXPECT_EQ(propose_contacts(grains, domain, {}, tolerance(0)).size(), 0u);
}

TEST(ProposedContacts, AreAllPairsWithinReachInShearedPeriodicCells) {
  RandomStream random(5, Purpose::test);
  for (int round = 0; round < 40; ++round) {
    std::vector<Vec2> centres;
    std::vector<double> radii;
    for (int g = 0; g < 60; ++g) {
      centres.push_back({40 * random.uniform() - 10, 30 * random.uniform() - 5});  // not all in the cell
      radii.push_back(0.5 + random.uniform());
    }
    Domain domain = no_walls(20, 15);
    domain.periodic[0] = round % 2 == 0;
    domain.periodic[1] = round % 4 < 2;
    domain.tilt = domain.periodic[0] ? 30 * random.uniform() - 15 : 0;
    const Grains grains = grains_at(centres, radii);
    std::set<std::pair<int, int>> near;
    for (int i = 0; i < 60; ++i)
      for (int j = i + 1; j < 60; ++j) {
        const Vec2 d =
            domain.nearest_image(centres[static_cast<std::size_t>(i)] - centres[static_cast<std::size_t>(j)]);
        if (norm(d) - radii[static_cast<std::size_t>(i)] - radii[static_cast<std::size_t>(j)] <= 0.3)
          near.emplace(i, j);
      }
    const Contacts found = propose_contacts(grains, domain, {}, {.floor = 1, .pixel = 0.3});
    EXPECT_EQ(pairs_of(found), near) << round;
    EXPECT_EQ(found.size(), near.size());
  }
}

/// Grains of a loaded packing with the errors that a search in a picture makes.
TEST(ProposedContacts, OfLoadedPackingsMissNextToNoneOfTheTrueOnes) {
  for (const char* sample : {"sample-02", "sample-08", "sample-12"}) {
    const double pixel = 1.6e-3, error = 0.02 * pixel;
    std::vector<Vec2> centres;
    std::vector<double> radii;
    for (const auto& d : test::packing_in_pixels(sample, pixel, 0, 0)) {
      centres.push_back(pixel * Vec2{d.x, -d.y});
      radii.push_back(pixel * d.radius);
    }
    const auto truth = pairs_of(propose_contacts(grains_at(centres, radii), no_walls(1, 1), {}, {.errors = 0}));
    RandomStream random(3, Purpose::test);
    for (Vec2& c : centres) c += error * Vec2{random.normal(), random.normal()};
    for (double& r : radii) r += 0.5 * error * random.normal();
    const imaging::GrainErrors errors{std::vector<double>(centres.size(), error),
                                      std::vector<double>(centres.size(), 0.5 * error)};
    const auto offered =
        pairs_of(propose_contacts(grains_at(centres, radii), no_walls(1, 1), errors, {.pixel = pixel}));
    std::size_t missed = 0;
    for (const auto& pair : truth) missed += offered.count(pair) == 0 ? 1 : 0;
    EXPECT_GT(truth.size(), centres.size()) << sample;
    EXPECT_LE(missed, truth.size() / 500) << sample;
    EXPECT_LT(offered.size(), 3 * truth.size() / 2) << sample;
  }
}

TEST(ProposedContacts, HoldAllOfAnotherCodesInAShearedCell) {
  const std::string folder = std::string(ARENITE_SOURCE_DIR) + "/examples/20-dem-shear-periodic/";
  io::SampleOptions options;
  options.box = {62.7755, 62.7755, 31.38775};
  options.periodic[0] = options.periodic[1] = true;
  options.thickness = 1;
  const io::Sample sample = io::read_sample(folder + "grains-5000.csv", folder + "contacts-5000.csv", options);
  const Packing& packing = sample.packing;
  const auto offered = pairs_of(propose_contacts(packing.grains, packing.domain, {}, {.floor = 1, .pixel = 1e-5}));
  EXPECT_EQ(packing.contacts.size(), 1928u);
  for (std::size_t c = 0; c < packing.contacts.size(); ++c) {
    const auto [i, j] = std::minmax(packing.contacts.i[c], packing.contacts.j[c]);
    EXPECT_EQ(offered.count({i, j}), 1u) << i << " " << j;
  }
  EXPECT_LT(offered.size(), 2 * packing.contacts.size());
}

TEST(ProposedContacts, RefuseErrorsThatDoNotFit) {
  const Grains grains = grains_at({{1, 1}, {3, 1}}, {1, 1});
  EXPECT_EQ(test::complaint([&] {
              propose_contacts(grains, box(4, 4), {{0.1}, {}});
            }),
            "there are 1 errors of the position for 2 grains; give one per grain");
  EXPECT_NE(test::complaint([&] {
              propose_contacts(grains, box(4, 4), {{}, {0.1, -1}});
            }).find("errors of the radius"),
            std::string::npos);
  EXPECT_NE(test::complaint([&] {
              propose_contacts(grains_at({{1, std::nan("")}}, {1}), box(4, 4));
            }).find("grain 0 has no position"),
            std::string::npos);
  EXPECT_EQ(propose_contacts(Grains{}, box(4, 4)).size(), 0u);
}

}  // namespace
