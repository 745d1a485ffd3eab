#include "io/sample/contact_geometry.hpp"
#include "core/option.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>

namespace arenite::io {
namespace {

template <int D> constexpr const char* normal_names = "nx, ny";
template <> constexpr const char* normal_names<3> = "nx, ny, nz";
std::string place_words(Vec2 v) { return fmt::format("({:g}, {:g})", v.x, v.y); }
std::string place_words(Vec3 v) { return fmt::format("({:g}, {:g}, {:g})", v.x, v.y, v.z); }

/// The unit normal that a row gives, if any; one of another length is a problem.
template <int D> bool is_unit_normal(const RawContact& row, const Frame<D>& frame, Problems& problems) {
  const double length = norm(frame.of(*row.normal));
  if (std::abs(length - 1) <= 0.05) return true;
  problems.add(row.line, "the normal has length {:g}; give a unit vector", length);
  return false;
}

/// Arms that end at a point `lever` from a centre: along `n`, and from the centre to where that begins.
template <int D> void end_arm(Vec<D> lever, Vec<D> n, double& arm, Vec<D>& off) {
  arm = dot(lever, n);
  off = lever - arm * n;
}

/// Whether a periodic cell is so small that two grains may touch through two of its sides, so that the nearest image
/// does not say where they do.
template <int D> bool wraps_round(const Container<D>& domain, double reach) {
  for (int axis = 0; axis < D; ++axis)
    if (domain.periodic[axis] && domain.extent(axis) < 4 * reach) return true;
  return false;
}

constexpr double most_off = 0.1;                             // of a radius: more than overlaps and rounding make
constexpr double most_turned = 20 * std::numbers::pi / 180;  // more than normals of measured outlines scatter

}  // namespace

template <int D>
std::optional<ContactGeometry<D>> grain_geometry(const PackingIn<D>& p, const Frame<D>& frame, const RawContact& row,
                                                 std::size_t i, std::size_t j, Problems& problems) {
  const Vec<D> branch = p.domain.nearest_image(p.grains.position[j] - p.grains.position[i]);
  const double ri = p.grains.radius[i], rj = p.grains.radius[j];
  double distance = norm(branch);
  const bool is_far = ri > 0 && rj > 0 && distance > far_apart * (ri + rj);
  ContactGeometry<D> g;
  if (ri > 0 && rj > 0) g.apart = distance / (ri + rj);
  if (row.normal) {
    if (!is_unit_normal(row, frame, problems)) return std::nullopt;
    g.n = frame.of(*row.normal) / norm(frame.of(*row.normal));
    if (is_far) distance = ri + rj;  // across a periodic side that the centres do not show
  } else if (distance == 0) {
    problems.add(row.line, "grains {} and {} have the same centre; correct it or give its normal, {}", row.i, row.j,
                 normal_names<D>);
    return std::nullopt;
  } else {
    g.n = 1 / distance * branch;
  }
  if (row.normal && !row.point && !is_far && distance > 0 && !wraps_round(p.domain, ri + rj))
    g.turned = std::acos(std::clamp(dot(g.n, branch) / distance, -1.0, 1.0));
  g.gap = row.overlap ? -*row.overlap : distance - (ri + rj);
  if (row.point) {
    const Vec<D> point = frame.of(*row.point);
    const Vec<D> lever_i = p.domain.nearest_image(point - p.grains.position[i]), lever_j = lever_i - branch;
    if (norm(lever_i) > far_apart * ri || norm(lever_j) > far_apart * rj) {
      problems.add(row.line,
                   "the contact point {} m does not lie at the rims of grains {} and {}; correct x, y or "
                   "their unit, or give these columns other names",
                   place_words(point), row.i, row.j);
      return std::nullopt;
    }
    end_arm(lever_i, g.n, g.arm_i, g.off_i);
    end_arm(lever_j, -g.n, g.arm_j, g.off_j);
    return g;
  }
  const double overlap = ri + rj - distance;
  g.arm_i = ri - overlap / 2;
  g.arm_j = rj - overlap / 2;
  return g;
}

template <int D>
std::optional<ContactGeometry<D>> wall_geometry(const PackingIn<D>& p, const Frame<D>& frame, const RawContact& row,
                                                std::size_t i, bool has_box, Problems& problems) {
  ContactGeometry<D> g;
  const double radius = p.grains.radius[i];
  if (row.wall < 0) {
    if (!is_unit_normal(row, frame, problems)) return std::nullopt;
    g.n = frame.of(*row.normal) / norm(frame.of(*row.normal));
    g.arm_i = radius - row.overlap.value_or(0);
  } else {
    g.n = -inward_normal<D>(row.wall);
    g.arm_i = has_box ? std::abs(p.domain.depth(row.wall, p.grains.position[i])) : radius;
    if (has_box) g.gap = g.arm_i - radius;
  }
  if (row.overlap) g.gap = -*row.overlap;
  if (row.point) end_arm(p.domain.nearest_image(frame.of(*row.point) - p.grains.position[i]), g.n, g.arm_i, g.off_i);
  return g;
}

template <int D>
bool PlacesOfWalls<D>::take(const PackingIn<D>& p, const Laid<D>& laid, const RawContact& row, std::size_t i,
                            Problems& problems) {
  const std::string_view side = any_side_names[static_cast<std::size_t>(row.wall)];
  if (!row.is_towards && p.domain.is_periodic(row.wall)) {
    problems.add(row.line,
                 "grain {} touches the side {}, but the box is periodic along {}, where it has no walls; correct the "
                 "row, {}, or the box of the file",
                 row.i, side, "xyz"[laid.frame.axis[axis_of(row.wall)]], option("periodic"));
    return false;
  }
  const double radius = p.grains.radius[i];
  if (!laid.has_box || p.domain.is_periodic(row.wall) || !(radius > 0)) return true;
  const double depth = p.domain.depth(row.wall, p.grains.position[i]), ratio = depth / radius;
  if (!row.is_towards && !row.point && !(ratio > 0 && ratio <= far_apart)) {
    problems.add(row.line,
                 "grain {} of radius {:g} m touches the side {}, but its centre is {:g} m {} the box there; correct "
                 "the row, {}, {}, or the box of the file",
                 row.i, radius, side, std::abs(depth), depth < 0 ? "outside" : "inside", option("box"),
                 option("origin"));
    return false;
  }
  ++count_;
  if (row.point || std::abs(ratio - 1) <= most_off) return true;
  ++off_;
  if (std::abs(ratio - 1) > std::abs(worst_ - 1)) worst_ = ratio;
  return true;
}

template <int D> void PlacesOfWalls<D>::tell(std::vector<std::string>& notes) const {
  if (off_ == 0) return;
  notes.push_back(
      fmt::format("In {} of {} contacts with walls the box does not fit the grain: its centre lies {:.3g} radii from "
                  "the wall where it is worst, and 1 touches; correct {}, {} or the box of the file.",
                  off_, count_, worst_, option("box"), option("origin")));
}

template <int D> void TurnedNormals<D>::take(const ContactGeometry<D>& contact) {
  if (!contact.turned) return;
  ++count_;
  turned_ += *contact.turned > most_turned ? 1 : 0;
  most_ = std::max(most_, *contact.turned);
}

template <int D> void TurnedNormals<D>::tell(std::vector<std::string>& notes, Problems& problems) const {
  if (turned_ == 0) return;
  const std::string found = fmt::format(
      "{} of {} normals are turned by more than {:.0f} degrees from the line through the centres of their grains, by "
      "up to {:.0f}",
      turned_, count_, most_turned * 180 / std::numbers::pi, most_ * 180 / std::numbers::pi);
  if (2 * turned_ <= count_) notes.push_back(found + "; they were taken as they are.");
  else
    problems.add("{}; give {} from i to j, and for grains that are not round the contact points x, y, too", found,
                 normal_names<D>);
}

#define ARENITE_OF(D)                                                                                                \
  template std::optional<ContactGeometry<D>> grain_geometry(const PackingIn<D>&, const Frame<D>&, const RawContact&, \
                                                            std::size_t, std::size_t, Problems&);                    \
  template std::optional<ContactGeometry<D>> wall_geometry(const PackingIn<D>&, const Frame<D>&, const RawContact&,  \
                                                           std::size_t, bool, Problems&);                            \
  template class PlacesOfWalls<D>;                                                                                   \
  template class TurnedNormals<D>;
ARENITE_OF(2)
ARENITE_OF(3)
#undef ARENITE_OF

}  // namespace arenite::io
