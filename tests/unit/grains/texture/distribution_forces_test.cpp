#include <gtest/gtest.h>

#include <algorithm>

#include "grains/texture/texture.hpp"
#include "unit/grains/texture/packings.hpp"

namespace arenite::texture {
namespace {

TEST(Forces, OfACohesiveSampleHaveATailOnEachSide) {
  Packing p = test::square_lattice(20);
  RandomStream random(9, Purpose::test);
  for (std::size_t c = 0; c < p.contacts.size(); ++c)
    p.contacts.fn[c] = c % 4 == 0 ? 0.5 * std::log(1 - random.uniform()) : -2 * std::log(1 - random.uniform());
  const Texture t = measure(p);
  const Distribution &push = *find(t.force.compressive, "all"), &pull = *find(t.force.tensile, "all");
  EXPECT_EQ(push.count, 600u);
  EXPECT_EQ(pull.count, 200u);
  EXPECT_DOUBLE_EQ(t.force.tensile_share.value, 0.25);
  EXPECT_NEAR(push.tail.beta.value, 1, 4 * push.tail.beta.error);  // each over its own mean
  EXPECT_NEAR(pull.tail.beta.value, 1, 4 * pull.tail.beta.error);
  EXPECT_NEAR(t.force.tensile_mean_ratio, 0.25, 0.06);
  EXPECT_EQ(t.quality.negative_forces, 200u);
}

TEST(Forces, ThatPullAreAnErrorOfMeasurementOnlyWhereTheyAreMeasured) {
  Packing p = test::square_lattice(6);
  for (auto& f : p.contacts.fn) f = 1;
  p.contacts.fn[30] = -0.1;
  const auto note = [&](Pull pull) {
    Options options;
    options.pull = pull;
    const auto notes = measure(p, options).notes;
    const auto it = std::find_if(notes.begin(), notes.end(), [](const std::string& n) { return n.find("normal forces pull") != n.npos; });
    return it == notes.end() ? std::string() : *it;
  };
  EXPECT_NE(note(Pull::measured).find("an error of measurement"), std::string::npos);
  EXPECT_NE(note(Pull::dashpots).find("attractive_dashpot"), std::string::npos);
  EXPECT_NE(note(Pull::adhesion).find("adhesion"), std::string::npos);
  EXPECT_EQ(note(Pull::dashpots).find("error"), std::string::npos);
  EXPECT_EQ(note(Pull::adhesion).find("error"), std::string::npos);
}

TEST(Forces, ByTypeKnowTheirOwnMeanAndThatOfAll) {
  Packing p = test::square_lattice(6);  // columns A A B A A B; contacts of two B carry 3 N, of A and B 2 N, of two A 1 N
  for (std::size_t g = 0; g < p.grains.size(); ++g) p.grains.material[g] = g % 6 % 3 == 2 ? 1 : 0;
  for (std::size_t c = 0; c < p.contacts.size(); ++c)
    p.contacts.fn[c] = 1 + p.grains.material[static_cast<std::size_t>(p.contacts.i[c])] + p.grains.material[static_cast<std::size_t>(p.contacts.j[c])];
  const Texture t = measure(p);
  EXPECT_DOUBLE_EQ(find(t.force.compressive, "B-B")->mean.value, 3);
  EXPECT_DOUBLE_EQ(find(t.force.compressive, "B-B")->fraction_above_mean.value, 0);
  EXPECT_DOUBLE_EQ(find(t.force.compressive, "B-B")->fraction_above_mean_of_all.value, 1);
  EXPECT_DOUBLE_EQ(find(t.force.compressive, "A-A")->fraction_above_mean_of_all.value, 0);
  EXPECT_DOUBLE_EQ(find(t.force.compressive, "all")->mean.value, (36.0 * 1 + 24 * 2 + 12 * 3) / 72);
}

TEST(Forces, BetweenGluedAndDryGrainsAreToldApart) {
  Packing p = test::square_lattice(6);
  for (std::size_t g = 0; g < 12; ++g) p.grains.zone[g] = 1;  // two rows
  const Texture t = measure(p);
  EXPECT_EQ(find(t.force.compressive, "glued-glued")->count, 18u);
  EXPECT_EQ(find(t.force.compressive, "dry-glued")->count, 12u);
  EXPECT_EQ(find(t.force.compressive, "dry-dry")->count, 42u);
  EXPECT_EQ(find(t.sigma_norm.sets, "glued")->count, 12u);
}

TEST(Threshold, SeparatesStrongFromWeakDirections) {
  Packing p = test::square_lattice(8);
  for (std::size_t c = 0; c < p.contacts.size(); ++c) p.contacts.fn[c] = std::abs(p.contacts.normal[c].y) > 0.5 ? 3 : 1;
  const ThresholdCurve curve = measure(p).threshold;  // mean 2, load along y
  for (std::size_t k = 0; k < curve.threshold.size(); ++k) {
    const double x = curve.threshold[k];
    if (x > 0.55 && x < 1.45) {
      EXPECT_NEAR(curve.below[k], -2, 1e-12) << x;
      EXPECT_NEAR(curve.above[k], 2, 1e-12) << x;
    } else if (x > 1.55) {
      EXPECT_NEAR(curve.below[k], 0, 1e-12) << x;
      EXPECT_TRUE(std::isnan(curve.above[k])) << x;
    }
  }
}

}  // namespace
}  // namespace arenite::texture
