#include "grains/texture/distribution.hpp"
#include "grains/texture/statistics.hpp"

namespace arenite::texture {
namespace {

/// The contacts of a set that push (sign = 1) or pull (sign = -1).
Items of_sign(const View& view, const Items& items, double sign) {
  Items kept;
  for (const std::size_t c : items)
    if (sign * view.pairs().fn[c] > 0) kept.push_back(c);
  return kept;
}

}  // namespace

/// Normal forces between grains, pushing and pulling ones apart (T Fig. 1.6, 1.9).
void measure_forces(const View& view, Texture& texture) {
  if (view.contacts.empty()) {
    texture.notes.push_back("No contact lies in the window, so coordination is zero and fabric and forces are left out.");
    return;
  }
  ByName<Items> sets{{"all", view.contacts}};
  for (auto& type : contacts_by_type(view)) sets.push_back(std::move(type));
  std::vector<double> pull = view.pairs().fn;
  for (double& f : pull) f = -f;
  double mean_pull = 0;
  for (const auto& [name, items] : sets) {
    if (const Items pushing = of_sign(view, items, 1); !pushing.empty())
      texture.force.compressive.emplace_back(name, distribution(pushing, view.contact_block, view.pairs().fn, view.mean_force));
    const Items pulling = of_sign(view, items, -1);
    if (pulling.empty()) continue;
    if (name == "all")
      for (const std::size_t c : pulling) mean_pull += pull[c] / static_cast<double>(pulling.size());
    texture.force.tensile.emplace_back(name, distribution(pulling, view.contact_block, pull, mean_pull));
  }
  texture.force.tensile_share = mean(view.contacts, view.contact_block, [&](std::size_t c) { return pull[c] > 0 ? 1.0 : 0.0; });
  texture.force.tensile_mean_ratio = view.mean_force > 0 ? mean_pull / view.mean_force : unknown;
}

}  // namespace arenite::texture
