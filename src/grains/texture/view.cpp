#include "grains/texture/view.hpp"

#include <cmath>
#include <cstdint>
#include <numbers>
#include <set>
#include <utility>

#include "geometry/union_area.hpp"
#include "grains/texture/loose_grains.hpp"

namespace arenite::texture {
namespace {

Window inner_window(const Domain& d, double border, bool has_box) {
  if (!has_box) return {};
  const double bx = d.periodic[0] ? 0 : border, by = d.periodic[1] ? 0 : border;
  const geometry::Rectangle box = box_of(d);
  return {{box.x_min + bx, box.x_max - bx, box.y_min + by, box.y_max - by}, true, std::max(bx, by)};
}

geometry::Rectangle bounds_of(const View& view) {
  if (view.window.known) return view.window;
  const Grains& g = view.packing.grains;
  return g.size() == 0 ? geometry::Rectangle{} : geometry::bounds(g.position);
}

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
std::vector<Sorting> sortings(const View& view) {
  const Grains& g = view.packing.grains;
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

double covered_area(const Domain& domain, Vec2 centre, double radius, const geometry::Rectangle& window) {
  if (!domain.is_cell()) return geometry::disk_window_area(centre, radius, window);
  double area = 0;
  for_each_image(domain, geometry::square_about(centre, radius), window, [&](const ImageShift& image) {
    area += geometry::disk_window_area(centre + image.shift, radius, window);
  });
  return area;
}

View::View(const Packing& p, const Options& o) : packing(p), options(o) {
  const Domain& domain = packing.domain;
  const Grains& all = packing.grains;
  has_box = domain.width() > 0 && domain.height() > 0;
  has_thickness = domain.thickness > 0;
  mean_diameter = all.mean_diameter();

  window = inner_window(domain, options.border * mean_diameter, has_box);
  const auto inside = [&](Vec2 q) {
    return !window.known || ((domain.periodic[0] || (q.x >= window.x_min && q.x <= window.x_max)) &&
                             (domain.periodic[1] || (q.y >= window.y_min && q.y <= window.y_max)));
  };
  const auto take_grains = [&] {
    for (std::size_t g = 0; g < all.size(); ++g)
      if (inside(all.position[g])) grains.push_back(g);
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

  blocks = {bounds_of(*this), blocks_per_side(grains.size())};
  for (std::size_t g = 0; g < all.size(); ++g)
    grain_block.push_back(blocks.block_of(domain.wrapped(all.position[g]), g));
  for (std::size_t c = 0; c < pairs().size(); ++c) {
    const Vec2 point = contact_point(c);
    contact_block.push_back(blocks.block_of(point, c));
    if (!pairs().is_wall(c) && inside(point)) contacts.push_back(c);
  }
  mean_force = mean_push(pairs(), contacts);
  load_axis = options.load_axis.value_or(compression_axis(packing));
}

Vec2 View::contact_point(std::size_t c) const {
  return packing.domain.wrapped(packing.grains.position[pairs().i[c]] + pairs().lever_i(c));
}

std::string name_of_material(const Materials& materials, int m) {
  const auto index = static_cast<std::size_t>(m);
  return index < materials.size() ? materials[index].name : "material " + std::to_string(m);
}

std::vector<int> View::materials() const { return present(grains, packing.grains.material); }

Items View::grains_of(int m) const {
  return kept(grains, [&](std::size_t g) { return material(g) == m; });
}

ByName<Items> contacts_by_type(const View& view) {
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

ByName<Items> grains_by_type(const View& view) {
  ByName<Items> sets{{"all", view.grains}};
  for (const Sorting& by : sortings(view))
    for (std::size_t k = 0; k < by.kinds.size(); ++k)
      sets.emplace_back(by.names[k], kept(view.grains, [&](std::size_t g) { return by.kind[g] == by.kinds[k]; }));
  return sets;
}

}  // namespace arenite::texture
