#include "inference/grain_rows.hpp"

#include <cmath>
#include <numbers>

#include "elasticity/disk_field.hpp"

namespace arenite::inference {
namespace {

/// sigma_kk per newton of every touch, at a point seen from the grain's centre.
void responses(const Placed& placed, std::size_t g, Vec2 x, std::vector<elasticity::Response>& out) {
  const auto& touches = placed.touches[g];
  for (std::size_t k = 0; k < touches.size(); ++k) out[k] = elasticity::point_response(placed.radius[g], placed.length, touches[k].normal, x);
}

double total(const Placed& placed, std::size_t g, const std::vector<elasticity::Response>& response) {
  double sum = 0;
  for (std::size_t k = 0; k < placed.touches[g].size(); ++k) {
    const auto c = 2 * static_cast<std::size_t>(placed.touches[g][k].contact);
    sum += response[k].fn * placed.force[c] + response[k].ft * placed.force[c + 1];
  }
  return sum;
}

/// Change of sigma_kk at x when the normal of a force turns, its point with it, Pa/rad.
double turned(double radius, double length, Vec2 n, double fn, double ft, Vec2 x) {
  const Vec2 t = perpendicular(n), rho = x + radius * n, force = fn * n + ft * t, change = fn * t - ft * n;
  const double square = dot(rho, rho);
  const double slope = (dot(change, rho) + radius * dot(force, t)) / square - 2 * dot(force, rho) * radius * dot(rho, t) / (square * square);
  return -2 / (std::numbers::pi * length) * slope;
}

/// What a pixel sees of a neighbour, K.
double spill_from(const Placed& placed, std::size_t other, Vec2 from_other, const Footprint& footprint, std::vector<elasticity::Response>& scratch) {
  const double radius = placed.radius[other];
  if (norm(from_other) >= radius + footprint.reach) return 0;
  scratch.resize(placed.touches[other].size());
  double sum = 0;
  for (const Footprint::Point& p : footprint.points) {
    const Vec2 x = from_other + p.place;
    if (dot(x, x) >= radius * radius) continue;
    responses(placed, other, x, scratch);
    sum += p.weight * total(placed, other, scratch);
  }
  return -placed.factor[other] * sum;
}

}  // namespace

GrainRows rows_of_grain(const Placed& placed, std::size_t g, const std::vector<GrainPixel>& pixels, const Footprint& footprint) {
  const auto& touches = placed.touches[g];
  const std::size_t z = touches.size();
  const double radius = placed.radius[g], factor = -placed.factor[g];
  GrainRows rows{std::vector<double>(2 * z * pixels.size()), std::vector<double>(pixels.size()), std::vector<double>(2 * pixels.size()),
                 std::vector<double>(z * pixels.size())};
  std::vector<elasticity::Response> at(z), other;
  for (std::size_t q = 0; q < pixels.size(); ++q) {
    const Vec2 x = pixels[q].place + placed.found[g] - placed.centre[g];
    double* row = &rows.response[2 * z * q];
    const bool whole = norm(x) + footprint.reach <= radius;
    double covered = 0;
    Vec2 shift;
    for (const Footprint::Point& p : footprint.points) {
      const Vec2 y = x + p.place;
      if (dot(y, y) >= radius * radius) continue;
      responses(placed, g, y, at);
      covered += p.weight;
      const double sum = total(placed, g, at);
      shift += sum * p.slope;
      for (std::size_t k = 0; k < z; ++k) row[2 * k] += p.weight * at[k].fn, row[2 * k + 1] += p.weight * at[k].ft;
    }
    if (whole) {
      responses(placed, g, x, at);
      covered = 1;
      for (std::size_t k = 0; k < z; ++k) row[2 * k] = at[k].fn, row[2 * k + 1] = at[k].ft;
    }
    for (std::size_t k = 0; k < 2 * z; ++k) row[k] *= factor;
    // The centre moves by d: a point of the grain is seen at a place d farther, so that weight there changes by slope d.
    rows.shift[2 * q] = factor * shift.x, rows.shift[2 * q + 1] = factor * shift.y;
    for (std::size_t k = 0; k < z; ++k) {
      const auto c = 2 * static_cast<std::size_t>(touches[k].contact);
      rows.turn[z * q + k] = factor * covered * turned(radius, placed.length, touches[k].normal, placed.force[c], placed.force[c + 1], x);
    }
    for (const Near& n : placed.near[g])
      rows.spill[q] += spill_from(placed, n.grain, x + placed.centre[g] - placed.centre[n.grain] - n.cells, footprint, other);
  }
  return rows;
}

}  // namespace arenite::inference
