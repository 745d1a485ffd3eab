#include "thermal/inference/grain_rows.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

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
  return {0.5 * (std::erf(a) - std::erf(b)),
          scale / std::sqrt(std::numbers::pi) * (std::exp(-a * a) - std::exp(-b * b))};
}

/// Two points side by side: as many as every processor computes at once.
using Two = double __attribute__((vector_size(16)));

double sum_of(const Two& v) { return v[0] + v[1]; }

Vec2 product(Vec2 a, Vec2 b) { return {a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x}; }

/// The points of a pixel, two by two, of which at least one lies in a grain; the other, where it does not, is in its
/// centre without weight.
class PointsInside {
 public:
  struct Points {
    Two x{}, y{}, weight{}, slope_x{}, slope_y{};
  };
  const double reach;

  explicit PointsInside(const PointSpread& spread)
      : reach(spread.reach),
        all_((spread.points.size() + 1) / 2),
        inside_(all_.size() + 1) {
    for (std::size_t n = 0; n < spread.points.size(); ++n) {
      const PointSpread::Point& from = spread.points[n];
      Points& p = all_[n / 2];
      const std::size_t lane = n % 2;
      p.x[lane] = from.place.x, p.y[lane] = from.place.y, p.weight[lane] = from.weight, p.slope_x[lane] = from.slope.x,
      p.slope_y[lane] = from.slope.y;
    }
  }

  std::span<const Points> operator()(Vec2 from_centre, double radius) {
    constexpr Two none{};
    std::size_t n = 0;
    for (const Points& p : all_) {
      const Two x = p.x + from_centre.x, y = p.y + from_centre.y;
      const auto in = x * x + y * y < radius * radius;
      inside_[n] = {in ? x : none, in ? y : none, in ? p.weight : none, in ? p.slope_x : none, in ? p.slope_y : none};
      n += (in[0] | in[1]) != 0 ? 1 : 0;  // written anyway: which are inside nobody can foretell
    }
    return {inside_.data(), n};
  }

 private:
  std::vector<Points> all_, inside_;
};

/// sigma_kk inside a grain by its touches (elasticity/disk_field.hpp), written for speed. As complex numbers, with the
/// normal n of a touch, rho = x + R n and q = 1/rho, a force F adds fn/(pi L R) - 2/(pi L) Re(F q); turned normals and
/// moved points follow from F q x q = F (q - R n q^2) and F q^2. Sums of q and q^2 over a pixel's points are thus all
/// that it sees.
class GrainField {
 public:
  GrainField(double radius, double length, const std::vector<Touch>& touches, const std::vector<double>& force)
      : scale_(1 / (std::numbers::pi * length)),
        radius_(radius) {
    for (const Touch& t : touches) {
      touches_.push_back({t.normal, radius * t.normal, t.force_of(force)});
      pressure_ += t.of_contact(force, 0) / radius;
      pressed_ = pressed_ || touches_.back().force != Vec2{};
    }
  }

  std::size_t size() const { return touches_.size(); }

  /// What a pixel sees of sigma_kk under the present forces, Pa. One that sees nothing else sees a harmonic field as in
  /// its centre.
  double seen(Vec2 x, PointsInside& inside) const {
    const double away = norm(x);
    if (!pressed_ || away >= radius_ + inside.reach) return 0;
    if (away + inside.reach <= radius_) {
      double sum = pressure_;
      for (const Pull& t : touches_) sum -= 2 * dot(t.force, x + t.back) / dot(x + t.back, x + t.back);
      return scale_ * sum;
    }
    Two sum{};
    for (const auto& p : inside(x, radius_)) {
      Two stress = pressure_ - Two{};
      for (const Pull& t : touches_) {
        const Two rx = p.x + t.back.x, ry = p.y + t.back.y;
        stress -= 2 * (t.force.x * rx + t.force.y * ry) / (rx * rx + ry * ry);
      }
      sum += p.weight * stress;
    }
    return scale_ * sum_of(sum);
  }

  /// What a pixel sees per newton of every touch's fn and ft goes to `row` (2 a touch), its change per radian by which
  /// a normal turns, its force with it, to `turn`; all times `factor`. Returns the same for a move of the centre by d.
  Vec2 fill_row(Vec2 x, PointsInside& inside, double factor, double* row, double* turn) {
    const double scale = factor * scale_;
    const auto fill = [&](std::size_t k, const Seen& s) {
      const Pull& t = touches_[k];
      const Vec2 nq = product(t.normal, s.q);
      row[2 * k] = scale * (s.weight / radius_ - 2 * nq.x), row[2 * k + 1] = 2 * scale * nq.y;
      turn[k] = 2 * scale * product(t.force, s.q - product(t.back, s.squared)).y;
    };
    return scale * (norm(x) + inside.reach <= radius_ ? see_centre(x, fill) : see_points(inside(x, radius_), fill));
  }

 private:
  struct Pull {
    Vec2 normal, back, force;
  };
  /// Sums over a pixel's points of weight, weight q and weight q^2.
  struct Seen {
    double weight;
    Vec2 q, squared;
  };

  /// Hands what a pixel that sees nothing else sees of every touch to `fill`; returns the change when the centre moves,
  /// in 1/scale.
  template <class Fill> Vec2 see_centre(Vec2 x, const Fill& fill) const {
    Vec2 gradient;
    for (std::size_t k = 0; k < touches_.size(); ++k) {
      const Vec2 rho = x + touches_[k].back, q = 1 / dot(rho, rho) * Vec2{rho.x, -rho.y}, squared = product(q, q);
      fill(k, {1, q, squared});
      gradient += product(touches_[k].force, squared);
    }
    return -2 * Vec2{gradient.x, -gradient.y};
  }

  /// The same at the rim. The centre moves by d: a point of the grain is then seen at a place d farther, where the
  /// pixel's weight is slope.d larger.
  template <class Fill> Vec2 see_points(std::span<const PointsInside::Points> points, const Fill& fill) {
    stress_.assign(points.size(), pressure_ - Two{});
    Two weight{}, shift_x{}, shift_y{};
    for (const auto& p : points) weight += p.weight;
    for (std::size_t k = 0; k < touches_.size(); ++k) {
      const Pull& t = touches_[k];
      Two sum_x{}, sum_y{}, squared_x{}, squared_y{};
      for (std::size_t p = 0; p < points.size(); ++p) {
        const Two x = points[p].x + t.back.x, y = points[p].y + t.back.y, inverse = 1 / (x * x + y * y);
        const Two qx = x * inverse, qy = -y * inverse, wx = points[p].weight * qx, wy = points[p].weight * qy;
        sum_x += wx, sum_y += wy, squared_x += wx * qx - wy * qy, squared_y += wx * qy + wy * qx;
        stress_[p] -= 2 * (t.force.x * qx - t.force.y * qy);
      }
      fill(k, {sum_of(weight), {sum_of(sum_x), sum_of(sum_y)}, {sum_of(squared_x), sum_of(squared_y)}});
    }
    for (std::size_t p = 0; p < points.size(); ++p)
      shift_x += stress_[p] * points[p].slope_x, shift_y += stress_[p] * points[p].slope_y;
    return {sum_of(shift_x), sum_of(shift_y)};
  }

  double scale_, radius_, pressure_ = 0;  // pressure: what the touches' fn add everywhere, in 1/scale
  bool pressed_ = false;
  std::vector<Pull> touches_;
  std::vector<Two> stress_;  // of a pixel's points
};

GrainField field_of(const Placed& placed, std::size_t g) {
  return {placed.radius[g], placed.length, placed.touches[g], placed.force};
}

/// A grain and those that may spill light over to its pixels.
struct Neighbourhood {
  const Placed& placed;
  std::size_t grain;
  GrainField field;
  std::vector<GrainField> others;
  PointsInside inside;

  Neighbourhood(const Placed& p, std::size_t g, const PointSpread& spread)
      : placed(p),
        grain(g),
        field(field_of(p, g)),
        inside(spread) {
    for (const Near& n : p.near[g]) others.push_back(field_of(p, n.grain));
  }
  Vec2 from_centre(const GrainPixel& pixel) const { return pixel.place + placed.found[grain] - placed.centre[grain]; }
  /// Warming that a pixel sees of the others, K.
  double spill(Vec2 x) {
    double sum = 0;
    for (std::size_t o = 0; o < others.size(); ++o) {
      const Near& n = placed.near[grain][o];
      const Vec2 from_other = x + placed.centre[grain] - placed.centre[n.grain] - n.cells;
      sum -= placed.factor[n.grain] * others[o].seen(from_other, inside);
    }
    return sum;
  }
};

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

GrainRows rows_of_grain(const Placed& placed, std::size_t g, const std::vector<GrainPixel>& pixels,
                        const PointSpread& spread) {
  Neighbourhood around(placed, g, spread);
  const std::size_t z = around.field.size();
  GrainRows rows{
      {2 * z, pixels.size()}, std::vector<double>(pixels.size()), std::vector<Vec2>(pixels.size()), {z, pixels.size()}};
  for (std::size_t q = 0; q < pixels.size(); ++q) {
    const Vec2 x = around.from_centre(pixels[q]);
    rows.shift[q] =
        around.field.fill_row(x, around.inside, -placed.factor[g], rows.response.column(q), rows.turn.column(q));
    rows.spill[q] = around.spill(x);
  }
  return rows;
}

std::vector<double> warming_of_grain(const Placed& placed, std::size_t g, const std::vector<GrainPixel>& pixels,
                                     const PointSpread& spread) {
  Neighbourhood around(placed, g, spread);
  return mapped(pixels, [&](const GrainPixel& pixel) {
    const Vec2 x = around.from_centre(pixel);
    return around.spill(x) - placed.factor[g] * around.field.seen(x, around.inside);
  });
}

}  // namespace arenite::inference
