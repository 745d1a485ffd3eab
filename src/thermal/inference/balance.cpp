#include "thermal/inference/balance.hpp"

#include <algorithm>
#include <numbers>

namespace arenite::inference {
namespace {

Vec2 weight_of(const Packing& packing, std::size_t g, Vec2 gravity) {
  const auto material = static_cast<std::size_t>(std::max(0, packing.grains.material[g]));
  if (packing.materials.empty() || dot(gravity, gravity) == 0) return {};
  const double r = packing.grains.radius[g];
  return packing.materials[material].density * std::numbers::pi * r * r * packing.domain.thickness * gravity;
}

/// Springs in series; 1 where the materials do not say.
double stiffness(const Packing& packing, std::size_t c) {
  const auto of = [&](std::int32_t g) {
    const std::int32_t m = packing.grains.material[static_cast<std::size_t>(g)];
    return m < 0 || packing.materials.empty() ? 0.0 : packing.materials[static_cast<std::size_t>(m)].stiffness;
  };
  const double a = of(packing.contacts.i[c]), b = packing.contacts.is_wall(c) ? a : of(packing.contacts.j[c]);
  return a > 0 && b > 0 ? a * b / (a + b) : 1;
}

}  // namespace

std::vector<int> columns_of(const Unknowns& unknowns, std::size_t grain, const std::vector<Touch>& touches) {
  std::vector<int> columns;
  for (const Touch& t : touches) columns.push_back(2 * t.contact), columns.push_back(2 * t.contact + 1);
  if (unknowns.move <= 0) return columns;
  const auto push = [&](std::size_t g) { columns.push_back(unknowns.centre(g)), columns.push_back(unknowns.centre(g) + 1); };
  push(grain);
  for (const Touch& t : touches)
    if (t.partner >= 0) push(static_cast<std::size_t>(t.partner));
  return columns;
}

void add_turn(const Unknowns& unknowns, const std::vector<Touch>& touches, std::size_t k, double per_radian, double* row) {
  if (unknowns.move <= 0 || touches[k].partner < 0) return;
  std::size_t partner = 2 * touches.size() + 2;
  for (std::size_t q = 0; q < k; ++q) partner += touches[q].partner >= 0 ? 2 : 0;
  const Vec2 change = per_radian * unknowns.move / touches[k].distance * perpendicular(touches[k].normal);
  row[2 * touches.size()] += change.x, row[2 * touches.size() + 1] += change.y;
  row[partner] -= change.x, row[partner + 1] -= change.y;
}

void add_balance(NormalEquations& equations, const Unknowns& unknowns, const Packing& packing,
                 const std::vector<std::vector<Touch>>& touches, const std::vector<double>& force, Vec2 gravity, double error) {
  const std::vector<double> weight(3, 1 / (error * error));
  for (std::size_t g = 0; g < touches.size(); ++g) {
    if (touches[g].empty()) continue;
    const std::vector<int> columns = columns_of(unknowns, g, touches[g]);
    const std::size_t n = columns.size();
    std::vector<double> rows(3 * n);
    for (std::size_t k = 0; k < touches[g].size(); ++k) {
      const Vec2 normal = touches[g][k].normal, t = perpendicular(normal);
      const auto c = 2 * static_cast<std::size_t>(touches[g][k].contact);
      rows[2 * k] = unknowns.force * normal.x, rows[2 * k + 1] = unknowns.force * t.x;
      rows[n + 2 * k] = unknowns.force * normal.y, rows[n + 2 * k + 1] = unknowns.force * t.y;
      rows[2 * n + 2 * k + 1] = unknowns.force;
      const Vec2 turned = force[c] * t - force[c + 1] * normal;
      add_turn(unknowns, touches[g], k, turned.x, &rows[0]);
      add_turn(unknowns, touches[g], k, turned.y, &rows[n]);
    }
    const Vec2 w = weight_of(packing, g, gravity);
    equations.add(columns, rows, {-w.x, -w.y, 0}, weight);
  }
}

void add_walls(NormalEquations& equations, const Unknowns& unknowns, const Contacts& contacts, const std::vector<WallLoad>& walls) {
  for (const WallLoad& wall : walls) {
    std::vector<int> columns;
    for (std::size_t c = 0; c < contacts.size(); ++c)
      if (contacts.is_wall(c) && contacts.wall_side(c) == wall.side) columns.push_back(static_cast<int>(2 * c));
    equations.add(columns, std::vector<double>(columns.size(), unknowns.force), {wall.force}, {1 / (wall.error * wall.error)});
  }
}

std::vector<double> compliances(const Packing& packing) {
  const std::size_t n = packing.contacts.size();
  std::vector<double> out(n);
  double mean = 0;
  for (std::size_t c = 0; c < n; ++c) mean += stiffness(packing, c) / static_cast<double>(n);
  for (std::size_t c = 0; c < n; ++c) out[c] = mean / stiffness(packing, c);
  return out;
}

void add_energy(NormalEquations& equations, const Unknowns& unknowns, const Packing& packing, double prior) {
  const std::vector<double> compliance = compliances(packing);
  for (int u = 0; u < static_cast<int>(2 * unknowns.contacts); ++u)
    equations.add_diagonal(u, compliance[static_cast<std::size_t>(u / 2)] / (prior * prior), 0);
}

std::vector<double> imbalances(const Packing& packing, const std::vector<std::vector<Touch>>& touches, const std::vector<double>& force, Vec2 gravity) {
  std::vector<double> out(touches.size());
  for (std::size_t g = 0; g < touches.size(); ++g) {
    Vec2 sum = weight_of(packing, g, gravity);
    for (const Touch& t : touches[g]) {
      const auto c = 2 * static_cast<std::size_t>(t.contact);
      sum += force[c] * t.normal + force[c + 1] * perpendicular(t.normal);
    }
    out[g] = norm(sum);
  }
  return out;
}

}  // namespace arenite::inference
