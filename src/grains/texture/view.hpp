#pragma once
#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <string>
#include <vector>

#include "geometry/rectangle.hpp"
#include "grains/texture/texture.hpp"
#include "model/periodic_images.hpp"
#include "statistics/jackknife.hpp"

namespace arenite::texture {

using statistics::ByName;
using statistics::described;
using statistics::Items;
using statistics::jackknife;
using statistics::jackknife_of_sums;
using statistics::mean;
using statistics::put;
using statistics::standard_error;

/// A rectangle cut into k x k equal blocks. Neighbouring grains and contacts are not independent, so errors come from
/// the scatter between blocks, not between grains.
struct BlockGrid {
  geometry::Rectangle bounds;
  int per_side = 1;

  int count() const { return per_side * per_side; }
  /// Points outside belong to the nearest block.
  int block_of(Vec2 p) const {
    const auto along = [&](double x, double low, double width) {
      const double share = width > 0 ? (x - low) / width : 0;
      return static_cast<int>(std::clamp(std::floor(share * per_side), 0.0, per_side - 1.0));
    };
    return along(p.y, bounds.y_min, bounds.height()) * per_side + along(p.x, bounds.x_min, bounds.width());
  }
  /// That of an item there; where the rectangle is too small to be cut every item is its own.
  int block_of(Vec2 p, std::size_t item) const { return per_side > 1 ? block_of(p) : static_cast<int>(item); }
  geometry::Rectangle block(int b) const {
    const double w = bounds.width() / per_side, h = bounds.height() / per_side;
    const int column = b % per_side, row = b / per_side;
    return {bounds.x_min + column * w, bounds.x_min + (column + 1) * w, bounds.y_min + row * h,
            bounds.y_min + (row + 1) * h};
  }
};

/// Blocks of about a dozen grains or more, 6 x 6 at most; 1 for a sample too small to be cut.
inline int blocks_per_side(std::size_t grains) {
  return std::clamp(static_cast<int>(std::sqrt(static_cast<double>(grains) / 12)), 1, 6);
}

/// What the statistics share: which grains and contacts count, in which block each lies, and the mean force. Contacts
/// with walls count for stress and balance, never for coordination, fabric or force statistics.
struct View {
  View(const Packing& packing, const Options& options);

  const Packing& packing;
  const Options& options;
  bool has_box = false, has_thickness = false;
  double mean_diameter = 0;
  Window window;
  Items grains;                                 ///< considered: centre in the window
  Items contacts;                               ///< considered: between grains, contact point in the window
  std::vector<std::uint8_t> considered;         ///< by grain
  std::vector<std::uint8_t> rattler;            ///< by grain
  BlockGrid blocks;                             ///< over the window
  std::vector<int> grain_block, contact_block;  ///< by grain, by contact
  double mean_force = 0;                        ///< of considered contacts that push, N; 0 if none does
  double load_axis = 0;                         ///< rad

  /// Scatter of the pressure of a sample in motion over its mean in time, which all mean forces and stresses share; 0
  /// at rest.
  double level() const { return options.in_time ? options.in_time->pressure : 0; }
  const Contacts& pairs() const { return packing.contacts; }
  Vec2 contact_point(std::size_t c) const;  ///< in the periodic cell
  bool strong(std::size_t c) const { return pairs().fn[c] > mean_force; }
  int material(std::size_t grain) const { return packing.grains.material[grain]; }
  std::string material_name(int m) const;
  std::vector<int> materials() const;  ///< those of considered grains, in rising order
  Items grains_of(int m) const;        ///< considered ones of material m
};

/// Named sets of considered contacts by material pair ("POM-HDPE", in the order of materials) and, where there are
/// zones, by zone pair ("dry-glued"); sets without contacts are left out.
ByName<Items> contacts_by_type(const View& view);

/// Named sets of considered grains: "all", by material, by zone ("dry", "glued") where there are zones.
ByName<Items> grains_by_type(const View& view);

/// Grains that carry nothing, 1 each: those with fewer than `least` of the contacts that count, found by taking them
/// away again and again, since a grain that leans on one of them alone is one too.
std::vector<std::uint8_t> loose_grains(const Packing& packing, int least,
                                       const std::function<bool(std::size_t)>& counts);

/// The items that something holds for.
template <class Holds> Items kept(const Items& items, const Holds& holds) {
  Items some;
  std::ranges::copy_if(items, std::back_inserter(some), holds);
  return some;
}

/// The items whose value is known, and the mean over these; NaN if there are none.
Items known(const Items& items, const std::vector<double>& values);
double mean_of_known(const Items& items, const std::vector<double>& values);

/// Area of a disk inside a rectangle, periodic images of the disk included.
double covered_area(const Domain& domain, Vec2 centre, double radius, const geometry::Rectangle& window);

/// How strongly and which way something depends on direction, A cos m(theta - theta_0).
struct Oscillation {
  Estimate amplitude, direction_deg;  ///< the direction in [0, 360/m)
};

/// By its parts along cos m theta and sin m theta. Noise of the same size in both, sigma, makes an amplitude out of
/// nothing: a true one a, found as A, is about sqrt(A^2 - 2 sigma^2), the scatter of A is that of Rice's distribution
/// (0.655 sigma where there is nothing, sigma where a is large), and a direction is known to sigma/(m a), with 1.25
/// sigma for m > 2, but never worse than a random one, (360/m)/sqrt(12).
Oscillation oscillation(const Estimate& x, const Estimate& y, int m);

/// What a kind of values calls its mean and the share above it.
struct DistributionNames {
  const char *mean, *unit, *share, *mean_is, *share_is;
};

/// Numbers of one set of positive values (forces, stresses) over their own mean, x = F/<F>. `mean_of_all` is the mean
/// of the set that this one is part of. `scale` turns the mean into its unit, NaN where that cannot be known; `level`
/// is View::level. All errors come from leaving out blocks, whatever the law: values of neighbours depend on each
/// other.
Numbers distribution(const Items& items, const std::vector<int>& block_of, const std::vector<double>& value,
                     double mean_of_all, const DistributionNames& names, double scale = 1, double level = 0);

/// Where the numbers of a set go: those of "all" stand by themselves, those of the others in a group.
inline Numbers& place_of(const std::string& set, Numbers& to, const char* group) {
  return set == "all" ? to : to[group][set];
}

/// A statistic, one file each; the list is in measure.cpp. It puts its numbers among Texture::numbers, each with its
/// unit and what it is. What it cannot compute it leaves out, with a note that says why.
using Statistic = void(const View& view, Texture& texture);
Statistic rev;  ///< by itself, too

}  // namespace arenite::texture
