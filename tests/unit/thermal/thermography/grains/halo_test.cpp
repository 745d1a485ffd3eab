#include "thermal/thermography/grains/halo.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/random.hpp"

namespace arenite::thermography {
namespace {

/// Rows of disks of two levels before a darker background, warming unevenly with the load, in twelve phases; a share of
/// the light goes astray.
struct Scene {
  int width = 96, height = 84;
  double radius = 6, contrast = 1.5, share = 0, halo_width = 4, noise = 2e-3;

  PictureGrains grains() const {
    PictureGrains g;
    for (int row = 0; row < 6; ++row)
      for (int k = 0; k < 7; ++k) {
        g.centre.push_back({9 + 12.1 * k + 6 * (row % 2), 9 + 12.1 * 0.9 * row});
        g.radius.push_back(radius);
      }
    return g;
  }

  std::vector<double> bare(double load) const {
    std::vector<double> picture(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 0.0);
    const PictureGrains g = grains();
    for (std::size_t i = 0; i < g.size(); ++i)
      each_pixel_near(g.centre[i], radius + 3, width, height, [&](int x, int y, std::size_t p) {
        const Vec2 away = Vec2{1.0 * x, 1.0 * y} - g.centre[i];
        const double inside = 0.5 * std::erfc((norm(away) - radius) / 0.8);
        picture[p] += inside * (contrast * (i % 2 == 0 ? 1 : 0.8) + 0.02 * load * (1 + away.x / radius));
      });
    return picture;
  }

  std::vector<double> seen(double load) const {
    const std::vector<double> picture = bare(load);
    std::vector<double> out(picture.size());
    const auto at = [&](int x, int y) {
      return picture[static_cast<std::size_t>(std::clamp(y, 0, height - 1) * width + std::clamp(x, 0, width - 1))];
    };
    const int reach = static_cast<int>(4 * halo_width);
    std::vector<double> weight;
    double all = 0;
    for (int k = -reach; k <= reach; ++k)
      weight.push_back(std::exp(-0.5 * k * k / (halo_width * halo_width))), all += weight.back();
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) {
        double sum = 0;
        for (int j = -reach; j <= reach; ++j)
          for (int i = -reach; i <= reach; ++i)
            sum += weight[static_cast<std::size_t>(i + reach)] * weight[static_cast<std::size_t>(j + reach)] *
                   at(x + i, y + j);
        out[static_cast<std::size_t>(y * width + x)] = (1 - share) * at(x, y) + share * sum / (all * all);
      }
    return out;
  }

  PhasePictures pictures() const {
    constexpr std::size_t parts = 12;
    PhasePictures result{width, height, std::vector<double>(parts, 30.0), {}, {}};
    RandomStream random(3, Purpose::test, 41);
    const std::vector<double> level = seen(0), warm = seen(1);
    for (std::size_t k = 0; k < parts; ++k) {
      const double phase = 2 * std::numbers::pi * static_cast<double>(k) / parts;
      Harmonics h{};
      h[0] = 1, h[1] = std::cos(phase), h[2] = std::sin(phase);
      result.phases.push_back(h);
      std::vector<float> picture;
      for (std::size_t p = 0; p < level.size(); ++p)
        picture.push_back(static_cast<float>(level[p] + 0.5 * (1 + std::cos(phase)) * (warm[p] - level[p]) +
                                             noise * random.normal()));
      spline_coefficients(picture.data(), width, height);
      result.spline.insert(result.spline.end(), picture.begin(), picture.end());
    }
    return result;
  }
};

TEST(Halo, IsFoundInTheInnerPixelsOfGrains) {
  for (const double share : {0.05, 0.2}) {
    Scene scene;
    scene.share = share;
    const Halo halo = halo_of(scene.pictures(), scene.grains(), 0);
    EXPECT_NEAR(halo.share, share, 0.1 * share);
    EXPECT_EQ(halo.width, 4);
    EXPECT_LT(halo.error, 0.05 * share);
  }
}

TEST(Halo, IsNotInventedWhereThereIsNone) {
  EXPECT_EQ(halo_of(Scene{}.pictures(), Scene{}.grains(), 0).share, 0);
  Scene even;
  even.contrast = 0, even.share = 0.2;  // an isothermal sample says nothing of it
  EXPECT_EQ(halo_of(even.pictures(), even.grains(), 0).share, 0);
  Scene fine;
  fine.share = 0.2;
  PictureGrains small = fine.grains();
  for (double& r : small.radius) r = 2.4;
  EXPECT_EQ(halo_of(fine.pictures(), small, 0).share, 0);
}

TEST(Halo, TakenOffLeavesThePictureWithout) {
  Scene scene;
  scene.share = 0.2, scene.noise = 0;
  PhasePictures pictures = scene.pictures();
  remove_halo({0.2, 4, 0}, pictures);
  const std::vector<double> bare = scene.bare(1);
  const std::vector<float> left = picture_of(pictures, 0);
  double off = 0, with = 0;
  const std::vector<double> seen = scene.seen(1);
  for (int y = 20; y < 60; ++y)  // beyond the picture nothing is known
    for (int x = 20; x < 70; ++x) {
      const auto p = static_cast<std::size_t>(y * scene.width + x);
      off = std::max(off, std::abs(static_cast<double>(left[p]) - bare[p])),
      with = std::max(with, std::abs(seen[p] - bare[p]));
    }
  EXPECT_LT(off, 0.02 * with);
}

}  // namespace
}  // namespace arenite::thermography
