#include "thermal/inference/finish.hpp"

#include <algorithm>
#include <cmath>

#include "core/median.hpp"
#include "thermal/inference/presence.hpp"

namespace arenite::inference {
namespace {

/// Contacts whose overlap grows alike with their force: a pair of materials, or a material at a wall.
int kind_of(const Packing& packing, std::size_t c) {
  const auto material = [&](std::int32_t g) { return std::max(0, static_cast<int>(packing.grains.material[static_cast<std::size_t>(g)])); };
  const int materials = std::max(1, static_cast<int>(packing.materials.size())), a = material(packing.contacts.i[c]);
  if (packing.contacts.is_wall(c)) return materials * materials + a;
  const int b = material(packing.contacts.j[c]);
  return std::min(a, b) * materials + std::max(a, b);
}

double overlap_of(const Packing& packing, std::size_t c) {
  const Grains& grains = packing.grains;
  const auto i = static_cast<std::size_t>(packing.contacts.i[c]);
  if (packing.contacts.is_wall(c)) {
    const int side = packing.contacts.wall_side(c);
    const Vec2 inward = inward_normal(side);
    return grains.radius[i] - dot(inward, grains.centre(i)) + (inward.x + inward.y) * packing.domain.wall[static_cast<std::size_t>(side)].position;
  }
  const auto j = static_cast<std::size_t>(packing.contacts.j[c]);
  return grains.radius[i] + grains.radius[j] - norm(packing.domain.nearest_image(grains.centre(i) - grains.centre(j)));
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
  forces.expected = found.expected, forces.expected_error = found.error;
}

}  // namespace

InferredForces finish(const ForceProblem& problem, const ForceOptions& options, const NormalEquations& equations, const Unknowns& unknowns,
                      const std::vector<std::vector<Touch>>& touches, const std::vector<double>& force) {
  InferredForces out;
  out.contacts = problem.packing.contacts;
  for (std::size_t g = 0; g < touches.size(); ++g)
    for (const Touch& t : touches[g]) {
      const auto c = static_cast<std::size_t>(t.contact);
      const bool first = static_cast<std::size_t>(out.contacts.i[c]) == g;
      if (first) out.contacts.nx[c] = t.normal.x, out.contacts.ny[c] = t.normal.y;
    }
  const std::vector<double> variance = equations.inverse_diagonal();
  for (std::size_t c = 0; c < unknowns.contacts; ++c) {
    out.contacts.fn[c] = force[2 * c], out.contacts.ft[c] = force[2 * c + 1];
    out.fn_error.push_back(unknowns.force * std::sqrt(variance[2 * c]));
    out.ft_error.push_back(unknowns.force * std::sqrt(variance[2 * c + 1]));
  }
  for (std::size_t m = 0; m < unknowns.scales; ++m) out.factor_scale_error.push_back(std::sqrt(variance[static_cast<std::size_t>(unknowns.scale(m))]));
  judge_presence(problem.packing, options.widest_gap, out);
  out.imbalance = imbalances(problem.packing, touches, force, options.gravity);
  return out;
}

}  // namespace arenite::inference
