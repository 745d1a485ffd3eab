#include "thermal/inference/pixel_equations.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/median.hpp"
#include "model/image.hpp"
#include "model/periodic_images.hpp"
#include "thermal/inference/grain_rows.hpp"

namespace arenite::inference {
namespace {

double to_contact(Vec2 x, double radius, const std::vector<Touch>& touches) {
  double nearest = 2 * radius;
  for (const Touch& t : touches) nearest = std::min(nearest, norm(x + radius * t.normal));
  return nearest;
}

PixelEquations equations_of(const Unknowns& unknowns, const Placed& placed, std::size_t g,
                            const std::vector<GrainPixel>& pixels, const PointSpread& spread, double contact_margin) {
  const auto& touches = placed.touches[g];
  const std::size_t z = touches.size();
  const GrainRows found = rows_of_grain(placed, g, pixels, spread);
  PixelEquations b{columns_of(unknowns, g, touches), {}, {}, {}, {}, pixels};
  const std::size_t factors = b.columns.size();
  if (unknowns.own_factors > 0) b.columns.push_back(unknowns.own_factor(g));
  if (unknowns.scales > 0) b.columns.push_back(unknowns.scale(static_cast<std::size_t>(placed.material[g])));
  const std::size_t end = b.columns.size();
  if (unknowns.shift > 0) b.columns.push_back(unknowns.common_shift());
  const std::size_t n = b.columns.size();
  b.rows.assign(n * pixels.size(), 0.0);
  const double signal = root_mean_square(pixels);
  for (std::size_t q = 0; q < pixels.size(); ++q) {
    double* row = &b.rows[n * q];
    double warming = 0;
    for (std::size_t k = 0; k < 2 * z; ++k) {
      row[k] = unknowns.force * found.response(k, q);
      warming += found.response(k, q) * touches[k / 2].of_contact(placed.force, k % 2);
    }
    if (unknowns.move > 0) {
      row[2 * z] += unknowns.move * found.shift[q].x, row[2 * z + 1] += unknowns.move * found.shift[q].y;
      for (std::size_t k = 0; k < z; ++k) add_turn(unknowns, touches, k, found.turn(k, q), row);
    }
    // A hundredth more factor is a hundredth more warming by the present forces.
    for (std::size_t k = factors; k < end; ++k) row[k] = warming;
    for (std::size_t k = end; k < n; ++k) row[k] = unknowns.shift;
    const double close = std::max(1.0, contact_margin / pixels[q].to_contact);
    b.model.push_back(signal * close * close * close);
    b.right.push_back(pixels[q].value - found.spill[q]);
  }
  return b;
}

}  // namespace

Pixels pixels_of_grains(const ThermoelasticPicture& picture, const Packing& packing, const Touches& touches,
                        double rim_margin, double contact_margin) {
  const double side = picture.pixel;
  const Vec2 first = picture.first;
  const geometry::Rectangle window{first.x, first.x + (picture.width - 1) * side, first.y - (picture.height - 1) * side,
                                   first.y};
  Pixels pixels(packing.grains.size());
  for (std::size_t g = 0; g < pixels.size(); ++g) {
    const double radius = packing.grains.radius[g], inner = radius - rim_margin * side;
    if (inner <= 0) continue;
    const auto [x0, y0] = packing.grains.position[g];
    for_each_image(
        packing.domain, {x0 - radius, x0 + radius, y0 - radius, y0 + radius}, window, [&](const ImageShift& image) {
          const Vec2 centre = packing.grains.position[g] + image.shift;
          const double column = (centre.x - first.x) / side, row = (first.y - centre.y) / side, reach = inner / side;
          each_pixel_near({column, row}, reach, picture.width, picture.height, [&](int c, int r, std::size_t p) {
            const Vec2 x = Vec2{first.x + c * side, first.y - r * side} - centre;
            const float value = picture.value[p], error = picture.error[p];
            if (norm(x) > inner || !std::isfinite(value) || !std::isfinite(error) || !(error > 0)) return;
            const double away = to_contact(x, radius, touches[g]);
            if (away >= 0.5 * contact_margin * side) pixels[g].push_back({x, value, error, away, p});
          });
        });
  }
  return pixels;
}

double root_mean_square(const std::vector<GrainPixel>& pixels) {
  double sum = 0;
  for (const GrainPixel& p : pixels) sum += static_cast<double>(p.value) * p.value;
  return pixels.empty() ? 0 : std::sqrt(sum / static_cast<double>(pixels.size()));
}

double PixelEquations::left(std::size_t q, const std::vector<double>& x) const {
  double left = right[q];
  for (std::size_t k = 0; k < columns.size(); ++k)
    left -= rows[q * columns.size() + k] * x[static_cast<std::size_t>(columns[k])];
  return left;
}

std::vector<PixelEquations> pixel_equations(const Unknowns& unknowns, const Placed& placed, const Pixels& pixels,
                                            const PointSpread& spread, double contact_margin, const ThreadPool& pool) {
  std::vector<std::size_t> seen;
  for (std::size_t g = 0; g < pixels.size(); ++g)
    if (!pixels[g].empty() && !placed.touches[g].empty()) seen.push_back(g);
  std::vector<PixelEquations> all(seen.size());
  pool.for_ranges(seen.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k)
      all[k] = equations_of(unknowns, placed, seen[k], pixels[seen[k]], spread, contact_margin);
  });
  return all;
}

void weigh(std::vector<PixelEquations>& equations, double model_error, const std::vector<double>& x, double most) {
  for (PixelEquations& b : equations) {
    b.weight.resize(b.right.size());
    for (std::size_t q = 0; q < b.right.size(); ++q) {
      const double weight = 1 / (squared(static_cast<double>(b.pixels[q].error)) + squared(model_error * b.model[q]));
      const double off = most > 0 ? std::abs(b.left(q, x)) * std::sqrt(weight) : 0;
      b.weight[q] = off > most ? weight * most / off : weight;
    }
  }
}

Misfit misfit(const std::vector<PixelEquations>& equations, const std::vector<double>& x, double model_error,
              double taken, double most) {
  Misfit m;
  double count = 0;
  std::vector<double> off, signal;
  for (const PixelEquations& b : equations)
    for (std::size_t q = 0; q < b.right.size(); ++q, count += 1) {
      const double left = b.left(q, x), noise = squared(static_cast<double>(b.pixels[q].error));
      const double weighed = left * left / (noise + squared(model_error * b.model[q]));
      m.weighed += most > 0 ? std::min(weighed, most * most) : weighed;
      m.over_noise += left * left / noise;
      off.push_back(std::abs(left)), signal.push_back(std::abs(static_cast<double>(b.pixels[q].value)));
    }
  const double freedom = std::max({1.0, 0.1 * count, count - taken});
  m.weighed /= freedom, m.over_noise /= freedom;
  if (most > 0) {  // of normal numbers, what is left of their squares where each is cut
    const double beyond = std::erfc(most / std::numbers::sqrt2),
                 density = std::exp(-0.5 * most * most) / std::sqrt(2 * std::numbers::pi);
    m.weighed /= 1 - beyond - 2 * most * density + most * most * beyond;
  }
  const double middle = median(std::move(signal));
  m.over_signal = middle > 0 ? median(std::move(off)) / middle : 0;
  return m;
}

}  // namespace arenite::inference
