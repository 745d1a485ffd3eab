#include "model/elasticity/disk_field.hpp"

#include <algorithm>
#include <array>
#include <numbers>

namespace arenite::elasticity {
namespace {

/// Points of an arc in units of its half angle (-1 to 1) and their shares of its force, which add up to 1.
struct ArcNodes {
  std::vector<double> place, share;
};

constexpr std::array<int, 5> sizes{4, 8, 16, 32, 96};

ArcNodes make_nodes(Traction traction, int n) {
  ArcNodes nodes;
  for (int k = 1; k <= n; ++k) {
    const double angle = k * std::numbers::pi / (n + 1);
    double even = 0;
    for (int j = 1; j <= (n + 1) / 2; ++j) even += std::sin((2 * j - 1) * angle) / (2 * j - 1);
    const double elliptic = 2.0 / (n + 1) * std::sin(angle) * std::sin(angle);
    nodes.place.push_back(std::cos(angle));
    nodes.share.push_back(traction == Traction::uniform ? 2.0 / (n + 1) * std::sin(angle) * even : elliptic);
  }
  return nodes;
}

std::array<ArcNodes, sizes.size()> make_table(Traction traction) {
  std::array<ArcNodes, sizes.size()> table;
  for (std::size_t s = 0; s < sizes.size(); ++s) table[s] = make_nodes(traction, sizes[s]);
  return table;
}

/// Fejer's second rule (even traction) or Gauss's rule for Chebyshev polynomials of the second kind (half ellipse),
/// with as many points as a field needs that is looked at from `distance`, in units of the arc's half length.
const ArcNodes& arc_nodes(Traction traction, double distance) {
  static const ArcNodes point{{0}, {1}};
  static const auto uniform = make_table(Traction::uniform), elliptic = make_table(Traction::elliptic);
  if (traction == Traction::point) return point;
  const std::size_t size = distance > 20 ? 0 : distance > 4 ? 1 : distance > 1.5 ? 2 : distance > 0.6 ? 3 : 4;
  return traction == Traction::uniform ? uniform[size] : elliptic[size];
}

Vec2 force_of(const RimForce& f) { return f.fn * f.normal + f.ft * perpendicular(f.normal); }

/// Calls what(share, rho, outward normal) for every point that carries a share of the force; rho from there to x.
template <class What> void each_point(const Disk& disk, const RimForce& f, Vec2 x, const What& what) {
  const double half = disk.traction == Traction::point ? 0 : f.half_angle;
  const Vec2 outward = -f.normal, direct = x - disk.radius * outward;
  if (half <= 0) return what(1.0, direct, outward);
  const double along = std::abs(std::atan2(cross(outward, x), dot(outward, x)));
  const double away = disk.radius - norm(x), beside = disk.radius * std::max(0.0, along - half);
  const ArcNodes& nodes = arc_nodes(disk.traction, std::hypot(away, beside) / (half * disk.radius));
  for (std::size_t k = 0; k < nodes.place.size(); ++k) {
    const double turn = half * nodes.place[k], c = std::cos(turn), s = std::sin(turn);
    const Vec2 n{c * outward.x - s * outward.y, s * outward.x + c * outward.y};
    what(nodes.share[k], x - disk.radius * n, n);
  }
}

/// Sum over the rim of the forces' components along the inward normal, N.
double inward_sum(const Disk& disk) {
  double sum = 0;
  for (const RimForce& f : disk.forces)
    each_point(disk, f, {0, 0}, [&](double share, Vec2, Vec2 outward) { sum -= share * dot(force_of(f), outward); });
  return sum;
}

/// The mixed derivative of this in x and y is x/(x^2 + y^2).
double corner(double x, double y) {
  const double square = x * x + y * y;
  if (square == 0) return 0;
  return 0.5 * y * std::log(square) - y + (x == 0 ? 0 : x * std::atan(y / x));
}

/// Integrals of rho_x/|rho|^2 and rho_y/|rho|^2 over a square.
Vec2 integral_over_square(Vec2 rho, double side) {
  const double x0 = rho.x - side / 2, x1 = rho.x + side / 2, y0 = rho.y - side / 2, y1 = rho.y + side / 2;
  return {corner(x1, y1) - corner(x0, y1) - corner(x1, y0) + corner(x0, y0),
          corner(y1, x1) - corner(y0, x1) - corner(y1, x0) + corner(y0, x0)};
}

/// From this many sides on, the mean of a harmonic function over a square is its value in the middle, to 1e-7.
constexpr double far = 20;

}  // namespace

double sigma_kk(const Disk& disk, Vec2 x) {
  double sum = 0;
  for (const RimForce& f : disk.forces)
    each_point(disk, f, x, [&](double share, Vec2 rho, Vec2) { sum += share * dot(force_of(f), rho) / dot(rho, rho); });
  return (-2 * sum + inward_sum(disk) / disk.radius) / (std::numbers::pi * disk.length);
}

double square_mean(const Disk& disk, Vec2 centre, double side) {
  double sum = 0;
  for (const RimForce& f : disk.forces)
    each_point(disk, f, centre, [&](double share, Vec2 rho, Vec2) {
      const double square = dot(rho, rho);
      const Vec2 integral =
          square > far * far * side * side ? (side * side / square) * rho : integral_over_square(rho, side);
      sum += share * dot(force_of(f), integral);
    });
  return (-2 * sum + side * side * inward_sum(disk) / disk.radius) / (std::numbers::pi * disk.length) / (side * side);
}

std::vector<Word> words(EffectiveRadius) {
  return {{"four_reduced", "4 r_i r_j/(r_i + r_j)"}, {"sum", "r_i + r_j"}, {"geometric_mean", "2 sqrt(r_i r_j)"}};
}

}  // namespace arenite::elasticity
