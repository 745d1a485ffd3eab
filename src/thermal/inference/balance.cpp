#include "thermal/inference/balance.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "core/mapped.hpp"
#include "core/median.hpp"
#include "thermal/inference/presence.hpp"

namespace arenite::inference {
namespace {

/// Springs in series; 1 where the materials do not say.
double stiffness(const Packing& packing, std::size_t c) {
  const auto of = [&](std::int32_t g) {
    const std::int32_t m = packing.grains.material[static_cast<std::size_t>(g)];
    return m < 0 || packing.materials.empty() ? 0.0 : packing.materials[static_cast<std::size_t>(m)].stiffness;
  };
  const double a = of(packing.contacts.i[c]), b = packing.contacts.is_wall(c) ? a : of(packing.contacts.j[c]);
  return a > 0 && b > 0 ? a * b / (a + b) : 1;
}

/// Contacts whose overlap grows alike with their force: a pair of materials, or a material at a wall.
int kind_of(const Packing& packing, std::size_t c) {
  const auto material = [&](std::int32_t g) {
    return std::max(0, static_cast<int>(packing.grains.material[static_cast<std::size_t>(g)]));
  };
  const int materials = std::max(1, static_cast<int>(packing.materials.size())), a = material(packing.contacts.i[c]);
  if (packing.contacts.is_wall(c)) return materials * materials + a;
  const int b = material(packing.contacts.j[c]);
  return std::min(a, b) * materials + std::max(a, b);
}

double overlap_of(const Packing& packing, std::size_t c) {
  const Grains& grains = packing.grains;
  const auto i = static_cast<std::size_t>(packing.contacts.i[c]);
  if (packing.contacts.is_boundary(c)) return grains.radius[i] - packing.contacts.arm_i[c];
  if (packing.contacts.is_wall(c))
    return grains.radius[i] - packing.domain.depth(packing.contacts.wall_side(c), grains.position[i]);
  const auto j = static_cast<std::size_t>(packing.contacts.j[c]);
  return grains.radius[i] + grains.radius[j] -
         norm(packing.domain.nearest_image(grains.position[i] - grains.position[j]));
}

void judge_presence(const Packing& packing, double widest_gap, InferredForces& forces) {
  ContactEvidence evidence{forces.contacts.fn, forces.fn_error, {}, {}, 0};
  std::vector<double> gaps;
  double radius = 0;
  for (std::size_t c = 0; c < forces.contacts.size(); ++c) {
    evidence.overlap.push_back(overlap_of(packing, c));
    evidence.kind.push_back(kind_of(packing, c));
    if (evidence.overlap.back() < 0) gaps.push_back(-evidence.overlap.back());
  }
  for (const double r : packing.grains.radius) radius += r / static_cast<double>(packing.grains.size());
  // Of even gaps half are narrower than half of the widest; a few that opened far on the way do not count in it.
  evidence.widest_gap = std::max(widest_gap > 0 ? widest_gap : 2 * median(std::move(gaps)), 0.02 * radius);
  Presence found = presence(evidence);
  forces.present = taken_as_present(found);
  forces.presence = std::move(found.probability);
  forces.idle = std::move(found.idle);
  forces.fit.proposed = forces.contacts.size(), forces.fit.present = found.expected,
  forces.fit.present_error = found.error;
}

}  // namespace

Touches touches_of_grains(const Packing& packing, const std::vector<Vec2>& centre) {
  const Contacts& contacts = packing.contacts;
  Touches touches(centre.size());
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    const auto i = static_cast<std::size_t>(contacts.i[c]);
    const int contact = static_cast<int>(c);
    if (contacts.is_wall(c)) {
      touches[i].push_back(
          {contact, -1, contacts.is_boundary(c) ? contacts.normal[c] : inward_normal(contacts.wall_side(c)), 0});
      continue;
    }
    const auto j = static_cast<std::size_t>(contacts.j[c]);
    const Vec2 branch = packing.domain.nearest_image(centre[i] - centre[j]);
    const double distance = norm(branch);
    const Vec2 n = (1 / distance) * branch;
    touches[i].push_back({contact, static_cast<int>(j), n, distance});
    touches[j].push_back({contact, static_cast<int>(i), -n, distance});
  }
  return touches;
}

std::vector<int> columns_of(const Unknowns& unknowns, std::size_t grain, const std::vector<Touch>& touches) {
  std::vector<int> columns;
  for (const Touch& t : touches) columns.push_back(2 * t.contact), columns.push_back(2 * t.contact + 1);
  if (unknowns.move <= 0) return columns;
  const auto push = [&](std::size_t g) {
    columns.push_back(unknowns.centre(g)), columns.push_back(unknowns.centre(g) + 1);
  };
  push(grain);
  for (const Touch& t : touches)
    if (t.partner >= 0) push(static_cast<std::size_t>(t.partner));
  return columns;
}

void add_turn(const Unknowns& unknowns, const std::vector<Touch>& touches, std::size_t k, double per_radian,
              double* row) {
  if (unknowns.move <= 0 || touches[k].partner < 0) return;
  std::size_t partner = 2 * touches.size() + 2;
  for (std::size_t q = 0; q < k; ++q) partner += touches[q].partner >= 0 ? 2 : 0;
  const Vec2 change = per_radian * unknowns.move / touches[k].distance * perpendicular(touches[k].normal);
  row[2 * touches.size()] += change.x, row[2 * touches.size() + 1] += change.y;
  row[partner] -= change.x, row[partner + 1] -= change.y;
}

void ForceEquations::add_balance(const Touches& touches, const std::vector<double>& force, double error,
                                 const std::vector<double>& scale) {
  for (std::size_t g = 0; g < touches.size(); ++g) {
    if (touches[g].empty()) continue;
    const std::size_t material = scale.empty() ? 0 : static_cast<std::size_t>(packing.grains.material[g]);
    const double times = scale.empty() ? 1 : scale[material];
    const std::vector<double> weight(3, times * times / (error * error));
    std::vector<int> columns = columns_of(unknowns, g, touches[g]);
    if (!scale.empty()) columns.push_back(unknowns.scale(material));
    const std::size_t n = columns.size();
    std::vector<double> rows(3 * n);
    for (std::size_t k = 0; k < touches[g].size(); ++k) {
      const Vec2 normal = touches[g][k].normal, t = perpendicular(normal);
      rows[2 * k] = unknowns.force * normal.x, rows[2 * k + 1] = unknowns.force * t.x;
      rows[n + 2 * k] = unknowns.force * normal.y, rows[n + 2 * k + 1] = unknowns.force * t.y;
      rows[2 * n + 2 * k + 1] = unknowns.force;
      const Vec2 turned = perpendicular(touches[g][k].force_of(force));
      add_turn(unknowns, touches[g], k, turned.x, &rows[0]);
      add_turn(unknowns, touches[g], k, turned.y, &rows[n]);
      if (scale.empty()) continue;
      const Vec2 present = touches[g][k].force_of(force);
      rows[n - 1] += present.x, rows[2 * n - 1] += present.y;
      rows[3 * n - 1] += touches[g][k].of_contact(force, 1);
    }
    add(columns, rows, {0, 0, 0}, weight);
  }
}

void ForceEquations::add_walls(const std::vector<WallLoad>& walls) {
  const Contacts& contacts = packing.contacts;
  for (const WallLoad& wall : walls) {
    std::vector<int> columns;
    for (std::size_t c = 0; c < contacts.size(); ++c)
      if (contacts.is_wall(c) && contacts.wall_side(c) == wall.side) columns.push_back(static_cast<int>(2 * c));
    add(columns, std::vector<double>(columns.size(), unknowns.force), {wall.force}, {1 / (wall.error * wall.error)});
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

void ForceEquations::add_energy(double prior) {
  const std::vector<double> compliance = compliances(packing);
  for (int u = 0; u < static_cast<int>(2 * unknowns.contacts); ++u)
    add_diagonal(u, compliance[static_cast<std::size_t>(u / 2)] / (prior * prior), 0);
}

std::vector<double> ForceEquations::solution(const ForceOptions& options) const {
  return options.inequality == Inequality::cone ? solve_in_cone(static_cast<int>(unknowns.contacts), options.friction)
                                                : solve();
}

InferredForces ForceEquations::finish(const ForceOptions& options, const Touches& touches,
                                      const std::vector<double>& force) const {
  InferredForces out;
  out.contacts = packing.contacts;
  for (std::size_t g = 0; g < touches.size(); ++g)
    for (const Touch& t : touches[g])
      if (const auto c = static_cast<std::size_t>(t.contact); static_cast<std::size_t>(packing.contacts.i[c]) == g)
        out.contacts.normal[c] = t.normal;
  const std::vector<double> variance = inverse_diagonal();
  for (std::size_t c = 0; c < unknowns.contacts; ++c) {
    out.contacts.fn[c] = force[2 * c], out.contacts.ft[c] = force[2 * c + 1];
    out.fn_error.push_back(unknowns.force * std::sqrt(variance[2 * c]));
    out.ft_error.push_back(unknowns.force * std::sqrt(variance[2 * c + 1]));
  }
  for (std::size_t m = 0; m < unknowns.scales; ++m)
    out.fit.factor_scale_error.push_back(std::sqrt(variance[static_cast<std::size_t>(unknowns.scale(m))]));
  if (unknowns.shift > 0)
    out.fit.shift_error = unknowns.shift * std::sqrt(variance[static_cast<std::size_t>(unknowns.common_shift())]);
  judge_presence(packing, options.widest_gap, out);
  out.imbalance = mapped(touches, [&](const std::vector<Touch>& own) {
    Vec2 sum;
    for (const Touch& t : own) sum += t.force_of(force);
    return norm(sum);
  });
  return out;
}

}  // namespace arenite::inference
