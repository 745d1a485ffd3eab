#pragma once
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace arenite::imaging {

/// The normal distribution and its density from a table: cubic between points, right to 3e-9. A picture's fit asks for
/// them a hundred million times.
class BlurredStep {
 public:
  static constexpr double reach = 5;  ///< beyond, the step counts as 0 or 1

  /// Phi(u) for |u| <= reach; `density` becomes phi(u).
  static double at(double u, double& density) {
    static const Table table;
    const double place = (u + reach) * per_unit;
    const auto k = static_cast<std::size_t>(place);
    const Point &a = table.point[k], &b = table.point[k + 1];
    const double t = place - static_cast<double>(k), s = 1 - t;
    const double left = s * s * (1 + 2 * t), right = t * t * (1 + 2 * s), rise = s * s * t / per_unit, fall = t * t * s / per_unit;
    density = left * a.density + right * b.density + rise * a.bend - fall * b.bend;
    return left * a.share + right * b.share + rise * a.density - fall * b.density;
  }

 private:
  static constexpr double per_unit = 32;
  struct Point {
    double share, density, bend;
  };
  struct Table {
    std::array<Point, static_cast<std::size_t>(2 * reach * per_unit) + 2> point;
    Table() {
      for (std::size_t k = 0; k < point.size(); ++k) {
        const double u = static_cast<double>(k) / per_unit - reach, density = std::exp(-0.5 * u * u) / std::sqrt(2 * std::numbers::pi);
        point[k] = {0.5 * std::erfc(-u / std::numbers::sqrt2), density, -u * density};
      }
    }
  };
};

}  // namespace arenite::imaging
