#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <string>
#include <type_traits>
#include <vector>

#include "core/problems.hpp"
#include "grains/texture/blocks.hpp"
#include "grains/texture/texture.hpp"
#include "model/periodic_images.hpp"
#include "statistics/jackknife.hpp"

namespace arenite::texture {

using statistics::ByName;
using statistics::described;
using statistics::half_turn;
using statistics::Items;
using statistics::jackknife;
using statistics::jackknife_of_sums;
using statistics::mean;
using statistics::put;
using statistics::put_angle;
using statistics::standard_error;
using statistics::whole_turn;

/// Direction of a load without a sense: rad from x, in space a vector.
template <int D> using Axis = std::conditional_t<D == 2, double, Vec3>;

/// What the statistics of disks and of spheres share: which grains and contacts count, in which block each lies, and
/// the mean force. Contacts with walls count for stress and balance, never for coordination, fabric or force
/// statistics.
template <int D> struct ViewIn {
  ViewIn(const PackingIn<D>& packing, const OptionsIn<D>& options);

  const PackingIn<D>& packing;
  const OptionsIn<D>& options;
  bool has_box = false, has_thickness = false;
  bool has_forces = false;  ///< some contact has one; else nobody knows them
  double mean_diameter = 0;
  WindowIn<D> window;
  Items grains;                                 ///< considered: centre in the window
  Items contacts;                               ///< considered: between grains, contact point in the window
  std::vector<std::uint8_t> considered;         ///< by grain
  std::vector<std::uint8_t> rattler;            ///< by grain
  BlockGridIn<D> blocks;                        ///< over the window
  std::vector<int> grain_block, contact_block;  ///< by grain, by contact
  double mean_force = 0;                        ///< of considered contacts that push, N; 0 if none does
  bool axis_is_given = false;                   ///< by the options; else it is that of greatest compression
  Axis<D> load_axis{};                          ///< in space 0 where nothing tells it

  /// Scatter of the pressure of a sample in motion over its mean in time, which all mean forces and stresses share; 0
  /// at rest.
  double level() const { return options.in_time ? options.in_time->pressure : 0; }
  const ContactsIn<D>& pairs() const { return packing.contacts; }
  Vec<D> contact_point(std::size_t c) const;  ///< in the periodic cell
  bool strong(std::size_t c) const { return pairs().fn[c] > mean_force; }
  int material(std::size_t grain) const { return packing.grains.material[grain]; }
  std::string material_name(int m) const;  ///< or "material 3" where it has none
  std::vector<int> materials() const;      ///< those of considered grains, in rising order
  Items grains_of(int m) const;            ///< considered ones of material m
};
using View = ViewIn<2>;
using SphereView = ViewIn<3>;

/// Named sets of considered contacts by material pair ("POM-HDPE", in the order of materials) and, where there are
/// zones, by zone pair ("dry-glued"); sets without contacts are left out.
template <int D> ByName<Items> contacts_by_type(const ViewIn<D>& view);

/// Named sets of considered grains: "all", by material, by zone ("dry", "glued") where there are zones.
template <int D> ByName<Items> grains_by_type(const ViewIn<D>& view);

/// Refuses a grain wider than a periodic cell: it covers itself, and the cell as often as it pleases.
template <int D> void check_widths(const PackingIn<D>& packing) {
  const DomainIn<D>& domain = packing.domain;
  const GrainsIn<D>& grains = packing.grains;
  for (std::size_t g = 0; g < grains.size(); ++g)
    for (int axis = 0; axis < D; ++axis)
      if (const double side = domain.extent(axis);
          domain.periodic[axis] && side > 0 && !(2 * grains.radius[g] <= (1 + 1e-9) * side))
        throw refusal(
            "grain {} is {:.4g} m wide in a periodic cell of {:.4g} m, so it would overlap itself; correct the unit of "
            "the radii, or the cell",
            grains.id[g], 2 * grains.radius[g], side);
}

/// The items that something holds for.
template <class Holds> Items kept(const Items& items, const Holds& holds) {
  Items some;
  std::ranges::copy_if(items, std::back_inserter(some), holds);
  return some;
}

/// Mean force of those contacts that push; 0 if none does.
template <class AnyContacts> double mean_push(const AnyContacts& pairs, const Items& contacts) {
  double sum = 0;
  std::size_t pushing = 0;
  for (const std::size_t c : contacts)
    if (pairs.fn[c] > 0) sum += pairs.fn[c], ++pushing;
  return pushing > 0 ? sum / static_cast<double>(pushing) : 0;
}

/// The items whose value is known, and the mean over these; NaN if there are none.
Items known(const Items& items, const std::vector<double>& values);
double mean_of_known(const Items& items, const std::vector<double>& values);

/// Area of a disk, volume of a sphere, inside a window, periodic images of the grain included, m^D.
template <int D>
double covered_by(const DomainIn<D>& domain, Vec<D> centre, double radius,
                  const std::type_identity_t<Region<D>>& window);

/// Where the numbers of a set go: those of "all" stand by themselves, those of the others in a group.
inline Numbers& place_of(const std::string& set, Numbers& to, const char* group) {
  return set == "all" ? to : to[group][set];
}

/// A statistic, one file each; the list is in texture.cpp. It puts its numbers among Texture::numbers, each with its
/// unit and what it is. What it cannot compute it leaves out, with a note that says why.
template <int D> using StatisticIn = void(const ViewIn<D>& view, TextureIn<D>& texture);
using Statistic = StatisticIn<2>;

}  // namespace arenite::texture
