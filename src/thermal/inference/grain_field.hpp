#pragma once
#include <numbers>
#include <vector>

#include "thermal/inference/touching.hpp"

namespace arenite::inference {

/// sigma_kk inside a grain by its touches (elasticity/disk_field.hpp), written for speed. As complex numbers, with the
/// normal n of a touch, rho = x + R n and q = 1/rho, a force F adds -2/(pi L) Re(F q); moved points and turned normals
/// follow from q^2.
class GrainField {
 public:
  GrainField(double radius, double length, const std::vector<Touch>& touches, const std::vector<double>& force)
      : scale_(1 / (std::numbers::pi * length)), over_radius_(1 / radius) {
    for (const Touch& t : touches) {
      const auto c = 2 * static_cast<std::size_t>(t.contact);
      const Vec2 pull = force[c] * t.normal + force[c + 1] * perpendicular(t.normal);
      touches_.push_back({t.normal, radius * t.normal, pull, force[c]});
    }
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

}  // namespace arenite::inference
