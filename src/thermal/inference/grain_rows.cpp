#include "thermal/inference/pixel_equations.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/mapped.hpp"

namespace arenite::inference {
namespace {

/// One axis of a box of side 1 blurred by a Gaussian, and its derivative.
struct Profile {
  double value, slope;
};

Profile profile(double u, double blur) {
  if (blur <= 0) return {std::abs(u) < 0.5 ? 1.0 : 0.0, 0.0};
  const double scale = 1 / (std::numbers::sqrt2 * blur), a = (u + 0.5) * scale, b = (u - 0.5) * scale;
  return {0.5 * (std::erf(a) - std::erf(b)), scale / std::sqrt(std::numbers::pi) * (std::exp(-a * a) - std::exp(-b * b))};
}

/// sigma_kk inside a grain by its touches (elasticity/disk_field.hpp), written for speed. As complex numbers, with the
/// normal n of a touch, rho = x + R n and q = 1/rho, a force F adds -2/(pi L) Re(F q); moved points and turned normals
/// follow from q^2.
class GrainField {
 public:
  GrainField(double radius, double length, const std::vector<Touch>& touches, const std::vector<double>& force)
      : scale_(1 / (std::numbers::pi * length)),
        over_radius_(1 / radius) {
    for (const Touch& t : touches) touches_.push_back({t.normal, radius * t.normal, t.force_of(force), t.of_contact(force, 0)});
  }

  std::size_t size() const { return touches_.size(); }

  /// sigma_kk under the present forces, Pa.
  double value(Vec2 x) const {
    double sum = 0;
    for (const Pull& t : touches_) {
      const Vec2 rho = x + t.back;
      sum += t.fn * over_radius_ - 2 * dot(t.force, rho) / dot(rho, rho);
    }
    return scale_ * sum;
  }

  /// Adds weight times sigma_kk per newton of every touch's fn and ft to `row` (2 a touch), and times its change per
  /// radian by which a normal turns, its force with it, to `turn`; returns sigma_kk.
  double add(Vec2 x, double weight, double* row, double* turn) const {
    const double w = scale_ * weight;
    double sum = 0;
    for (std::size_t k = 0; k < touches_.size(); ++k) {
      const Pull& t = touches_[k];
      const Vec2 rho = x + t.back;
      const double inverse = 1 / dot(rho, rho), qx = rho.x * inverse, qy = -rho.y * inverse;
      const double along = t.normal.x * qx - t.normal.y * qy, across = t.normal.x * qy + t.normal.y * qx;  // n q
      row[2 * k] += w * (over_radius_ - 2 * along);
      row[2 * k + 1] += 2 * w * across;
      const double fx = t.force.x * qx - t.force.y * qy, fy = t.force.x * qy + t.force.y * qx;  // F q
      const double xx = x.x * qx - x.y * qy, xy = x.x * qy + x.y * qx;                          // x q
      turn[k] += 2 * w * (fx * xy + fy * xx);
      sum += t.fn * over_radius_ - 2 * fx;
    }
    return scale_ * sum;
  }

  /// Gradient of sigma_kk, Pa/m.
  Vec2 gradient(Vec2 x) const {
    Vec2 sum;
    for (const Pull& t : touches_) {
      const Vec2 rho = x + t.back;
      const double inverse = 1 / dot(rho, rho), qx = rho.x * inverse, qy = -rho.y * inverse;
      const double fx = t.force.x * qx - t.force.y * qy, fy = t.force.x * qy + t.force.y * qx;
      sum += Vec2{fx * qx - fy * qy, -(fx * qy + fy * qx)};
    }
    return 2 * scale_ * sum;
  }

 private:
  struct Pull {
    Vec2 normal, back, force;
    double fn;
  };
  double scale_, over_radius_;
  std::vector<Pull> touches_;
};

/// What a pixel sees of a grain, Pa.
double seen_of(const GrainField& field, double radius, Vec2 from_centre, const PointSpread& spread) {
  const double away = norm(from_centre);
  if (away >= radius + spread.reach) return 0;
  if (away + spread.reach <= radius) return field.value(from_centre);  // harmonic
  double sum = 0;
  for (const PointSpread::Point& p : spread.points) {
    const Vec2 x = from_centre + p.place;
    if (dot(x, x) < radius * radius) sum += p.weight * field.value(x);
  }
  return sum;
}

GrainField field_of(const Placed& placed, std::size_t g) { return {placed.radius[g], placed.length, placed.touches[g], placed.force}; }

/// A grain and those that may spill light over to its pixels.
struct Neighbourhood {
  const Placed& placed;
  const PointSpread& spread;
  std::size_t grain;
  GrainField field;
  std::vector<GrainField> others;

  Neighbourhood(const Placed& p, std::size_t g, const PointSpread& s) : placed(p), spread(s), grain(g), field(field_of(p, g)) {
    for (const Near& n : p.near[g]) others.push_back(field_of(p, n.grain));
  }
  Vec2 from_centre(const GrainPixel& pixel) const { return pixel.place + placed.found[grain] - placed.centre[grain]; }
  /// Warming that a pixel sees of the others, K.
  double spill(Vec2 x) const {
    double sum = 0;
    for (std::size_t o = 0; o < others.size(); ++o) {
      const Near& n = placed.near[grain][o];
      const Vec2 from_other = x + placed.centre[grain] - placed.centre[n.grain] - n.cells;
      sum -= placed.factor[n.grain] * seen_of(others[o], placed.radius[n.grain], from_other, spread);
    }
    return sum;
  }
};

/// One pixel of the grain itself: a pixel that sees nothing else sees a harmonic field as in its centre. The centre moves
/// by d: a point of the grain is then seen at a place d farther, where the pixel's weight is slope.d larger.
void fill_row(const GrainField& field, double radius, Vec2 x, const PointSpread& spread, double* row, double* turn, Vec2& shift) {
  if (norm(x) + spread.reach <= radius) {
    field.add(x, 1, row, turn);
    shift = -field.gradient(x);
    return;
  }
  for (const PointSpread::Point& p : spread.points) {
    const Vec2 y = x + p.place;
    if (dot(y, y) < radius * radius) shift += field.add(y, p.weight, row, turn) * p.slope;
  }
}

}  // namespace

PointSpread::PointSpread(double pixel, double blur) {
  constexpr double step = 0.25, least = 2e-4;  // least: share of the largest weight
  const int n = static_cast<int>(std::ceil((0.5 + 3 * blur) / step));
  double sum = 0;
  for (int r = -n; r < n; ++r)
    for (int c = -n; c < n; ++c) {
      const Vec2 place{(c + 0.5) * step, (r + 0.5) * step};
      const Profile x = profile(place.x, blur), y = profile(place.y, blur);
      if (x.value * y.value < least) continue;
      points.push_back({pixel * place, x.value * y.value, (1 / pixel) * Vec2{x.slope * y.value, x.value * y.slope}});
      sum += x.value * y.value;
      reach = std::max(reach, pixel * norm(place));
    }
  for (Point& p : points) p.weight /= sum, p.slope = (1 / sum) * p.slope;
}

GrainRows rows_of_grain(const Placed& placed, std::size_t g, const std::vector<GrainPixel>& pixels, const PointSpread& spread) {
  const Neighbourhood around(placed, g, spread);
  const std::size_t z = around.field.size();
  const double factor = -placed.factor[g];
  GrainRows rows{{2 * z, pixels.size()}, std::vector<double>(pixels.size()), std::vector<Vec2>(pixels.size()), {z, pixels.size()}};
  for (std::size_t q = 0; q < pixels.size(); ++q) {
    const Vec2 x = around.from_centre(pixels[q]);
    double *row = rows.response.column(q), *turn = rows.turn.column(q);
    fill_row(around.field, placed.radius[g], x, spread, row, turn, rows.shift[q]);
    for (std::size_t k = 0; k < 2 * z; ++k) row[k] *= factor;
    for (std::size_t k = 0; k < z; ++k) turn[k] *= factor;
    rows.shift[q] = factor * rows.shift[q];
    rows.spill[q] = around.spill(x);
  }
  return rows;
}

std::vector<double> warming_of_grain(const Placed& placed, std::size_t g, const std::vector<GrainPixel>& pixels, const PointSpread& spread) {
  const Neighbourhood around(placed, g, spread);
  return mapped(pixels, [&](const GrainPixel& pixel) {
    const Vec2 x = around.from_centre(pixel);
    return around.spill(x) - placed.factor[g] * seen_of(around.field, placed.radius[g], x, spread);
  });
}

}  // namespace arenite::inference
