#include "grains/texture/spheres/sphere_view.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <set>

#include "core/error.hpp"
#include "grains/texture/force_scale.hpp"
#include "grains/texture/loose_grains.hpp"
#include "grains/texture/partners.hpp"

namespace arenite::texture::spheres {
namespace {

geometry::Box<3> inner_window(const DomainIn<3>& domain, double border) {
  geometry::Box<3> window{domain.corner(), domain.size(), domain.periodic};
  for (int axis = 0; axis < 3; ++axis) {
    if (domain.periodic[axis]) continue;
    window.corner[axis] += border;
    window.size[axis] -= 2 * border;
  }
  return window;
}

bool holds(const geometry::Box<3>& window, Vec3 place) {
  for (int axis = 0; axis < 3; ++axis)
    if (!window.periodic[axis] &&
        (place[axis] < window.corner[axis] || place[axis] > window.corner[axis] + window.size[axis]))
      return false;
  return true;
}

/// Direction of greatest compression of the moment of all contacts.
Vec3 compression_axis(const PackingIn<3>& packing) {
  Tensor3 moment;
  for (std::size_t c = 0; c < packing.contacts.size(); ++c)
    moment += outer(packing.contacts.force_on_i(c), packing.contacts.branch(c));
  return principal(moment).direction[2];
}

}  // namespace

int BlockCube::block_of(Vec3 place, std::size_t item) const {
  if (per_side == 1) return static_cast<int>(item);
  int block = 0;
  for (int axis = 2; axis >= 0; --axis) {
    const double share = (place[axis] - bounds.corner[axis]) / bounds.size[axis];
    block = block * per_side + static_cast<int>(std::clamp(std::floor(share * per_side), 0.0, per_side - 1.0));
  }
  return block;
}

geometry::Box<3> BlockCube::block(int b) const {
  const Vec3 size = bounds.size / per_side;
  const int index[] = {b % per_side, b / per_side % per_side, b / per_side / per_side};
  return {bounds.corner + by_axis<3>([&](int axis) { return index[axis] * size[axis]; }), size};
}

SphereView::SphereView(const PackingIn<3>& p, const SphereOptions& o) : packing(p), options(o) {
  const DomainIn<3>& domain = packing.domain;
  if (!(volume_of(domain) > 0)) throw InputError("the container of the spheres has no volume");
  check_widths(packing);
  const GrainsIn<3>& all = packing.grains;
  has_box = domain.is_cell() || std::ranges::any_of(domain.wall, &WallIn<3>::present);
  has_forces = texture::has_forces(pairs());
  mean_diameter = all.mean_diameter();
  const auto take_grains = [&] {
    for (std::size_t g = 0; g < all.size(); ++g)
      if (holds(window, all.position[g])) grains.push_back(g);
  };
  border = has_box ? options.border * mean_diameter : 0;
  window = inner_window(domain, border);
  if (window.size.x > 0 && window.size.y > 0 && window.size.z > 0) take_grains();
  if (grains.empty()) {  // a sample smaller than its border is taken whole
    border = 0;
    window = inner_window(domain, 0);
    take_grains();
  }
  if (domain.periodic == std::array{true, true, true}) border = 0;
  rattler =
      loose_grains(pairs(), all.size(), options.rattler_contacts, [&](std::size_t c) { return pairs().fn[c] != 0; });
  blocks = {window, std::clamp(static_cast<int>(std::cbrt(static_cast<double>(grains.size()) / 12)), 1, 4)};
  for (std::size_t g = 0; g < all.size(); ++g)
    grain_block.push_back(blocks.block_of(domain.wrapped(all.position[g]), g));
  for (std::size_t c = 0; c < pairs().size(); ++c) {
    const Vec3 point = domain.wrapped(all.position[pairs().i[c]] + pairs().lever_i(c));
    contact_block.push_back(blocks.block_of(point, c));
    if (pairs().is_wall(c) || !holds(window, point)) continue;
    contacts.push_back(c);
  }
  mean_force = mean_push(pairs(), contacts);
  axis_is_given = options.load_axis || options.load_direction != Vec3{};
  if (options.load_axis) load_axis = {std::cos(*options.load_axis), std::sin(*options.load_axis), 0};
  else if (axis_is_given) load_axis = options.load_direction;
  else if (has_forces) load_axis = compression_axis(packing);
}

std::vector<int> SphereView::materials() const {
  std::set<int> found;
  for (const std::size_t g : grains) found.insert(packing.grains.material[g]);
  return {found.begin(), found.end()};
}

statistics::Items SphereView::grains_of(int m) const {
  return kept(grains, [&](std::size_t g) { return packing.grains.material[g] == m; });
}

std::vector<std::int32_t> contacts_with_spheres(const PackingIn<3>& packing) {
  const Partners partners(packing, std::vector<std::uint8_t>(packing.grains.size(), 0));
  std::vector<std::int32_t> count;
  for (std::size_t g = 0; g < packing.grains.size(); ++g) count.push_back(static_cast<std::int32_t>(partners.all(g)));
  return count;
}

void each_joint(const PackingIn<3>& packing, const SeeJoint& see) {
  for (const BondIn<3>& bond : packing.bonds)
    if (bond.broken == BondBreak::none)
      see(static_cast<std::size_t>(bond.i), static_cast<std::size_t>(bond.j), force_on_i(packing, bond),
          branch_of(packing, bond));
  for (const CohesivePair& pair : packing.cohesive)
    if (acts_across_gap(pair))
      see(static_cast<std::size_t>(pair.i), static_cast<std::size_t>(pair.j), force_on_i(packing, pair),
          branch_of(packing, pair));
}

std::vector<Tensor3> sphere_moments(const PackingIn<3>& packing) {
  const ContactsIn<3>& contacts = packing.contacts;
  std::vector<Tensor3> moments(packing.grains.size());
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    const Vec3 force = contacts.force_on_i(c);
    moments[contacts.i[c]] += outer(force, contacts.lever_i(c));
    if (!contacts.is_wall(c)) moments[contacts.j[c]] += outer(-force, contacts.lever_j(c));
  }
  each_joint(packing, [&](std::size_t i, std::size_t j, Vec3 force, Vec3 branch) {
    const double share = packing.grains.radius[i] / (packing.grains.radius[i] + packing.grains.radius[j]);
    moments[i] += outer(force, -share * branch);
    moments[j] += outer(-force, (1 - share) * branch);
  });
  return moments;
}

std::vector<double> hydrostatic_stresses(const PackingIn<3>& packing) {
  std::vector<double> stresses;
  for (const Tensor3& moment : sphere_moments(packing)) {
    const double r = packing.grains.radius[stresses.size()];
    stresses.push_back(trace(moment) / (4 * std::numbers::pi * r * r * r));
  }
  return stresses;
}

}  // namespace arenite::texture::spheres
