#include "io/sample/contact_rows.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace arenite::io {
namespace {

/// Where a contact's grains are, and how they lie to each other; n from i to j.
struct ContactGeometry {
  Vec2 n;
  double arm_i = 0, arm_j = 0;
  std::optional<double> gap;  ///< between the surfaces, where it is known; below 0 they overlap
  Vec2 off_i, off_j;          ///< from the centres to where the arms begin
};

constexpr double far_apart = 2;  ///< centre distance over the sum of radii beyond which a contact cannot be meant

/// The unit normal that a row gives, if any; one of another length is a problem.
bool is_unit_normal(const RawContact& row, const Plane& plane, Problems& problems) {
  const double length = norm(plane.of(*row.normal));
  if (std::abs(length - 1) <= 0.05) return true;
  problems.add(row.line, "the normal has length {:g}; give a unit vector", length);
  return false;
}

/// Arms that end at a point `lever` from a centre: along `n`, and from the centre to where that begins.
void end_arm(Vec2 lever, Vec2 n, double& arm, Vec2& off) {
  arm = dot(lever, n);
  off = lever - arm * n;
}

std::optional<ContactGeometry> grain_geometry(const Packing& p, const Plane& plane, const RawContact& row,
                                              std::size_t i, std::size_t j, Problems& problems) {
  const Vec2 branch = p.domain.nearest_image(p.grains.position[j] - p.grains.position[i]);
  const double ri = p.grains.radius[i], rj = p.grains.radius[j];
  double distance = norm(branch);
  const bool is_far = ri > 0 && rj > 0 && distance > far_apart * (ri + rj);
  ContactGeometry g;
  if (row.normal) {
    if (!is_unit_normal(row, plane, problems)) return std::nullopt;
    g.n = plane.of(*row.normal) / norm(plane.of(*row.normal));
    if (is_far) distance = ri + rj;  // across a periodic side that the centres do not show
  } else if (distance == 0) {
    problems.add(row.line, "grains {} and {} have the same centre; correct it or give nx, ny", row.i, row.j);
    return std::nullopt;
  } else {
    g.n = 1 / distance * branch;
  }
  g.gap = row.overlap ? -*row.overlap : distance - (ri + rj);
  if (row.point) {
    const Vec2 point = plane.of(*row.point);
    const Vec2 lever_i = p.domain.nearest_image(point - p.grains.position[i]), lever_j = lever_i - branch;
    if (norm(lever_i) > far_apart * ri || norm(lever_j) > far_apart * rj) {
      problems.add(row.line,
                   "the contact point ({:g}, {:g}) m does not lie at the rims of grains {} and {}; correct x, y or "
                   "their unit, or give these columns other names",
                   point.x, point.y, row.i, row.j);
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

/// Of a contact with a side of the box, or with a boundary whose normal the row gives.
std::optional<ContactGeometry> wall_geometry(const Packing& p, const Plane& plane, const RawContact& row, std::size_t i,
                                             bool has_box, Problems& problems) {
  ContactGeometry g;
  const double radius = p.grains.radius[i];
  if (row.wall < 0) {
    if (!is_unit_normal(row, plane, problems)) return std::nullopt;
    g.n = plane.of(*row.normal) / norm(plane.of(*row.normal));
    g.arm_i = radius - row.overlap.value_or(0);
  } else {
    g.n = -inward_normal(row.wall);
    g.arm_i = has_box ? std::abs(p.domain.depth(row.wall, p.grains.position[i])) : radius;
    if (has_box) g.gap = g.arm_i - radius;
  }
  if (row.overlap) g.gap = -*row.overlap;
  if (row.point) end_arm(p.domain.nearest_image(plane.of(*row.point) - p.grains.position[i]), g.n, g.arm_i, g.off_i);
  return g;
}

/// Force components along n (from i to j) and t: of the force on j.
Vec2 components(const RawContact& row, const Plane& plane, Vec2 n) {
  if (!row.force_on_j) return {row.fn, row.ft};
  const Vec2 force = plane.of(*row.force_on_j);
  return {dot(force, n), cross(n, force)};
}

/// Makes contacts of rows, one after the other.
class ContactRows {
 public:
  ContactRows(const RawGrains& grains, const GrainIndex& index, const SampleOptions& options, Sample& sample,
              Problems& problems)
      : grains_(grains),
        index_(index),
        options_(options),
        sample_(sample),
        packing_(sample.packing),
        problems_(problems) {}

  void add(const RawContacts& raw) {
    for (const RawContact& row : raw.rows) add(row, raw.lists_both_ways);
    const auto is_off = [](Vec2 off) { return off.x != 0 || off.y != 0; };
    Contacts& c = packing_.contacts;
    if (std::ranges::none_of(c.off_i, is_off) && std::ranges::none_of(c.off_j, is_off)) c.off_i = c.off_j = {};
    if (apart_ > 0)
      sample_.notes.push_back(fmt::format(
          "{} of {} listed pairs have a gap between them and no force; they are no contacts and are left out.", apart_,
          raw.rows.size()));
  }

 private:
  void add(const RawContact& row, bool both_ways) {
    const std::int32_t i = grain(row.i, row), j = row.is_of_grains() ? grain(row.j, row) : partner(row);
    if (i < 0 || (row.is_of_grains() && j < 0)) return;
    if (i == j) return problems_.add(row.line, "grain {} cannot touch itself; correct i or j", row.i);
    const auto gi = static_cast<std::size_t>(i);
    const auto geometry = row.is_of_grains()
                              ? grain_geometry(packing_, grains_.plane, row, gi, static_cast<std::size_t>(j), problems_)
                              : wall_geometry(packing_, grains_.plane, row, gi, grains_.has_box, problems_);
    if (!geometry) return;
    const Vec2 f = components(row, grains_.plane, geometry->n);
    if (!is_finite(f)) return problems_.add(row.line, "the force is beyond the range of numbers; correct it");
    if (f == Vec2{} && geometry->gap.value_or(0) > touching * packing_.grains.radius[gi]) {
      ++apart_;
      return;
    }
    if (row.is_of_grains() && !row.normal && is_too_far(row, gi, static_cast<std::size_t>(j), *geometry->gap)) return;
    if (const auto earlier = repeated(i, j, *geometry, row.point.has_value()))
      return merge(*earlier, f, row, both_ways);
    taken_.emplace(std::minmax(i, j), packing_.contacts.size());
    lines_.push_back(row.line);
    rows_merged_.push_back(0);
    // The file's n points from i to j and its force acts on j; both turned round, fn and ft keep their signs.
    Contacts& contacts = packing_.contacts;
    contacts.add(i, j, -geometry->n, f.x, f.y, geometry->arm_i, geometry->arm_j);
    contacts.off_i.push_back(negligible(geometry->off_i, gi) ? Vec2{} : geometry->off_i);
    contacts.off_j.push_back(negligible(geometry->off_j, gi) ? Vec2{} : geometry->off_j);
    if (row.overlap) contacts.overlap.back() = *row.overlap;
  }

  std::int32_t grain(std::int64_t id, const RawContact& row) {
    const auto it = index_.find(id);
    if (it != index_.end()) return it->second;
    problems_.add(row.line,
                  "this contact names grain {}, which is not among the grains; add the grain or remove the row", id);
    return -1;
  }

  /// A side, or a boundary of that name: of its shape only the first place where it is touched is known.
  std::int32_t partner(const RawContact& row) {
    if (row.wall >= 0) return wall_partner(row.wall);
    auto& boundaries = packing_.domain.boundaries;
    const auto at =
        static_cast<std::size_t>(std::ranges::find(boundaries, row.boundary, &Boundary::name) - boundaries.begin());
    if (at == boundaries.size()) {
      Boundary& boundary = boundaries.emplace_back();
      boundary.name = row.boundary;
      boundary.points = {row.point ? grains_.plane.of(*row.point) : Vec2{}};
    }
    return boundary_partner(2 * static_cast<int>(at));
  }

  bool is_too_far(const RawContact& row, std::size_t i, std::size_t j, double gap) {
    const double ri = packing_.grains.radius[i], rj = packing_.grains.radius[j];
    if (row.overlap || row.point || !(ri > 0 && rj > 0) || gap <= (far_apart - 1) * (ri + rj)) return false;
    problems_.add(row.line,
                  "grains {} and {} are {:.3g} times the sum of their radii apart; correct the row, or give --box and "
                  "--periodic or nx, ny if they touch across a periodic side",
                  row.i, row.j, (gap + ri + rj) / (ri + rj));
    return true;
  }

  /// What six digits leave of a vector that is none.
  bool negligible(Vec2 off, std::size_t i) const { return norm(off) <= 1e-6 * packing_.grains.radius[i]; }

  /// The contact that a row repeats: of the same pair, unless their normals differ (a small periodic cell) or their
  /// points (grains that are no disks).
  std::optional<std::size_t> repeated(std::int32_t i, std::int32_t j, const ContactGeometry& g, bool has_point) const {
    const auto [first, last] = taken_.equal_range(std::minmax(i, j));
    const Contacts& contacts = packing_.contacts;
    const auto found = std::find_if(first, last, [&](const auto& pair) {
      const std::size_t c = pair.second;
      const bool same_order = contacts.i[c] == i;
      if (has_point) {
        const Vec2 lever = g.off_i + g.arm_i * g.n, other = same_order ? contacts.lever_i(c) : contacts.lever_j(c);
        return norm(lever - other) <= 1e-6 * packing_.grains.radius[static_cast<std::size_t>(i)];
      }
      return dot(same_order ? -contacts.normal[c] : contacts.normal[c], g.n) > 0;  // from this row's i
    });
    return found != last ? std::optional(found->second) : std::nullopt;
  }

  void merge(std::size_t c, Vec2 f, const RawContact& row, bool both_ways) {
    Contacts& contacts = packing_.contacts;
    if (!options_.merge_doubled && !both_ways)
      return problems_.add(row.line,
                           "the contact of {} and {} is already in line {}; remove one, merge them with --doubled "
                           "merge, or give the contact points as x, y where grains that are no disks touch at several",
                           row.i, name_of_other(row), lines_[c]);
    const double n = ++rows_merged_[c];
    contacts.fn[c] += (f.x - contacts.fn[c]) / (n + 1);
    contacts.ft[c] += (f.y - contacts.ft[c]) / (n + 1);
    if (!both_ways) ++sample_.doubled_rows;
  }
  static std::string name_of_other(const RawContact& row) {
    if (row.wall >= 0) return side_names[static_cast<std::size_t>(row.wall)];
    return row.boundary.empty() ? std::to_string(row.j) : row.boundary;
  }

  static constexpr double touching = 1e-9;  ///< of a radius: a gap of rounding

  const RawGrains& grains_;
  const GrainIndex& index_;
  const SampleOptions& options_;
  Sample& sample_;
  Packing& packing_;
  Problems& problems_;
  std::multimap<std::pair<std::int32_t, std::int32_t>, std::size_t> taken_;  ///< contacts by their pair of grains
  std::vector<int> lines_, rows_merged_;
  std::size_t apart_ = 0;
};

}  // namespace

void add_contacts(const RawContacts& raw, const RawGrains& grains, const GrainIndex& index,
                  const SampleOptions& options, Sample& sample, Problems& problems) {
  ContactRows(grains, index, options, sample, problems).add(raw);
}

}  // namespace arenite::io
