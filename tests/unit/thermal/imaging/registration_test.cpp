#include "thermal/imaging/registration.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <tuple>

#include "core/random.hpp"
#include "support/drawn_picture.hpp"
#include "support/pictures.hpp"

namespace {
using namespace arenite;
using imaging::Mirror;
using imaging::register_circles;
using imaging::Similarity;

/// Grains of a packing as a search gives them.
PictureGrains found(const char* sample) {
  PictureGrains grains;
  for (const auto& d : test::packing_in_pixels(sample, 1.6e-3, 50, 228)) {
    grains.centre.push_back({d.x, d.y});
    grains.radius.push_back(d.radius);
  }
  return grains;
}

struct Flaws {
  double missing = 0, invented = 0, error = 0, radius_error = 0;  ///< shares; pixels; share
  std::uint64_t seed = 1;
};

/// The grains as another search of the same sample might give them; `truth` gets the index each had, -1 for an invented
/// one.
PictureGrains spoiled(const PictureGrains& grains, const Flaws& how, std::vector<int>& truth) {
  RandomStream random(how.seed, Purpose::test);
  PictureGrains out;
  const auto add = [&](double x, double y, double r, int of) {
    out.centre.push_back({x + how.error * random.normal(), y + how.error * random.normal()});
    out.radius.push_back(r * (1 + how.radius_error * random.normal()));
    truth.push_back(of);
  };
  for (std::size_t k = grains.size(); k-- > 0;) {
    if (random.uniform() < how.invented) {
      const double y = 240 * random.uniform();
      add(320 * random.uniform(), y, grains.radius[k], -1);
    }
    if (random.uniform() >= how.missing)
      add(grains.centre[k].x, grains.centre[k].y, grains.radius[k], static_cast<int>(k));
  }
  return out;
}

void expect_alike(const Similarity& a, const Similarity& b, double within) {
  EXPECT_EQ(a.mirrored, b.mirrored);
  for (const Vec2 corner : {Vec2{0, 0}, Vec2{320, 0}, Vec2{0, 240}, Vec2{320, 240}})
    EXPECT_LT(norm(a(corner) - b(corner)), within);
}

TEST(Similarity, InverseAndFitGiveItBack) {
  for (const bool mirrored : {false, true}) {
    const Similarity t{1.7, 2.1, {30, -8}, mirrored};
    const std::vector<Vec2> places{{1, 2}, {40, 3}, {17, 60}};
    std::vector<Vec2> moved;
    for (const Vec2 p : places) {
      moved.push_back(t(p));
      EXPECT_LT(norm(t.inverse()(t(p)) - p), 1e-12);
    }
    expect_alike(imaging::fit_similarity(places, moved, mirrored), t, 1e-10);
  }
  // From +x to +y, and x turned round before.
  EXPECT_LT(norm(Similarity{2, std::numbers::pi / 2, {1, 0}, false}({3, 0}) - Vec2{1, 6}), 1e-12);
  EXPECT_LT(norm(Similarity{2, std::numbers::pi / 2, {1, 0}, true}({3, 0}) - Vec2{1, -6}), 1e-12);
}

TEST(Similarity, ScalesRadiiAndErrorsOfGrainsAndKeepsTheRest) {
  PictureGrains grains;
  grains.centre = {{3, 0}};
  grains.radius = {5};
  grains.radius_error = {0.1};
  grains.material = {1};
  const PictureGrains moved = imaging::apply({2, std::numbers::pi / 2, {1, 0}, false}, grains);
  EXPECT_NEAR(moved.centre[0].y, 6, 1e-12);
  EXPECT_EQ(moved.radius[0], 10);
  EXPECT_EQ(moved.radius_error[0], 0.2);
  EXPECT_EQ(moved.material, grains.material);
  EXPECT_TRUE(moved.position_error.empty());
}

class Registered : public ::testing::TestWithParam<const char*> {};

TEST_P(Registered, WithoutAGuessThoughGrainsAreMissingInventedAndOff) {
  const PictureGrains thermal = found(GetParam());
  RandomStream random(17, Purpose::test);
  for (int round = 0; round < 3; ++round) {
    const Similarity truth{std::exp(random.uniform(-1.5, 1.5)),
                           random.uniform(-3, 3),
                           {300 * random.uniform(), -200 * random.uniform()},
                           round % 3 == 0};
    std::vector<int> of_a, of_b;
    const auto seed = static_cast<std::uint64_t>(round) + 1;
    const PictureGrains optical = spoiled(
        imaging::apply(truth.inverse(), thermal),
        {.missing = 0.1, .invented = 0.03, .error = 0.03 / truth.scale, .radius_error = 0.02, .seed = seed}, of_a);
    const PictureGrains hot = spoiled(
        thermal, {.missing = 0.1, .invented = 0.03, .error = 0.05, .radius_error = 0.02, .seed = seed + 100}, of_b);
    const imaging::Registration r = register_circles(
        optical, hot, {.mirror = round % 2 == 0 ? Mirror::found : (truth.mirrored ? Mirror::yes : Mirror::no)});
    expect_alike(r.transform, truth, 0.05);
    EXPECT_GT(r.matched, 0.85);
    EXPECT_NEAR(r.rms, std::hypot(0.03, 0.05), 0.006);
    EXPECT_LT(std::abs(r.transform.scale - truth.scale), 4 * r.scale_error);
    EXPECT_LT(std::abs(std::remainder(r.transform.rotation - truth.rotation, 2 * std::numbers::pi)),
              4 * r.rotation_error);
    for (const auto& [a, b] : r.pairs) EXPECT_EQ(of_a[static_cast<std::size_t>(a)], of_b[static_cast<std::size_t>(b)]);
  }
}

TEST_P(Registered, WithAGuessOfScaleAndWithoutRadii) {
  const PictureGrains thermal = found(GetParam());
  const Similarity truth{0.4, 0.02, {-5, 12}, false};
  std::vector<int> of;
  PictureGrains optical = spoiled(imaging::apply(truth.inverse(), thermal), {.missing = 0.1, .error = 0.1}, of);
  for (double& r : optical.radius) r = 12;
  const imaging::Registration r =
      register_circles(optical, thermal, {.scale = 0.41, .scale_within = 0.05, .radius_within = 0});
  expect_alike(r.transform, truth, 0.05);
  EXPECT_GT(r.matched, 0.97);
}

INSTANTIATE_TEST_SUITE_P(Of, Registered, ::testing::Values("sample-02", "sample-08", "sample-12"),
                         [](const auto& one) { return std::string(one.param).substr(7); });

TEST(Registration, FindsAPartInTheWhole) {
  const PictureGrains whole = found("sample-08");
  const Similarity truth{2.5, -1.2, {100, 40}, false};
  PictureGrains part;
  for (std::size_t k = 0; k < whole.size(); ++k)
    if (whole.centre[k].x < 150 && whole.centre[k].y < 130) {
      part.centre.push_back(whole.centre[k]);
      part.radius.push_back(whole.radius[k]);
    }
  ASSERT_LT(part.size(), whole.size() / 3);
  expect_alike(register_circles(part, imaging::apply(truth, whole)).transform, truth, 1e-6);
  expect_alike(register_circles(imaging::apply(truth, whole), part).transform, truth.inverse(), 1e-6);
}

TEST(Registration, OfFourGrains) {
  PictureGrains four;
  four.centre = {{10, 10}, {31, 12}, {22, 33}, {47, 40}};
  four.radius = {6, 6, 8, 9};
  const Similarity truth{1.3, 0.4, {7, 9}, false};
  const imaging::Registration r = register_circles(four, imaging::apply(truth, four));
  expect_alike(r.transform, truth, 1e-6);
  EXPECT_EQ(r.pairs.size(), 4u);
}

TEST(Registration, RefusesPicturesOfDifferentSamples) {
  const std::string text = test::complaint([] { register_circles(found("sample-02"), found("sample-12")); });
  EXPECT_NE(text.find("do not match"), std::string::npos) << text;
  PictureGrains two;
  two.centre = {{1, 1}, {2, 2}};
  two.radius = {1, 2};
  EXPECT_NE(test::complaint([&] {
              register_circles(found("sample-12"), two);
            }).find("the second picture shows 2 grains; three are needed"),
            std::string::npos);
  EXPECT_NE(test::complaint([&] {
              register_circles(found("sample-12"), found("sample-12"), {.scale = -1.0});
            }).find("must be positive"),
            std::string::npos);
}

}  // namespace
