#include <fmt/core.h>

#include <algorithm>
#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "grains/texture/partners.hpp"
#include "grains/texture/view.hpp"

namespace arenite::texture {
namespace {

/// Mean over the considered grains of material m (any material for m < 0) of a value of each.
template <int D, class Value> Estimate grain_mean(const ViewIn<D>& view, int m, Value value) {
  return mean(m < 0 ? view.grains : view.grains_of(m), view.grain_block, value);
}

/// Mean number of other grains that a grain touches, in however many contacts.
template <int D> Estimate neighbours(const ViewIn<D>& view) {
  const auto& contacts = view.pairs();
  std::vector<std::set<std::int32_t>> touched(view.packing.grains.size());
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    if (contacts.is_wall(c)) continue;
    touched[contacts.i[c]].insert(contacts.j[c]);
    touched[contacts.j[c]].insert(contacts.i[c]);
  }
  return mean(view.grains, view.grain_block, [&](std::size_t g) { return static_cast<double>(touched[g].size()); });
}

constexpr const char* mean_number = "Mean number of contacts per grain, of the named pair or set";

/// Of every material with every other one: neighbours of the second a grain of the first, and "POM-ANY" = (2 N_XX +
/// N_XY)/N_X.
template <int D> void put_by_material(Numbers& j, const ViewIn<D>& view, const Partners& partners) {
  const std::vector<int> materials = view.materials();
  ByName<Estimate> doubled, parts, share;
  const auto all = [&](std::size_t g) { return partners.all(g); };
  for (const int x : materials)
    for (const int y : materials)
      put(j, view.material_name(x) + "-" + view.material_name(y),
          grain_mean(view, x, [&](std::size_t g) { return partners.with(g, y); }), "", mean_number);
  for (const int x : materials) {
    const std::string any = view.material_name(x) + "-ANY";
    put(j, any, grain_mean(view, x, all), "", mean_number);
    doubled.emplace_back(any,
                         grain_mean(view, x, [&](std::size_t g) { return 2 * partners.all(g) - partners.with(g, x); }));
  }
  for (std::size_t a = 0; a < materials.size(); ++a)
    for (std::size_t b = a; b < materials.size(); ++b) {
      const int x = materials[a], y = materials[b];
      const auto ends = [&](std::size_t g) {
        return (view.material(g) == x ? partners.with(g, y) : 0.0) +
               (x != y && view.material(g) == y ? partners.with(g, x) : 0.0);
      };
      const std::string name = view.material_name(x) + "-" + view.material_name(y);
      parts.emplace_back(name, grain_mean(view, -1, ends));
      share.emplace_back(name, ratio_of_sums(view, ends, all));
    }
  put(j, "rattlers", grain_mean(view, -1, [&](std::size_t g) { return view.rattler[g] ? 1.0 : 0.0; }), "",
      fmt::format("Fraction of grains with fewer than {} force-bearing contacts", view.options.rattler_contacts)
          .c_str(),
      Trait::by_forces);
  put(j, "unlike_contacts_twice", doubled, "", "2 (N_XX + N_XY)/N_X (T 4.3.1)", Trait::detail);
  put(j, "parts_of_z", parts, "", "2 N_AB over all grains (T 5.3.1); the parts add up to z", Trait::detail);
  put(j, "share_of_contacts", share, "", "N_AB over all contacts", Trait::detail);
}

}  // namespace

/// Every considered grain brings the ends of its own contacts, so that N_AB is half the number of such ends and z of a
/// sample without border is 2 N_c/N_p; contacts with walls are not counted. Of grains that are no disks "all,
/// neighbours" as well, which counts two grains that meet in several contacts once.
template <int D> void coordination(const ViewIn<D>& view, TextureIn<D>& texture) {
  const Partners partners(view.packing, view.rattler);
  Numbers& j = texture.numbers["coordination"] = Numbers::tree();
  texture.per_grain.contacts = partners.of_each();
  if (!view.grains.empty()) {
    put(j, "all", grain_mean(view, -1, [&](std::size_t g) { return partners.all(g); }), "", mean_number);
    put(j, "without_rattlers", mean_without_rattlers(view, partners), "", mean_number, Trait::by_forces);
    if (!view.packing.grains.shapes.empty()) put(j, "all, neighbours", neighbours(view), "", mean_number);
    put_by_material(j, view, partners);
  }
  put(j, "histogram", partners.histogram(view.grains), "", "Fraction of grains with 0, 1, 2, .. contacts",
      Trait::detail);
}
template void coordination(const View&, Texture&);
template void coordination(const SphereView&, TextureIn<3>&);

}  // namespace arenite::texture
