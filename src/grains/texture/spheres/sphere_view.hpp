#pragma once
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "geometry/rectangle.hpp"
#include "grains/texture/spheres/spheres.hpp"
#include "grains/texture/spheres/tensor3.hpp"
#include "grains/texture/view.hpp"
#include "statistics/jackknife.hpp"

namespace arenite::texture::spheres {

/// A box cut into k x k x k equal blocks, as BlockGrid does a rectangle.
struct BlockCube {
  geometry::Box<3> bounds;
  int per_side = 1;
  int count() const { return per_side * per_side * per_side; }
  /// Points outside belong to the nearest block; where the box is too small to be cut every item is its own.
  int block_of(Vec3 place, std::size_t item) const;
  geometry::Box<3> block(int b) const;
};

/// What the statistics of spheres share, as View of those of disks: contacts with walls count for stress and balance
/// alone.
struct SphereView {
  SphereView(const PackingIn<3>& packing, const SphereOptions& options);

  const PackingIn<3>& packing;
  const SphereOptions& options;
  bool has_box = false;     ///< else the container is but the smallest box around the spheres
  bool has_forces = false;  ///< some contact has one; else nobody knows them
  double mean_diameter = 0;
  geometry::Box<3> window;             ///< the container without the border along its walls
  double border = 0;                   ///< m
  statistics::Items grains, contacts;  ///< considered: centre, or contact point, in the window
  std::vector<std::uint8_t> rattler;   ///< by sphere
  BlockCube blocks;
  std::vector<int> grain_block, contact_block;
  double mean_force = 0;       ///< of considered contacts that push, N
  bool axis_is_given = false;  ///< by the options; else it is the sample's own
  Vec3 load_axis;              ///< as the options say it, or that of greatest compression; 0 where neither is known

  const ContactsIn<3>& pairs() const { return packing.contacts; }
  std::string material_name(int m) const { return name_of_material(packing.materials, m); }
  std::vector<int> materials() const;  ///< those of considered spheres, in rising order
  statistics::Items grains_of(int m) const;
};

/// A statistic of spheres, one file each; the list is in spheres.cpp.
using SphereStatistic = void(const SphereView& view, Numbers& to);

/// How many other spheres each touches; walls do not count, as in the coordination.
std::vector<std::int32_t> contacts_with_spheres(const PackingIn<3>& packing);

/// Calls `see` for what joins two spheres beside their contact, bonds that hold and pulls across gaps: both, the force
/// on the first, N, and the way to it from the second, m.
using SeeJoint = std::function<void(std::size_t, std::size_t, Vec3 force, Vec3 branch)>;
void each_joint(const PackingIn<3>& packing, const SeeJoint& see);

/// Internal moments of all spheres, N m: sum over their contacts of force (x) lever.
std::vector<Tensor3> sphere_moments(const PackingIn<3>& packing);
/// Hydrostatic stress of each, its moment over its volume, tension positive, Pa.
std::vector<double> hydrostatic_stresses(const PackingIn<3>& packing);

}  // namespace arenite::texture::spheres
