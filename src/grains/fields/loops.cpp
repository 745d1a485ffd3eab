#include "grains/fields/loops.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/joined_sets.hpp"
#include "grains/texture/loose_grains.hpp"
#include "grains/texture/view.hpp"

namespace arenite::fields {
namespace {

/// Contacts as pairs of half-edges: 2 e leaves i for j, 2 e + 1 leaves j for i.
struct Network {
  std::vector<std::int32_t> from;      ///< grain that a half-edge leaves
  std::vector<Vec2> step;              ///< to the centre of its other grain, m
  std::vector<std::int32_t> next;      ///< half-edge that follows on the walk with the loop on the left
  std::vector<std::uint8_t> left_out;  ///< by grain

  std::size_t edges() const { return from.size() / 2; }
};

Network network_of(const Packing& packing, bool bearing_only) {
  const Contacts& contacts = packing.contacts;
  Network net;
  const auto counts = [&](std::size_t c) { return !contacts.is_wall(c) && (!bearing_only || contacts.fn[c] != 0); };
  net.left_out = texture::loose_grains(packing.contacts, packing.grains.size(), 2, counts);
  std::vector<std::vector<std::int32_t>> leaving(packing.grains.size());
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    if (!counts(c) || net.left_out[contacts.i[c]] || net.left_out[contacts.j[c]]) continue;
    const Vec2 branch = contacts.branch(c);
    for (const auto& [grain, step] : {std::pair{contacts.i[c], branch}, std::pair{contacts.j[c], -branch}}) {
      leaving[grain].push_back(static_cast<std::int32_t>(net.from.size()));
      net.from.push_back(grain);
      net.step.push_back(step);
    }
  }
  net.next.resize(net.from.size());
  for (auto& around : leaving) {
    const auto direction = [&](std::int32_t h) { return std::atan2(net.step[h].y, net.step[h].x); };
    std::sort(around.begin(), around.end(), [&](std::int32_t a, std::int32_t b) {
      return std::pair{direction(a), a} < std::pair{direction(b), b};
    });
    // Who comes in against the half-edge h goes on by the one before it, counter-clockwise order.
    for (std::size_t k = 0; k < around.size(); ++k)
      net.next[around[k] ^ 1] = around[(k + around.size() - 1) % around.size()];
  }
  return net;
}

/// A closed walk: how many steps, where it ends as seen from its start, and the area that it goes round
/// counter-clockwise.
struct Walk {
  std::int32_t steps = 0;
  Vec2 end;
  double area = 0;
};

Walk walk_from(const Network& net, std::size_t start, std::vector<std::uint8_t>& walked) {
  Walk walk;
  for (std::size_t h = start; !walked[h]; h = static_cast<std::size_t>(net.next[h])) {
    walked[h] = 1;
    walk.area += 0.5 * cross(walk.end, net.step[h]);
    walk.end += net.step[h];
    ++walk.steps;
  }
  return walk;
}

/// Steps of a walk that does not go round a periodic cell add up to nothing but errors of arms; others to a vector of
/// the lattice, none of which is shorter than the smaller periodic side.
double half_the_cell(const Domain& domain) {
  double length = std::numeric_limits<double>::infinity();
  if (domain.periodic[0]) length = std::min(length, domain.width());
  if (domain.periodic[1]) length = std::min(length, domain.height());
  return length / 2;
}

}  // namespace

Loops find_loops(const Packing& packing, bool bearing_only) {
  const Network net = network_of(packing, bearing_only);
  Loops loops;
  loops.contacts = net.edges();
  loops.grains = static_cast<std::size_t>(std::count(net.left_out.begin(), net.left_out.end(), 0));
  loops.rattlers = packing.grains.size() - loops.grains;
  JoinedSets sets(packing.grains.size());
  for (std::size_t h = 0; h < net.from.size(); h += 2) sets.join(net.from[h], net.from[h + 1]);
  for (std::size_t g = 0; g < packing.grains.size(); ++g)
    loops.parts += !net.left_out[g] && sets.find(static_cast<std::int32_t>(g)) == static_cast<std::int32_t>(g);

  const double open = half_the_cell(packing.domain);
  std::vector<std::uint8_t> walked(net.from.size(), 0);
  double sum = 0;
  for (std::size_t h = 0; h < net.from.size(); ++h) {
    if (walked[h]) continue;
    const Walk walk = walk_from(net, h, walked);
    if (norm(walk.end) > open || !(walk.area > 0)) {
      ++loops.outlines;
      continue;
    }
    const auto n = static_cast<std::size_t>(walk.steps);
    loops.edges.push_back(walk.steps);
    loops.area.push_back(walk.area);
    loops.histogram.resize(std::max(loops.histogram.size(), n + 1), 0);
    ++loops.histogram[n];
    sum += walk.steps;
  }
  loops.mean_edges = loops.edges.empty() ? statistics::unknown : sum / static_cast<double>(loops.edges.size());
  return loops;
}

}  // namespace arenite::fields
