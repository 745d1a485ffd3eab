#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "io/sample/formats.hpp"

// How the two of a contact lie to each other, and whether what the files say of it holds together.
namespace arenite::io {

/// Where a contact's grains are, and how they lie to each other; n from i to j.
template <int D> struct ContactGeometry {
  Vec<D> n;
  double arm_i = 0, arm_j = 0;
  std::optional<double> gap;     ///< between the surfaces, where it is known; below 0 they overlap
  Vec<D> off_i, off_j;           ///< from the centres to where the arms begin
  double apart = 0;              ///< of two centres, over the sum of their radii
  std::optional<double> turned;  ///< rad, of a normal that the row gives, from the line through two centres
};

constexpr double far_apart = 2;  ///< centre distance over the sum of radii beyond which a contact cannot be meant

/// Of two grains. What contradicts itself is a problem, and then there is none.
template <int D>
std::optional<ContactGeometry<D>> grain_geometry(const PackingIn<D>& p, const Frame<D>& frame, const RawContact& row,
                                                 std::size_t i, std::size_t j, Problems& problems);

/// Of a contact with a side of the box, or with a boundary whose normal the row gives.
template <int D>
std::optional<ContactGeometry<D>> wall_geometry(const PackingIn<D>& p, const Frame<D>& frame, const RawContact& row,
                                                std::size_t i, bool has_box, Problems& problems);

/// Contacts with sides of the box against where these are: a box that is not the sample's shows so.
template <int D> class PlacesOfWalls {
 public:
  /// False, and a problem, where the box has no such wall, or where it is nowhere near the grain.
  bool take(const PackingIn<D>& p, const Laid<D>& laid, const RawContact& row, std::size_t i, Problems& problems);
  void tell(std::vector<std::string>& notes) const;

 private:
  std::size_t count_ = 0, off_ = 0;
  double worst_ = 1;  ///< distance of a wall over the radius; 1: the grain touches it
};

/// Normals that are given against the centres of grains, which are taken to be round.
template <int D> class TurnedNormals {
 public:
  void take(const ContactGeometry<D>& contact);
  /// A few may be those of grains that are not round; where most are turned the columns are wrong.
  void tell(std::vector<std::string>& notes, Problems& problems) const;

 private:
  std::size_t count_ = 0, turned_ = 0;
  double most_ = 0;  ///< rad
};

}  // namespace arenite::io
