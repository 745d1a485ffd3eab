#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "io/sample/sample.hpp"
#include "support/pressed_crystal.hpp"
#include "support/thermoelastic_picture.hpp"
#include "thermal/inference/mean_forces.hpp"
#include "thermal/inference/pixel_forces.hpp"

/// The forces of another code (1024 disks under slow shear, friction coefficient 0.1, sheared periodic cell): inverted
/// from grain sums and from a picture, and compared with its own.
namespace arenite::inference {
namespace {

using test::relative_error, test::without_forces;

const std::string folder = std::string(ARENITE_SOURCE_DIR) + "/examples/20-dem-shear-periodic/";

Packing sheared() {
  io::SampleOptions o;
  o.box = {62.7755, 62.7755, 31.38775}, o.periodic[0] = o.periodic[1] = true, o.thickness = 1;
  Packing p = io::read_sample(folder + "grains-5000.csv", folder + "contacts-5000.csv", o).packing;
  p.materials = {{"disk", 1, 1, 1}};
  p.grains.material.assign(p.grains.size(), 0);
  return p;
}

std::vector<double> mean_stresses(const Packing& p) {
  std::vector<double> sigma(p.grains.size());
  for (std::size_t c = 0; c < p.contacts.size(); ++c) {
    sigma[static_cast<std::size_t>(p.contacts.i[c])] -= p.contacts.fn[c];
    sigma[static_cast<std::size_t>(p.contacts.j[c])] -= p.contacts.fn[c];
  }
  for (std::size_t g = 0; g < sigma.size(); ++g) sigma[g] /= 2 * std::numbers::pi * p.grains.radius[g];
  return sigma;
}

double mean_size(const std::vector<double>& v) {
  double sum = 0;
  for (const double x : v) sum += std::abs(x) / static_cast<double>(v.size());
  return sum;
}

double correlation(const std::vector<double>& a, const std::vector<double>& b) {
  double ma = 0, mb = 0, aa = 0, bb = 0, ab = 0;
  const auto n = static_cast<double>(a.size());
  for (std::size_t k = 0; k < a.size(); ++k) ma += a[k] / n, mb += b[k] / n;
  for (std::size_t k = 0; k < a.size(); ++k)
    aa += (a[k] - ma) * (a[k] - ma), bb += (b[k] - mb) * (b[k] - mb), ab += (a[k] - ma) * (b[k] - mb);
  return ab / std::sqrt(aa * bb);
}

TEST(ForcesOfAnotherCode, FollowFromGrainSums) {
  const Packing p = sheared();
  std::vector<double> sigma = mean_stresses(p);
  const std::vector<double> error(sigma.size(), 0.01 * mean_size(sigma));
  RandomStream random(1, Purpose::test);
  for (double& s : sigma) s += error[0] * random.normal();
  const InferredForces free = infer_from_means({without_forces(p), {}, {}}, sigma, error, {});
  EXPECT_EQ(free.null_space, 0);  // z = 3.8
  EXPECT_LT(relative_error(free.contacts.fn, p.contacts.fn), 0.10);
  EXPECT_GT(correlation(free.contacts.fn, p.contacts.fn), 0.98);
  ForceOptions options;
  options.inequality = Inequality::cone, options.friction = 0.1;
  const InferredForces f = infer_from_means({without_forces(p), {}, {}}, sigma, error, options);
  EXPECT_LT(relative_error(f.contacts.fn, p.contacts.fn), 0.03);
  EXPECT_LT(relative_error(f.contacts.ft, p.contacts.ft), 0.15);
}

/// The cell with all images of grains that show in it; contacts of images are there to load them.
Packing with_images(const Packing& p, double reach) {
  Packing all = p;
  for (int b = -1; b <= 1; ++b)
    for (int a = -2; a <= 2; ++a) {
      const Vec2 shift{a * p.domain.width() + b * p.domain.tilt, b * p.domain.height()};
      std::vector<std::int32_t> image(p.grains.size(), -1);
      for (std::size_t g = 0; (a || b) && g < p.grains.size(); ++g) {
        const Vec2 x = p.grains.position[g] + shift;
        if (std::abs(x.x) > reach || std::abs(x.y) > reach) continue;
        const std::size_t k = all.grains.size();
        image[g] = static_cast<std::int32_t>(k);
        all.grains.resize(k + 1);
        all.grains.position[k].x = x.x, all.grains.position[k].y = x.y, all.grains.radius[k] = p.grains.radius[g];
      }
      for (std::size_t c = 0; c < p.contacts.size(); ++c) {
        const auto i = image[static_cast<std::size_t>(p.contacts.i[c])],
                   j = image[static_cast<std::size_t>(p.contacts.j[c])];
        if (i >= 0)
          all.contacts.add(i, wall_partner(left), p.contacts.normal[c], p.contacts.fn[c], p.contacts.ft[c], 1, 0);
        if (j >= 0)
          all.contacts.add(j, wall_partner(left), -p.contacts.normal[c], p.contacts.fn[c], p.contacts.ft[c], 1, 0);
      }
    }
  return all;
}

TEST(ForcesOfAnotherCode, FollowFromAPicture) {
  const Packing p = sheared();
  test::ThermoelasticDrawing d;
  d.pixel = 0.3, d.fine = 4, d.noise = 0.01 * mean_size(mean_stresses(p));
  ThermoelasticPicture picture = test::draw_thermoelastic(with_images(p, 33.5), {1}, d);
  for (int r = 0; r < picture.height; ++r)
    for (int c = 0; c < picture.width; ++c) {
      const Vec2 x = picture.first + picture.pixel * Vec2{static_cast<double>(c), -static_cast<double>(r)};
      if (std::abs(x.x) > 31.4 || std::abs(x.y) > 31.4)
        picture.error[static_cast<std::size_t>(r * picture.width + c)] = 0;
    }
  ForceOptions options;
  options.iterations = 2;
  const InferredForces f = infer_from_pixels({without_forces(p), {1}, {}}, picture, options);
  EXPECT_LT(relative_error(f.contacts.fn, p.contacts.fn), 0.01);
  EXPECT_LT(relative_error(f.contacts.ft, p.contacts.ft), 0.08);
}

}  // namespace
}  // namespace arenite::inference
