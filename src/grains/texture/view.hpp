#pragma once
#include <string>
#include <vector>

#include "model/packing.hpp"
#include "grains/texture/blocks.hpp"
#include "grains/texture/texture.hpp"

namespace arenite::texture {

/// What the statistics share: which grains and contacts count, in which block each lies, and the mean force.
/// Contacts with walls count for stress and balance, never for coordination, fabric or force statistics.
struct View {
  View(const Packing& packing, const Options& options);

  const Packing& packing;
  const Options& options;
  bool has_box = false, has_thickness = false;
  double mean_diameter = 0;
  Window window;
  Items grains;                        ///< considered: centre in the window
  Items contacts;                      ///< considered: between grains, contact point in the window
  std::vector<std::uint8_t> considered;  ///< by grain
  std::vector<std::uint8_t> rattler;     ///< by grain
  BlockGrid blocks;                    ///< over the window
  std::vector<int> grain_block, contact_block;  ///< by grain, by contact
  double mean_force = 0;               ///< of considered contacts that push, N; 0 if none does
  double load_axis = 0;                ///< rad

  const Contacts& pairs() const { return packing.contacts; }
  Vec2 contact_point(std::size_t c) const;  ///< in the periodic cell
  bool strong(std::size_t c) const { return pairs().fn[c] > mean_force; }
  int material(std::size_t grain) const { return packing.grains.material[grain]; }
  std::string material_name(int m) const;
  std::vector<int> materials() const;  ///< those of considered grains, in rising order
};

/// Named sets of considered contacts by material pair ("POM-HDPE", in the order of materials) and, where there are
/// zones, by zone pair ("dry-glued"); sets without contacts are left out.
ByName<Items> contacts_by_type(const View& view);

/// Named sets of considered grains: "all", by material, by zone ("dry", "glued") where there are zones.
ByName<Items> grains_by_type(const View& view);

/// The items whose value is known, and the mean over these; NaN if there are none.
Items known(const Items& items, const std::vector<double>& values);
double mean_of_known(const Items& items, const std::vector<double>& values);

/// A point moved into the periodic cell; unchanged along sides that are not periodic.
Vec2 wrapped(const Domain& domain, Vec2 point);

/// Area of a disk inside a rectangle, periodic images of the disk included.
double covered_area(const Domain& domain, Vec2 centre, double radius, const geometry::Rectangle& window);

/// The box as a rectangle.
geometry::Rectangle box_of(const Domain& domain);

}  // namespace arenite::texture
