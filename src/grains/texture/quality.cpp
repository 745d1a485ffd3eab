#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "grains/texture/view.hpp"

namespace arenite::texture {
namespace {

/// Median |sum F| over grains with at least three contacts or bonds, walls and weight included.
double median_resultant(const View& view) {
  const auto& contacts = view.pairs();
  std::vector<Vec2> sum(view.packing.grains.size());
  std::vector<int> count(sum.size(), 0);
  const auto push = [&](std::int32_t grain, Vec2 force) {
    sum[grain] += force;
    ++count[grain];
  };
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    const Vec2 f = contacts.force_on_i(c);
    push(contacts.i[c], f);
    if (!contacts.is_wall(c)) push(contacts.j[c], -f);
  }
  const auto push_both = [&](const auto& link) {
    const Vec2 f = force_on_i(view.packing, link);
    push(link.i, f);
    push(link.j, -f);
  };
  for (const Bond& bond : view.packing.bonds)
    if (bond.broken == BondBreak::none) push_both(bond);
  for (const CohesivePair& pair : view.packing.cohesive)
    if (acts_across_gap(pair)) push_both(pair);
  const Vec2 gravity = view.options.gravity;
  if (gravity.x != 0 || gravity.y != 0)
    for (std::size_t g = 0; g < sum.size(); ++g) sum[g] += mass_of(view.packing, g) * gravity;
  std::vector<double> resultants;
  for (const std::size_t g : view.grains)
    if (count[g] >= 3) resultants.push_back(norm(sum[g]));
  if (resultants.empty()) return unknown;
  const std::size_t n = resultants.size();
  std::sort(resultants.begin(), resultants.end());
  return 0.5 * (resultants[(n - 1) / 2] + resultants[n / 2]);
}

/// Why some forces pull, in the order of Pull.
constexpr const char* reasons[] = {
    "in a measured sample without cohesion this is an error of measurement",
    "this is due to the adhesion of glued grains",
    "this is due to the damping of opening contacts (contact.attractive_dashpot = true)"};

/// Largest |F_t|/F_n of compressive contacts, and the share of contacts that come within 0.001 of it.
void put_friction(Numbers& to, const View& view) {
  std::vector<double> ratios;
  for (const std::size_t c : view.contacts)
    if (view.pairs().fn[c] > 0) ratios.push_back(std::abs(view.pairs().ft[c]) / view.pairs().fn[c]);
  if (ratios.empty()) return;
  const double largest = *std::max_element(ratios.begin(), ratios.end());
  const auto sliding =
      std::count_if(ratios.begin(), ratios.end(), [&](double r) { return r > 0 && r >= (1 - 1e-3) * largest; });
  put(to, "friction_ratio_max", largest, "", "Largest |F_t|/F_n of compressive contacts", Trait::by_forces);
  put(to, "sliding_share", static_cast<double>(sliding) / static_cast<double>(ratios.size()), "",
      "Fraction of contacts within 0.001 of the largest |F_t|/F_n", Trait::by_forces);
}

}  // namespace

/// What tells measured networks from packings at rest: reported, never repaired.
void quality(const View& view, Texture& texture) {
  const std::vector<double>& force = view.pairs().fn;
  const std::size_t contacts = view.contacts.size();
  const auto negative = static_cast<std::size_t>(
      std::count_if(view.contacts.begin(), view.contacts.end(), [&](std::size_t c) { return force[c] < 0; }));
  const double imbalance = view.mean_force > 0 ? median_resultant(view) / view.mean_force : unknown;
  Numbers& j = texture.numbers["quality"];
  put(j, "doubled_rows", view.options.doubled_rows, "", "Contacts listed twice and merged", Trait::detail);
  put(j, "negative_forces", negative, "", "Contacts with negative normal force", Trait::detail | Trait::by_forces);
  put(j, "negative_share", contacts > 0 ? static_cast<double>(negative) / static_cast<double>(contacts) : 0.0, "",
      "Fraction of contacts with negative normal force", Trait::detail | Trait::by_forces);
  put(j, "median_imbalance", imbalance, "", "Median |sum F| of grains with at least 3 contacts over the mean force",
      Trait::by_forces);
  put_friction(j, view);
  if (negative > 0)
    texture.notes.push_back(fmt::format("{} of {} normal forces are tensile; {}.", negative, contacts,
                                        reasons[static_cast<std::size_t>(view.options.pull)]));
  double largest = 0;
  for (const std::size_t c : view.contacts) largest = std::max(largest, force[c]);
  if (largest > 50 * view.mean_force && view.mean_force > 0)
    texture.notes.push_back(fmt::format(
        "The largest force is {:.3g} times the mean, so a few rows dominate the mean and everything derived from it.",
        largest / view.mean_force));
  if (imbalance > 0.1)
    texture.notes.push_back(
        fmt::format("Grains are not in balance: the median resultant is {:.2g} of the mean force, so stresses depend "
                    "on the reference point of moments.",
                    imbalance));
}

}  // namespace arenite::texture
