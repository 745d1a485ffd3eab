#include <fmt/format.h>

#include <algorithm>

#include "thermal/camera/camera.hpp"
#include "thermal/camera/patch.hpp"
#include "core/error.hpp"
#include "model/elasticity/disk_field.hpp"

namespace arenite::camera {
namespace {

/// The grains of a packing as disks under their contact forces.
std::vector<elasticity::Disk> loaded_disks(const Packing& packing, double arc) {
  std::vector<elasticity::Disk> disks(packing.grains.size());
  for (std::size_t i = 0; i < disks.size(); ++i) {
    disks[i].radius = packing.grains.radius[i];
    disks[i].length = packing.domain.thickness;
    disks[i].traction = arc > 0 ? elasticity::Traction::elliptic : elasticity::Traction::point;
  }
  const auto& contacts = packing.contacts;
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    const Vec2 n = contacts.normal(c);
    disks[static_cast<std::size_t>(contacts.i[c])].forces.push_back({n, contacts.fn[c], contacts.ft[c], arc});
    if (!contacts.is_wall(c)) disks[static_cast<std::size_t>(contacts.j[c])].forces.push_back({-n, contacts.fn[c], contacts.ft[c], arc});
  }
  return disks;
}

Patch patch_of(const elasticity::Disk* low, const elasticity::Disk& high, double cell) {
  return fill_patch(high.radius, cell, [&](Vec2 at, double away) {
    // Cells on the rim and beyond it hold what its nearest point has.
    if (away > high.radius - 0.71 * cell) at = (high.radius - 0.71 * cell) / away * at;
    return elasticity::square_mean(high, at, cell) - (low ? elasticity::square_mean(*low, at, cell) : 0.0);
  });
}

void require_factors(const Packing& packing) {
  for (const auto m : packing.grains.material)
    if (packing.materials[static_cast<std::size_t>(m)].thermoelastic_factor <= 0)
      throw InputError(fmt::format("material {}: its thermoelastic factor is not known; set thermoelastic_factor = \"... K/MPa\" in the recipe",
                                   packing.materials[static_cast<std::size_t>(m)].name));
}

Scene make_scene(const Packing* low, const Packing& high, const Parameters& p) {
  require_factors(high);
  check_points(high.grains, high.grains.size(), p.optics);
  const Packing& start = low ? *low : high;
  Scene scene{start.grains, {}, {}, start.domain, high.domain, high.materials};
  const auto pressed = loaded_disks(high, p.contact_arc);
  const auto released = low ? loaded_disks(*low, p.contact_arc) : std::vector<elasticity::Disk>{};
  const double cell = p.optics.pixel / static_cast<double>(p.optics.supersampling);
  for (std::size_t i = 0; i < pressed.size(); ++i) {
    scene.travel.push_back(high.grains.centre(i) - start.grains.centre(i));
    scene.swing.push_back(patch_of(low ? &released[i] : nullptr, pressed[i], cell));
  }
  return scene;
}

}  // namespace

void check_points(const Grains& grains, std::size_t count, const Optics& optics) {
  const double cell = optics.pixel / static_cast<double>(optics.supersampling);
  double points = 0;
  for (std::size_t g = 0; g < count; ++g) points += 4 * (grains.radius[g] / cell) * (grains.radius[g] / cell);
  if (!(points <= most_points))
    throw InputError(fmt::format("pixels of {:.3g} mm with {} x {} points each lay {:.2g} points over the grains, too many to look at; raise camera.pixel or "
                                 "lower supersampling", 1e3 * optics.pixel, optics.supersampling, optics.supersampling, points));
}

float Patch::at(double x, double y) const {
  const double u = std::clamp(x / cell + 0.5 * (cells - 1), 0.0, cells - 1.001), v = std::clamp(y / cell + 0.5 * (cells - 1), 0.0, cells - 1.001);
  const auto c = static_cast<std::size_t>(u), r = static_cast<std::size_t>(v), n = static_cast<std::size_t>(cells);
  const auto fx = static_cast<float>(u - static_cast<double>(c)), fy = static_cast<float>(v - static_cast<double>(r));
  const float* at = value.data() + r * n + c;
  return (1 - fy) * ((1 - fx) * at[0] + fx * at[1]) + fy * ((1 - fx) * at[n] + fx * at[n + 1]);
}

Scene scene_between(const Packing& low, const Packing& high, const Parameters& parameters) {
  if (low.grains.radius != high.grains.radius || low.grains.material != high.grains.material)
    throw InputError(fmt::format("the two states do not hold the same grains ({} and {}); take them from one run", low.grains.size(), high.grains.size()));
  return make_scene(&low, high, parameters);
}

Scene scene_of_state(const Packing& state, const Parameters& parameters) { return make_scene(nullptr, state, parameters); }

}  // namespace arenite::camera
