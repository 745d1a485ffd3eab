#include "grains/texture/view.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <set>
#include <utility>

#include "core/error.hpp"
#include "core/tensor.hpp"
#include "geometry/ball_window.hpp"
#include "grains/texture/force_scale.hpp"
#include "grains/texture/loose_grains.hpp"
#include "grains/texture/spheres/tensor3.hpp"

namespace arenite::texture {
namespace {

void check_volume(const Domain& /*domain*/) {}
void check_volume(const DomainIn<3>& domain) {
  if (!(volume_of(domain) > 0)) throw InputError("the container of the spheres has no volume");
}

bool knows_box(const Domain& domain) { return domain.width() > 0 && domain.height() > 0; }
bool knows_box(const DomainIn<3>& domain) {
  return domain.is_cell() || std::ranges::any_of(domain.wall, &WallIn<3>::present);
}

bool knows_length(const Domain& domain) { return domain.thickness > 0; }
bool knows_length(const DomainIn<3>& /*domain*/) { return true; }

Window inner_window(const Domain& d, double border, bool has_box) {
  if (!has_box) return {};
  const double bx = d.periodic[0] ? 0 : border, by = d.periodic[1] ? 0 : border;
  const geometry::Rectangle box = box_of(d);
  return {{box.x_min + bx, box.x_max - bx, box.y_min + by, box.y_max - by}, true, std::max(bx, by)};
}

WindowIn<3> inner_window(const DomainIn<3>& domain, double border, bool has_box) {
  WindowIn<3> window{{domain.corner(), domain.size(), domain.periodic}, has_box, 0};
  if (!has_box) return window;
  for (int axis = 0; axis < 3; ++axis) {
    if (domain.periodic[axis]) continue;
    window.corner[axis] += border;
    window.size[axis] -= 2 * border;
    window.border = border;
  }
  return window;
}

/// Whether a place lies within, as far as walls bound it.
template <int D> bool holds(const WindowIn<D>& window, const DomainIn<D>& domain, Vec<D> place) {
  if (!window.known) return true;
  const Vec<D> low = low_of(window), high = high_of(window);
  for (int axis = 0; axis < D; ++axis)
    if (!domain.periodic[axis] && !(place[axis] >= low[axis] && place[axis] <= high[axis])) return false;
  return true;
}

/// What is cut into blocks.
geometry::Rectangle bounds_of(const View& view) {
  if (view.window.known) return view.window;
  const Grains& g = view.packing.grains;
  return g.size() == 0 ? geometry::Rectangle{} : geometry::bounds(g.position);
}
geometry::Box<3> bounds_of(const SphereView& view) { return view.window; }

/// Direction of greatest compression of the moment of all contacts, rad in [0, pi); vertical where nothing pushes.
double compression_axis(const Packing& packing) {
  const auto& contacts = packing.contacts;
  double difference = 0, shear = 0;
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    const Vec2 f = contacts.force_on_i(c);
    const bool disks = contacts.off_i.empty();
    const double d = disks ? contacts.arm_i[c] + contacts.arm_j[c] : 1;
    const Vec2 n = disks ? contacts.normal[c] : -contacts.branch(c);
    difference += d * (f.x * n.x - f.y * n.y);
    shear += d * (f.x * n.y + f.y * n.x);
  }
  if (difference == 0 && shear == 0) return std::numbers::pi / 2;
  const double axis = 0.5 * std::atan2(shear, difference);
  return axis < 0 ? axis + std::numbers::pi : axis;
}

Vec3 compression_axis(const PackingIn<3>& packing) {
  Tensor3 moment;
  for (std::size_t c = 0; c < packing.contacts.size(); ++c)
    moment += outer(packing.contacts.force_on_i(c), packing.contacts.branch(c));
  return spheres::principal(moment).direction[2];
}

bool gives_axis(const Options& options) { return options.load_axis.has_value(); }
bool gives_axis(const SphereOptions& options) { return options.load_axis || options.load_direction != Vec3{}; }

double axis_of(const View& view) { return view.options.load_axis.value_or(compression_axis(view.packing)); }
Vec3 axis_of(const SphereView& view) {
  if (const auto angle = view.options.load_axis) return {std::cos(*angle), std::sin(*angle), 0};
  if (view.axis_is_given) return view.options.load_direction;
  return view.has_forces ? compression_axis(view.packing) : Vec3{};
}

/// The kinds that some grains are of, in rising order.
template <class Kinds> std::vector<int> present(const Items& grains, const Kinds& kind) {
  std::set<int> found;
  for (const std::size_t g : grains) found.insert(kind[g]);
  return {found.begin(), found.end()};
}

/// A way to tell grains apart: the kind of every grain, and the kinds of considered grains with their names.
struct Sorting {
  std::vector<int> kind, kinds;
  std::vector<std::string> names;
};

/// By material and, where there are zones, by zone.
template <int D> std::vector<Sorting> sortings(const ViewIn<D>& view) {
  const GrainsIn<D>& g = view.packing.grains;
  Sorting material{{g.material.begin(), g.material.end()}, view.materials(), {}},
      zone{{g.zone.begin(), g.zone.end()}, present(view.grains, g.zone), {}};
  for (const int m : material.kinds) material.names.push_back(view.material_name(m));
  if (zone.kinds == std::vector{0}) return {material};
  for (const int z : zone.kinds) zone.names.push_back(z == 0 ? "dry" : z == 1 ? "glued" : "zone " + std::to_string(z));
  return {material, zone};
}

}  // namespace

Items known(const Items& items, const std::vector<double>& values) {
  return kept(items, [&](std::size_t item) { return std::isfinite(values[item]); });
}

double mean_of_known(const Items& items, const std::vector<double>& values) {
  const Items found = known(items, values);
  if (found.empty()) return unknown;
  double mean = 0;
  for (const std::size_t item : found) mean += values[item] / static_cast<double>(found.size());
  return mean;
}

template <int D>
double covered_by(const DomainIn<D>& domain, Vec<D> centre, double radius,
                  const std::type_identity_t<Region<D>>& window) {
  const Vec<D> reach = by_axis<D>([&](int) { return radius; });
  double covered = 0;
  for_images_between<D>(
      domain, low_of(window) - (centre + reach), high_of(window) - (centre - reach),
      [&](const Cells<D>& on) { covered += geometry::part_in(window, centre + domain.way(on), radius); });
  return covered;
}
template double covered_by<2>(const Domain&, Vec2, double, const geometry::Rectangle&);
template double covered_by<3>(const DomainIn<3>&, Vec3, double, const geometry::Box<3>&);

template <int D> ViewIn<D>::ViewIn(const PackingIn<D>& p, const OptionsIn<D>& o) : packing(p), options(o) {
  const DomainIn<D>& domain = packing.domain;
  const GrainsIn<D>& all = packing.grains;
  check_volume(domain);
  has_box = knows_box(domain);
  has_thickness = knows_length(domain);
  has_forces = texture::has_forces(pairs());
  mean_diameter = all.mean_diameter();

  window = inner_window(domain, options.border * mean_diameter, has_box);
  const auto take_grains = [&] {
    for (std::size_t g = 0; g < all.size(); ++g)
      if (holds(window, domain, all.position[g])) grains.push_back(g);
  };
  take_grains();
  if (grains.empty() && window.known) {  // a sample smaller than its border is taken whole
    window = inner_window(domain, 0, has_box);
    take_grains();
  }
  considered.assign(all.size(), 0);
  for (const std::size_t g : grains) considered[g] = 1;
  rattler =
      loose_grains(pairs(), all.size(), options.rattler_contacts, [&](std::size_t c) { return pairs().fn[c] != 0; });

  blocks = {bounds_of(*this), blocks_per_side<D>(grains.size())};
  for (std::size_t g = 0; g < all.size(); ++g)
    grain_block.push_back(blocks.block_of(domain.wrapped(all.position[g]), g));
  for (std::size_t c = 0; c < pairs().size(); ++c) {
    const Vec<D> point = contact_point(c);
    contact_block.push_back(blocks.block_of(point, c));
    if (!pairs().is_wall(c) && holds(window, domain, point)) contacts.push_back(c);
  }
  mean_force = mean_push(pairs(), contacts);
  axis_is_given = gives_axis(options);
  load_axis = axis_of(*this);
}

template <int D> Vec<D> ViewIn<D>::contact_point(std::size_t c) const {
  return packing.domain.wrapped(packing.grains.position[pairs().i[c]] + pairs().lever_i(c));
}

template <int D> std::string ViewIn<D>::material_name(int m) const {
  const auto index = static_cast<std::size_t>(m);
  return index < packing.materials.size() ? packing.materials[index].name : "material " + std::to_string(m);
}

template <int D> std::vector<int> ViewIn<D>::materials() const { return present(grains, packing.grains.material); }

template <int D> Items ViewIn<D>::grains_of(int m) const {
  return kept(grains, [&](std::size_t g) { return material(g) == m; });
}

template struct ViewIn<2>;
template struct ViewIn<3>;

template <int D> ByName<Items> contacts_by_type(const ViewIn<D>& view) {
  ByName<Items> sets;
  for (const Sorting& by : sortings(view))
    for (std::size_t a = 0; a < by.kinds.size(); ++a)
      for (std::size_t b = a; b < by.kinds.size(); ++b) {
        Items items = kept(view.contacts, [&](std::size_t c) {
          return std::minmax({by.kind[view.pairs().i[c]], by.kind[view.pairs().j[c]]}) ==
                 std::pair(by.kinds[a], by.kinds[b]);
        });
        if (!items.empty()) sets.emplace_back(by.names[a] + "-" + by.names[b], std::move(items));
      }
  return sets;
}

template ByName<Items> contacts_by_type(const View&);
template ByName<Items> contacts_by_type(const SphereView&);

template <int D> ByName<Items> grains_by_type(const ViewIn<D>& view) {
  ByName<Items> sets{{"all", view.grains}};
  for (const Sorting& by : sortings(view))
    for (std::size_t k = 0; k < by.kinds.size(); ++k)
      sets.emplace_back(by.names[k], kept(view.grains, [&](std::size_t g) { return by.kind[g] == by.kinds[k]; }));
  return sets;
}
template ByName<Items> grains_by_type(const View&);
template ByName<Items> grains_by_type(const SphereView&);

}  // namespace arenite::texture
