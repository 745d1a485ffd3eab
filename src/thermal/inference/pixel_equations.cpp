#include "thermal/inference/pixel_equations.hpp"

#include <algorithm>
#include <cmath>

#include "core/median.hpp"
#include "model/image.hpp"

namespace arenite::inference {
namespace {

/// Shifts by whole cells that may bring a grain into the picture.
std::vector<Vec2> images(const Domain& domain) {
  std::vector<Vec2> shifts;
  const int nx = domain.periodic[0] ? 1 : 0, ny = domain.periodic[1] ? 1 : 0;
  for (int b = -ny; b <= ny; ++b)
    for (int a = -nx - (b ? nx : 0); a <= nx + (b ? nx : 0); ++a) shifts.push_back({a * domain.width() * nx + b * domain.tilt, b * domain.height() * ny});
  return shifts;
}

double to_contact(Vec2 x, double radius, const std::vector<Touch>& touches) {
  double nearest = 2 * radius;
  for (const Touch& t : touches) nearest = std::min(nearest, norm(x + radius * t.normal));
  return nearest;
}

PixelEquations equations_of(const Unknowns& unknowns, const Placed& placed, std::size_t g, const std::vector<GrainPixel>& pixels, const PointSpread& spread,
                            double model_error, double contact_margin) {
  const auto& touches = placed.touches[g];
  const std::size_t z = touches.size();
  const GrainRows found = rows_of_grain(placed, g, pixels, spread);
  PixelEquations b{columns_of(unknowns, g, touches), {}, {}, {}, {}, {}};
  if (unknowns.scales > 0) b.columns.push_back(unknowns.scale(static_cast<std::size_t>(placed.material[g])));
  const std::size_t n = b.columns.size();
  b.rows.assign(n * pixels.size(), 0.0);
  const double signal = root_mean_square(pixels);
  for (std::size_t q = 0; q < pixels.size(); ++q) {
    double* row = &b.rows[n * q];
    for (std::size_t k = 0; k < 2 * z; ++k) row[k] = unknowns.force * found.response(k, q);
    if (unknowns.move > 0) {
      row[2 * z] += unknowns.move * found.shift[q].x, row[2 * z + 1] += unknowns.move * found.shift[q].y;
      for (std::size_t k = 0; k < z; ++k) add_turn(unknowns, touches, k, found.turn(k, q), row);
    }
    if (unknowns.scales > 0)  // factors of the present forces: a hundredth more factor is a hundredth more warming
      for (std::size_t k = 0; k < 2 * z; ++k) row[n - 1] += found.response(k, q) * touches[k / 2].of_contact(placed.force, k % 2);
    const double error = pixels[q].error, close = std::max(1.0, contact_margin / pixels[q].to_contact);
    const double model = model_error * signal * close * close * close;
    b.right.push_back(pixels[q].value - found.spill[q]);
    b.weight.push_back(1 / (error * error + model * model));
    b.value.push_back(pixels[q].value);
    b.noise.push_back(error);
  }
  return b;
}

}  // namespace

Pixels pixels_of_grains(const ThermoelasticPicture& picture, const Packing& packing, const Touches& touches, double rim_margin, double contact_margin) {
  const double side = picture.pixel;
  Pixels pixels(packing.grains.size());
  const std::vector<Vec2> shifts = images(packing.domain);
  for (std::size_t g = 0; g < pixels.size(); ++g) {
    const double radius = packing.grains.radius[g], inner = radius - rim_margin * side;
    if (inner <= 0) continue;
    for (const Vec2 shift : shifts) {
      const Vec2 centre = packing.grains.position[g] + shift;
      const double column = (centre.x - picture.first.x) / side, row = (picture.first.y - centre.y) / side, reach = inner / side;
      each_pixel_near({column, row}, reach, picture.width, picture.height, [&](int c, int r, std::size_t p) {
        const Vec2 x = Vec2{picture.first.x + c * side, picture.first.y - r * side} - centre;
        const float value = picture.value[p], error = picture.error[p];
        if (norm(x) > inner || !std::isfinite(value) || !std::isfinite(error) || !(error > 0)) return;
        const double away = to_contact(x, radius, touches[g]);
        if (away >= 0.5 * contact_margin * side) pixels[g].push_back({x, value, error, away, p});
      });
    }
  }
  return pixels;
}

double root_mean_square(const std::vector<GrainPixel>& pixels) {
  double sum = 0;
  for (const GrainPixel& p : pixels) sum += static_cast<double>(p.value) * p.value;
  return pixels.empty() ? 0 : std::sqrt(sum / static_cast<double>(pixels.size()));
}

Misfit misfit(const std::vector<PixelEquations>& equations, const std::vector<double>& x, double taken) {
  Misfit m;
  double count = 0;
  std::vector<double> off, signal;
  for (const PixelEquations& b : equations)
    for (std::size_t q = 0; q < b.right.size(); ++q, count += 1) {
      double left = b.right[q];
      for (std::size_t k = 0; k < b.columns.size(); ++k) left -= b.rows[q * b.columns.size() + k] * x[static_cast<std::size_t>(b.columns[k])];
      m.weighed += left * left * b.weight[q];
      m.over_noise += left * left / (b.noise[q] * b.noise[q]);
      off.push_back(std::abs(left)), signal.push_back(std::abs(b.value[q]));
    }
  const double freedom = std::max({1.0, 0.1 * count, count - taken});
  m.weighed /= freedom, m.over_noise /= freedom;
  const double middle = median(std::move(signal));
  m.over_signal = middle > 0 ? median(std::move(off)) / middle : 0;
  return m;
}

std::vector<PixelEquations> add_pixels(ForceEquations& equations, const Placed& placed, const Pixels& pixels, const PointSpread& spread, double model_error,
                                       double contact_margin) {
  std::vector<PixelEquations> all;
  for (std::size_t g = 0; g < pixels.size(); ++g) {
    if (pixels[g].empty() || placed.touches[g].empty()) continue;
    const PixelEquations& own = all.emplace_back(equations_of(equations.unknowns, placed, g, pixels[g], spread, model_error, contact_margin));
    equations.add(own.columns, own.rows, own.right, own.weight);
  }
  return all;
}

}  // namespace arenite::inference
