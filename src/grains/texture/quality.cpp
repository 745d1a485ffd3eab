#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

#include "grains/texture/view.hpp"
#include "model/joints.hpp"

namespace arenite::texture {
namespace {

/// Contacts and bonds that can hold a grain: one more than there are axes.
template <int D> constexpr int contacts_that_hold = D + 1;

/// Median |sum F| over grains with at least so many contacts or bonds, walls and weight included.
template <int D> double median_resultant(const ViewIn<D>& view) {
  const auto& contacts = view.pairs();
  std::vector<Vec<D>> sum(view.packing.grains.size());
  std::vector<int> count(sum.size(), 0);
  const auto push = [&](std::size_t grain, Vec<D> force) {
    sum[grain] += force;
    ++count[grain];
  };
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    const Vec<D> f = contacts.force_on_i(c);
    push(static_cast<std::size_t>(contacts.i[c]), f);
    if (!contacts.is_wall(c)) push(static_cast<std::size_t>(contacts.j[c]), -f);
  }
  for_each_joint(view.packing, [&](std::size_t i, std::size_t j, Vec<D> f, Vec<D> /*branch*/) {
    push(i, f);
    push(j, -f);
  });
  if (const Vec<D> gravity = view.options.gravity; gravity != Vec<D>{})
    for (std::size_t g = 0; g < sum.size(); ++g) sum[g] += mass_of(view.packing, g) * gravity;
  std::vector<double> resultants;
  for (const std::size_t g : view.grains)
    if (count[g] >= contacts_that_hold<D>) resultants.push_back(norm(sum[g]));
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

double size_of(double tangential) { return std::abs(tangential); }
double size_of(Vec3 tangential) { return norm(tangential); }

/// Largest and mean |F_t|/F_n of compressive contacts, and the share of contacts that come within 0.001 of the largest.
template <int D> void put_friction(Numbers& to, const ViewIn<D>& view) {
  std::vector<double> ratios;
  for (const std::size_t c : view.contacts)
    if (view.pairs().fn[c] > 0) ratios.push_back(size_of(view.pairs().ft[c]) / view.pairs().fn[c]);
  if (ratios.empty()) return;
  const double largest = *std::max_element(ratios.begin(), ratios.end()), count = static_cast<double>(ratios.size());
  const auto sliding =
      std::count_if(ratios.begin(), ratios.end(), [&](double r) { return r > 0 && r >= (1 - 1e-3) * largest; });
  put(to, "friction_ratio_max", largest, "", "Largest |F_t|/F_n of compressive contacts", Trait::by_forces);
  put(to, "friction_ratio_mean", std::accumulate(ratios.begin(), ratios.end(), 0.0) / count, "",
      "Mean |F_t|/F_n of compressive contacts", Trait::detail | Trait::by_forces);
  put(to, "sliding_share", static_cast<double>(sliding) / count, "",
      "Fraction of contacts within 0.001 of the largest |F_t|/F_n", Trait::by_forces);
}

}  // namespace

/// What tells measured networks from packings at rest: reported, never repaired.
template <int D> void quality(const ViewIn<D>& view, TextureIn<D>& texture) {
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
  put(j, "median_imbalance", imbalance, "",
      fmt::format("Median |sum F| of grains with at least {} contacts over the mean force", contacts_that_hold<D>)
          .c_str(),
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
template void quality(const View&, Texture&);
template void quality(const SphereView&, TextureIn<3>&);

}  // namespace arenite::texture
