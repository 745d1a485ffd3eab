#pragma once
#include <algorithm>
#include <cmath>
#include <vector>

#include "core/random.hpp"
#include "model/elasticity/disk_field.hpp"
#include "model/packing.hpp"
#include "thermal/inference/contact_forces.hpp"

namespace arenite::test {

/// How a picture is drawn from known forces. Everything is painted on a fine grid, blurred there and summed into
/// pixels: in another way than the inverse does, which knows no grid.
struct ThermoelasticDrawing {
  double pixel = 1.6e-3;
  double blur = 0.5;        ///< pixels
  double noise = 0.3e-3;    ///< K, of every pixel
  double stated_error = 0;  ///< K; 0: the noise
  int fine = 8;             ///< grid cells along a pixel
  elasticity::Traction traction = elasticity::Traction::point;
  double half_angle = 0.08;  ///< of arcs, rad
  Vec2 offset{0.31, -0.17};  ///< of the grid of pixels, pixels
  std::uint64_t seed = 1;
};

inline std::vector<elasticity::Disk> loaded_disks(const Packing& p, const ThermoelasticDrawing& drawing) {
  std::vector<elasticity::Disk> disks;
  for (std::size_t g = 0; g < p.grains.size(); ++g)
    disks.push_back({p.grains.radius[g], p.domain.thickness, {}, drawing.traction});
  for (std::size_t c = 0; c < p.contacts.size(); ++c) {
    const elasticity::RimForce f{p.contacts.normal[c], p.contacts.fn[c], p.contacts.ft[c], drawing.half_angle};
    disks[static_cast<std::size_t>(p.contacts.i[c])].forces.push_back(f);
    if (!p.contacts.is_wall(c))
      disks[static_cast<std::size_t>(p.contacts.j[c])].forces.push_back({-f.normal, f.fn, f.ft, f.half_angle});
  }
  return disks;
}

/// Weights of fine cells around a pixel's first one: a box of one pixel blurred by the lens.
inline std::vector<double> lens_weights(const ThermoelasticDrawing& d, int& before) {
  before = static_cast<int>(std::ceil(4 * d.blur * d.fine));
  std::vector<double> w(static_cast<std::size_t>(2 * before + d.fine), 0.0);
  double sum = 0;
  for (std::size_t k = 0; k < w.size(); ++k)
    for (int q = 0; q < d.fine; ++q) {
      const double u = (static_cast<double>(k) - before - q) / d.fine;
      w[k] += d.blur > 0 ? std::exp(-0.5 * u * u / (d.blur * d.blur)) : (u == 0 ? 1.0 : 0.0);
    }
  for (const double v : w) sum += v;
  for (double& v : w) v /= sum;
  return w;
}

/// The picture of a packing whose contacts hold peak-to-peak forces, four pixels wider on every side than the grains
/// need.
inline inference::ThermoelasticPicture draw_thermoelastic(const Packing& p, const std::vector<double>& factor,
                                                          const ThermoelasticDrawing& d) {
  const Grains& grains = p.grains;
  double x0 = 1e9, x1 = -1e9, y0 = 1e9, y1 = -1e9;
  for (std::size_t g = 0; g < grains.size(); ++g) {
    x0 = std::min(x0, grains.position[g].x - grains.radius[g]),
    x1 = std::max(x1, grains.position[g].x + grains.radius[g]);
    y0 = std::min(y0, grains.position[g].y - grains.radius[g]),
    y1 = std::max(y1, grains.position[g].y + grains.radius[g]);
  }
  inference::ThermoelasticPicture picture;
  picture.pixel = d.pixel;
  picture.width = static_cast<int>((x1 - x0) / d.pixel) + 9, picture.height = static_cast<int>((y1 - y0) / d.pixel) + 9;
  picture.first = {x0 + (d.offset.x - 4) * d.pixel, y1 + (d.offset.y + 4) * d.pixel};
  const int fw = picture.width * d.fine, fh = picture.height * d.fine;
  const double cell = d.pixel / d.fine;
  const Vec2 corner = picture.first + (0.5 * cell - 0.5 * d.pixel) * Vec2{1, -1};
  std::vector<double> fine(static_cast<std::size_t>(fw) * static_cast<std::size_t>(fh), 0.0), depth(fine.size(), 0.0);
  const std::vector<elasticity::Disk> disks = loaded_disks(p, d);
  for (std::size_t g = 0; g < grains.size(); ++g) {
    const double r = grains.radius[g], a = factor[static_cast<std::size_t>(grains.material[g])];
    const int c0 = static_cast<int>((grains.position[g].x - r - corner.x) / cell),
              c1 = static_cast<int>((grains.position[g].x + r - corner.x) / cell) + 1;
    const int r0 = static_cast<int>((corner.y - grains.position[g].y - r) / cell),
              r1 = static_cast<int>((corner.y - grains.position[g].y + r) / cell) + 1;
    for (int row = r0; row <= r1; ++row)
      for (int c = c0; c <= c1; ++c) {
        const Vec2 x = Vec2{corner.x + c * cell, corner.y - row * cell} - grains.position[g];
        const double inside = r - norm(x);
        const std::size_t k =
            static_cast<std::size_t>(row) * static_cast<std::size_t>(fw) + static_cast<std::size_t>(c);
        if (inside <= depth[k]) continue;  // the grain that holds the place deepest is seen
        depth[k] = inside;
        const bool close = inside < 2 * cell && d.traction == elasticity::Traction::point;
        fine[k] = -a * (close ? elasticity::square_mean(disks[g], x, cell) : elasticity::sigma_kk(disks[g], x));
      }
  }
  int before = 0;
  const std::vector<double> w = lens_weights(d, before);
  std::vector<double> half(static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(fh), 0.0);
  for (int row = 0; row < fh; ++row)
    for (int c = 0; c < picture.width; ++c)
      for (std::size_t k = 0; k < w.size(); ++k) {
        const int from = c * d.fine - before + static_cast<int>(k);
        if (from >= 0 && from < fw)
          half[static_cast<std::size_t>(row * picture.width + c)] +=
              w[k] * fine[static_cast<std::size_t>(row * fw + from)];
      }
  RandomStream random(d.seed, Purpose::test, 77);
  for (int row = 0; row < picture.height; ++row)
    for (int c = 0; c < picture.width; ++c) {
      double sum = 0;
      for (std::size_t k = 0; k < w.size(); ++k) {
        const int from = row * d.fine - before + static_cast<int>(k);
        if (from >= 0 && from < fh) sum += w[k] * half[static_cast<std::size_t>(from * picture.width + c)];
      }
      picture.value.push_back(static_cast<float>(sum + d.noise * random.normal()));
    }
  picture.error.assign(picture.value.size(), static_cast<float>(d.stated_error > 0 ? d.stated_error : d.noise));
  return picture;
}

}  // namespace arenite::test
