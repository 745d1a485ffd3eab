#include "grains/texture/texture.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <span>
#include <string>
#include <utility>

#include "core/problems.hpp"
#include "grains/texture/force_scale.hpp"
#include "grains/texture/solid_fraction.hpp"
#include "grains/texture/view.hpp"

namespace arenite::texture {

// Each in its own file.
Statistic threshold, local_order, long_axes;
template <int D> void solid_fraction(const ViewIn<D>& view, TextureIn<D>& texture);
template <int D> void grain_stress(const ViewIn<D>& view, TextureIn<D>& texture);
template <int D> void fabric(const ViewIn<D>& view, TextureIn<D>& texture);
template <int D> void coordination(const ViewIn<D>& view, TextureIn<D>& texture);
template <int D> void stress(const ViewIn<D>& view, TextureIn<D>& texture);
template <int D> void forces(const ViewIn<D>& view, TextureIn<D>& texture);
template <int D> void sigma_norm(const ViewIn<D>& view, TextureIn<D>& texture);
template <int D> void quality(const ViewIn<D>& view, TextureIn<D>& texture);

namespace {

/// Whether signs refer to some direction.
bool has_axis(const View& /*view*/) { return true; }
bool has_axis(const SphereView& view) { return view.load_axis != Vec3{}; }

void put_dimension(const View& /*view*/, Numbers& /*to*/) {}
void put_dimension(const SphereView& /*view*/, Numbers& to) { put(to, "dimension", 3, "", "Of space: 3, spheres"); }

template <int D> void sample(const ViewIn<D>& view, TextureIn<D>& texture) {
  const ContactsIn<D>& contacts = view.pairs();
  const DomainIn<D>& domain = view.packing.domain;
  const auto walls = static_cast<std::size_t>(std::ranges::count_if(contacts.j, arenite::is_wall));
  texture.window = view.window;
  texture.mean_diameter = view.mean_diameter;
  texture.per_grain.considered = view.considered;
  texture.per_grain.rattler = view.rattler;
  put_dimension(view, texture.numbers);
  texture.numbers.update(
      {{"grains", described(view.packing.grains.size(), "", "Grains of the sample")},
       {"contacts", described(contacts.size() - walls, "", "Contacts between grains")},
       {"wall_contacts", described(walls, "", "Contacts with walls")},
       {"considered",
        {{"grains", described(view.grains.size(), "", "Grains in the window of the statistics")},
         {"contacts", described(view.contacts.size(), "", "Contacts in that window")},
         {"border_m", described(view.window.border, "m", "Strip left out along walls").mark(Trait::detail)}}},
       {"mean_diameter_m", described(view.mean_diameter, "m", "Mean diameter of grains")}});
  if (!view.has_box)
    texture.notes.push_back(
        "The box is not known, so solid fraction, REV and the stress of the assembly are omitted and no border is left "
        "out.");
  else if (auto note = note_of_sides_away<D>(domain); !note.empty()) texture.notes.push_back(std::move(note));
  if (!view.has_thickness)
    texture.notes.push_back("The out-of-plane length is not known, so stresses in Pa are left out.");
  if (!view.axis_is_given && has_axis(view) && !view.contacts.empty())
    texture.notes.push_back(
        "The direction of the load is not given: signed anisotropies refer to the sample's own axis of greatest "
        "compression, for which even a random network gives a positive value.");
  const bool walled = view.has_box && !std::ranges::all_of(domain.periodic, std::identity());
  if (walled && view.options.border > 0 && view.window.border == 0)
    texture.notes.push_back(
        fmt::format("The sample is too small to leave out {:g} mean diameters along its walls, so it is taken whole.",
                    view.options.border));
}

/// Every statistic that there is, in the order of their numbers. Grain stress comes first, because the normalised
/// stress builds on it.
constexpr Statistic* in_plane[] = {sample, grain_stress, solid_fraction, coordination, fabric, threshold, stress,
                                   forces, sigma_norm,   local_order,    long_axes,    rev,    quality};
constexpr StatisticIn<3>* in_space[] = {sample, grain_stress, solid_fraction, rev,        coordination,
                                        fabric, stress,       forces,         sigma_norm, quality};
std::span<Statistic* const> statistics_of(const Packing& /*packing*/) { return in_plane; }
std::span<StatisticIn<3>* const> statistics_of(const PackingIn<3>& /*packing*/) { return in_space; }

Numbers rows(const PerGrain& g) {
  Numbers j{{"considered", g.considered},
            {"rattler", g.rattler},
            {"contacts", g.contacts},
            {"sigma_norm", g.sigma_norm},
            {"psi6", g.psi6}};
  if (!g.sigma_hyd.empty()) j["sigma_hyd_Pa"] = g.sigma_hyd;
  if (!g.sigma.empty()) j["sigma_Pa"] = g.sigma;
  return j;
}

/// Leaves what places alone tell: strength, rattlers, anisotropies of forces, stresses and their signs go.
template <int D> void forget_forces(TextureIn<D>& t) {
  erase(t.numbers, Trait::by_forces);
  std::fill(t.per_grain.rattler.begin(), t.per_grain.rattler.end(), std::uint8_t{0});
  t.per_grain.sigma.clear();
  t.per_grain.sigma_hyd.clear();
  t.per_grain.sigma_norm.assign(t.per_grain.sigma_norm.size(), unknown);
  t.notes.emplace_back(forces_not_known);
}

}  // namespace

template <int D> TextureIn<D> measure(const PackingIn<D>& packing, const OptionsIn<D>& options) {
  check_widths(packing);
  const std::size_t measured = options.grain_sigma_hyd.size();
  if (measured > 0 && measured != packing.grains.size())
    throw refusal("sigma_hyd has {} values for {} grains; give one per grain, NaN where it is not known", measured,
                  packing.grains.size());
  const bool forceless = measured == 0 && packing.contacts.size() > 0 && !has_forces(packing.contacts);
  OptionsIn<D> used = options;
  if (forceless) used.rattler_contacts = 0;
  TextureIn<D> texture;
  const ViewIn<D> view(packing, used);
  for (StatisticIn<D>* statistic : statistics_of(packing)) statistic(view, texture);
  if (forceless) forget_forces(texture);
  return texture;
}
template Texture measure(const Packing&, const Options&);
template TextureIn<3> measure(const PackingIn<3>&, const SphereOptions&);

template <int D> TextureIn<D> grain_rows(const PackingIn<D>& packing, const OptionsIn<D>& options) {
  const ViewIn<D> view(packing, options);
  TextureIn<D> texture;
  texture.window = view.window;
  texture.mean_diameter = view.mean_diameter;
  texture.per_grain.considered = view.considered;
  grain_stress(view, texture);
  return texture;
}
template Texture grain_rows(const Packing&, const Options&);
template TextureIn<3> grain_rows(const PackingIn<3>&, const SphereOptions&);

Numbers stress_distribution(const Packing& packing, const std::vector<double>& sigma_hyd) {
  Options options;
  options.grain_sigma_hyd = sigma_hyd;
  const View view(packing, options);
  Texture texture;
  grain_stress(view, texture);
  sigma_norm(view, texture);
  return texture.numbers.value("sigma_norm", Numbers::tree());
}

Numbers numbers(const Texture& t, bool curves) {
  Numbers j = t.numbers;
  if (!curves) erase(j, Trait::curve);
  j["notes"] = t.notes;
  if (curves) j["by_grain"] = rows(t.per_grain);
  return j;
}

std::string to_text(const Texture& t) {
  Numbers shown = numbers(t);
  erase(shown, Trait::detail);
  return arenite::to_text(shown);
}

}  // namespace arenite::texture
