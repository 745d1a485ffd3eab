#include <gtest/gtest.h>

#include <algorithm>

#include "grains/texture/texture.hpp"
#include "support/numbers_of.hpp"
#include "unit/grains/texture/packings.hpp"

namespace arenite::texture {
namespace {

using test::error_of;
using test::value_of;

TEST(Forces, OfACohesiveSampleHaveATailOnEachSide) {
  Packing p = test::square_lattice(20);
  RandomStream random(9, Purpose::test);
  for (std::size_t c = 0; c < p.contacts.size(); ++c)
    p.contacts.fn[c] = c % 4 == 0 ? 0.5 * std::log(1 - random.uniform()) : -2 * std::log(1 - random.uniform());
  const Texture t = measure(p);
  const Numbers &push = t.numbers["force"], &pull = push["tensile"];
  EXPECT_EQ(value_of(push, "count"), 600);
  EXPECT_EQ(value_of(pull, "count"), 200);
  EXPECT_DOUBLE_EQ(value_of(push, "tensile_share"), 0.25);
  EXPECT_NEAR(value_of(push, "beta"), 1, 4 * error_of(push, "beta"));  // each over its own mean
  EXPECT_NEAR(value_of(pull, "beta"), 1, 4 * error_of(pull, "beta"));
  EXPECT_NEAR(value_of(pull, "mean_over_compressive_mean"), 0.25, 0.06);
  EXPECT_EQ(value_of(t.numbers, "quality/negative_forces"), 200);
}

TEST(Forces, ThatPullAreAnErrorOfMeasurementOnlyWhereTheyAreMeasured) {
  Packing p = test::square_lattice(6);
  for (auto& f : p.contacts.fn) f = 1;
  p.contacts.fn[30] = -0.1;
  const auto note = [&](Pull pull) {
    Options options;
    options.pull = pull;
    const auto notes = measure(p, options).notes;
    const auto it = std::find_if(notes.begin(), notes.end(),
                                 [](const std::string& n) { return n.find("normal forces are tensile") != n.npos; });
    return it == notes.end() ? std::string() : *it;
  };
  EXPECT_NE(note(Pull::measured).find("an error of measurement"), std::string::npos);
  EXPECT_NE(note(Pull::dashpots).find("attractive_dashpot"), std::string::npos);
  EXPECT_NE(note(Pull::adhesion).find("adhesion"), std::string::npos);
  EXPECT_EQ(note(Pull::dashpots).find("error"), std::string::npos);
  EXPECT_EQ(note(Pull::adhesion).find("error"), std::string::npos);
}

TEST(Forces, ByTypeKnowTheirOwnMeanAndThatOfAll) {
  Packing p =
      test::square_lattice(6);  // columns A A B A A B; contacts of two B carry 3 N, of A and B 2 N, of two A 1 N
  for (std::size_t g = 0; g < p.grains.size(); ++g) p.grains.material[g] = g % 6 % 3 == 2 ? 1 : 0;
  for (std::size_t c = 0; c < p.contacts.size(); ++c)
    p.contacts.fn[c] = 1 + p.grains.material[static_cast<std::size_t>(p.contacts.i[c])] +
                       p.grains.material[static_cast<std::size_t>(p.contacts.j[c])];
  const Texture t = measure(p);
  EXPECT_DOUBLE_EQ(value_of(t.numbers, "force/by_type/B-B/mean_N"), 3);
  EXPECT_DOUBLE_EQ(value_of(t.numbers, "force/by_type/B-B/strong_share"), 0);
  EXPECT_DOUBLE_EQ(value_of(t.numbers, "force/by_type/B-B/fraction_above_mean_of_all"), 1);
  EXPECT_DOUBLE_EQ(value_of(t.numbers, "force/by_type/A-A/fraction_above_mean_of_all"), 0);
  // The mean is 5/3: A-B and B-B are above, and their shares of all contacts add up to that of all.
  EXPECT_DOUBLE_EQ(value_of(t.numbers, "force/by_type/A-A/strong_share_of_all"), 0);
  EXPECT_DOUBLE_EQ(value_of(t.numbers, "force/by_type/A-B/strong_share_of_all"), 24.0 / 72);
  EXPECT_DOUBLE_EQ(value_of(t.numbers, "force/by_type/B-B/strong_share_of_all"), 12.0 / 72);
  EXPECT_DOUBLE_EQ(value_of(t.numbers, "force/strong_share"), 36.0 / 72);
  EXPECT_DOUBLE_EQ(value_of(t.numbers, "force/mean_N"), (36.0 * 1 + 24 * 2 + 12 * 3) / 72);
}

TEST(Forces, BetweenGluedAndDryGrainsAreToldApart) {
  Packing p = test::square_lattice(6);
  for (std::size_t g = 0; g < 12; ++g) p.grains.zone[g] = 1;  // two rows
  const Texture t = measure(p);
  EXPECT_EQ(value_of(t.numbers, "force/by_type/glued-glued/count"), 18);
  EXPECT_EQ(value_of(t.numbers, "force/by_type/dry-glued/count"), 12);
  EXPECT_EQ(value_of(t.numbers, "force/by_type/dry-dry/count"), 42);
  EXPECT_EQ(value_of(t.numbers, "sigma_norm/by_material/glued/count"), 12);
}

TEST(Threshold, SeparatesStrongFromWeakDirections) {
  Packing p = test::square_lattice(8);
  for (std::size_t c = 0; c < p.contacts.size(); ++c) p.contacts.fn[c] = std::abs(p.contacts.normal[c].y) > 0.5 ? 3 : 1;
  const Texture t = measure(p);  // mean 2, load along y
  const Numbers& curve = t.numbers["fabric"]["threshold"];
  ASSERT_EQ(curve["force"].size(), 41u);
  for (std::size_t k = 0; k < 41; ++k) {
    const double x = curve["force"][k].get<double>();
    if (x > 0.55 && x < 1.45) {
      EXPECT_NEAR(curve["a_c_below"][k].get<double>(), -2, 1e-12) << x;
      EXPECT_NEAR(curve["a_c_above"][k].get<double>(), 2, 1e-12) << x;
    } else if (x > 1.55) {
      EXPECT_NEAR(curve["a_c_below"][k].get<double>(), 0, 1e-12) << x;
      EXPECT_FALSE(curve["a_c_above"][k].is_known()) << x;
    }
  }
}

}  // namespace
}  // namespace arenite::texture
