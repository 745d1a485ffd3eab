#include "grains/fields/force_chains.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/joined_sets.hpp"
#include "core/problems.hpp"
#include "grains/texture/stress.hpp"
#include "grains/texture/texture.hpp"

namespace arenite::fields {
namespace {

using statistics::unknown;

/// What joins a grain to the next of its chain, on the side that its direction points to (1) and on the other (0).
using Links = std::array<std::int32_t, 2>;  // contact, or -1

struct Candidate {
  double alignment = 0;  // sum of both cosines
  std::int32_t contact = 0;
  std::int8_t side_of_i = 0, side_of_j = 0;
};

std::int32_t other_end(const Contacts& contacts, std::int32_t c, std::int32_t g) {
  return contacts.i[c] == g ? contacts.j[c] : contacts.i[c];
}

/// Contacts that may join two highly loaded grains, the straightest first.
std::vector<Candidate> candidates(const Contacts& contacts, const std::vector<GrainCompression>& grains,
                                  double threshold, double least_cosine) {
  std::vector<Candidate> found;
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    if (contacts.is_wall(c) || contacts.fn[c] <= 0) continue;
    const GrainCompression& a = grains[contacts.i[c]];
    const GrainCompression& b = grains[contacts.j[c]];
    if (!(a.major > threshold && b.major > threshold)) continue;
    const double at_i = dot(a.direction, -contacts.normal[c]), at_j = dot(b.direction, contacts.normal[c]);
    if (std::abs(at_i) < least_cosine || std::abs(at_j) < least_cosine) continue;
    found.push_back({std::abs(at_i) + std::abs(at_j), static_cast<std::int32_t>(c), static_cast<std::int8_t>(at_i > 0),
                     static_cast<std::int8_t>(at_j > 0)});
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const Candidate& a, const Candidate& b) { return a.alignment > b.alignment; });
  return found;
}

std::vector<Links> linked(const Contacts& contacts, const std::vector<Candidate>& list, std::size_t grains) {
  std::vector<Links> links(grains, Links{-1, -1});
  for (const Candidate& k : list) {
    const auto c = static_cast<std::size_t>(k.contact);
    auto& at_i = links[contacts.i[c]][k.side_of_i];
    auto& at_j = links[contacts.j[c]][k.side_of_j];
    if (at_i < 0 && at_j < 0) at_i = at_j = k.contact;
  }
  return links;
}

/// Grains from `start` on, which is left by the contact `by`, until the chain ends or comes back.
std::vector<std::int32_t> follow(const Contacts& contacts, const std::vector<Links>& links, std::int32_t start,
                                 std::int32_t by) {
  std::vector<std::int32_t> chain{start};
  while (by >= 0) {
    const std::int32_t next = other_end(contacts, by, chain.back());
    if (next == start) break;
    chain.push_back(next);
    const Links& l = links[next];
    by = l[0] == by ? l[1] : l[0];
  }
  return chain;
}

/// First chains with ends, from their smaller end, then what is left: rings.
void collect(const Contacts& contacts, const std::vector<Links>& links, std::size_t least, ForceChains& result) {
  std::vector<std::uint8_t> seen(links.size(), 0);
  for (const bool rings : {false, true})
    for (std::size_t g = 0; g < links.size(); ++g) {
      const bool linked_twice = links[g][0] >= 0 && links[g][1] >= 0,
                 linked_once = links[g][0] >= 0 || links[g][1] >= 0;
      if (seen[g] || !linked_once || linked_twice != rings) continue;
      auto chain = follow(contacts, links, static_cast<std::int32_t>(g), std::max(links[g][0], links[g][1]));
      for (const std::int32_t k : chain) seen[k] = 1;
      if (chain.size() < least) continue;
      result.histogram.resize(std::max(result.histogram.size(), chain.size() + 1), 0);
      ++result.histogram[chain.size()];
      result.chains.push_back(std::move(chain));
      result.ring.push_back(rings);
    }
}

}  // namespace

std::vector<GrainCompression> grain_compressions(const Packing& packing) {
  const std::vector<Tensor2> moments = texture::grain_moments(packing);
  const double thickness = packing.domain.thickness > 0 ? packing.domain.thickness : 1;
  std::vector<GrainCompression> out(moments.size());
  for (std::size_t g = 0; g < out.size(); ++g) {
    const double r = packing.grains.radius[g], volume = std::numbers::pi * r * r * thickness;
    const Tensor2& m = moments[g];
    const double mean = -0.5 * trace(m), difference = -0.5 * (m.xx - m.yy), shear = -0.5 * (m.xy + m.yx);
    const double radius = mohr_radius(m);
    out[g].major = (mean + radius) / volume;
    if (!(radius > 1e-12 * std::abs(mean))) continue;  // rounding of a few contacts' sum
    const double angle = 0.5 * std::atan2(shear, difference);
    out[g].direction = {std::cos(angle), std::sin(angle)};
  }
  const Contacts& contacts = packing.contacts;
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    if (contacts.fn[c] == 0 && contacts.ft[c] == 0) continue;
    out[contacts.i[c]].loaded = true;
    if (!contacts.is_wall(c)) out[contacts.j[c]].loaded = true;
  }
  return out;
}

void declare(ParameterVisitor& v, ChainOptions& options) {
  v.number({"stress_factor", "A grain is loaded highly above this multiple of the mean major principal stress."},
           options.stress_factor, "", range::not_negative);
  v.number(
      {"angle", "Largest angle between a grain's direction of greatest compression and the branch to the next grain."},
      options.angle, "deg", range::above(0, std::numbers::pi / 2));
  v.integer({"least", "Grains that a chain has at least."}, options.least, {1, 1'000'000});
}

ForceChains find_force_chains(const Packing& packing, const ChainOptions& options) {
  if (!(options.angle > 0 && options.angle < std::numbers::pi / 2))
    throw refusal("an angle of {:g} degrees in force chains; give one between 0 and 90",
                  options.angle * 180 / std::numbers::pi);
  const std::vector<GrainCompression> grains = grain_compressions(packing);
  ForceChains result;
  double sum = 0, loaded = 0;
  for (const GrainCompression& g : grains)
    if (g.loaded) sum += g.major, ++loaded;
  result.mean_stress = loaded > 0 ? sum / loaded : unknown;
  const double threshold = options.stress_factor * result.mean_stress;
  for (const GrainCompression& g : grains) result.highly_loaded += g.loaded && g.major > threshold;

  const auto list = candidates(packing.contacts, grains, threshold, std::cos(options.angle));
  collect(packing.contacts, linked(packing.contacts, list, grains.size()), std::max<std::size_t>(2, options.least),
          result);
  std::size_t members = 0;
  for (const auto& chain : result.chains) members += chain.size();
  result.mean_length =
      result.chains.empty() ? unknown : static_cast<double>(members) / static_cast<double>(result.chains.size());
  result.grain_share = loaded > 0 ? static_cast<double>(members) / loaded : unknown;
  return result;
}

StrongClusters strong_clusters(const Packing& packing, double factor) {
  const Contacts& contacts = packing.contacts;
  double sum = 0, pushing = 0;
  for (std::size_t c = 0; c < contacts.size(); ++c)
    if (!contacts.is_wall(c) && contacts.fn[c] > 0) sum += contacts.fn[c], ++pushing;
  StrongClusters result;
  result.of.assign(packing.grains.size(), -1);
  result.threshold = pushing > 0 ? factor * sum / pushing : unknown;
  const auto strong = [&](std::size_t c) {
    return !contacts.is_wall(c) && contacts.fn[c] > 0 && contacts.fn[c] > result.threshold;
  };

  JoinedSets sets(packing.grains.size());
  std::vector<std::size_t> bonds(packing.grains.size(), 0), members(packing.grains.size(), 0);
  for (std::size_t c = 0; c < contacts.size(); ++c)
    if (strong(c)) sets.join(contacts.i[c], contacts.j[c]), ++result.contacts;
  for (std::size_t c = 0; c < contacts.size(); ++c)
    if (strong(c)) ++bonds[sets.find(contacts.i[c])];
  for (std::size_t g = 0; g < members.size(); ++g) ++members[sets.find(static_cast<std::int32_t>(g))];
  result.share = pushing > 0 ? static_cast<double>(result.contacts) / pushing : unknown;

  std::vector<std::size_t> roots;
  for (std::size_t g = 0; g < members.size(); ++g)
    if (bonds[g] > 0) roots.push_back(g);
  std::stable_sort(roots.begin(), roots.end(), [&](std::size_t a, std::size_t b) { return members[a] > members[b]; });
  std::vector<std::int32_t> number(members.size(), -1);
  for (const std::size_t root : roots) {
    number[root] = static_cast<std::int32_t>(result.grains.size());
    result.grains.push_back(members[root]);
    result.contacts_of.push_back(bonds[root]);
  }
  for (std::size_t g = 0; g < members.size(); ++g) result.of[g] = number[sets.find(static_cast<std::int32_t>(g))];
  return result;
}

}  // namespace arenite::fields
