#include "io/sample/contact_rows.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/option.hpp"
#include "io/sample/contact_geometry.hpp"

namespace arenite::io {
namespace {

/// A force by its parts along n and across it: the contact's fn and ft.
template <int D> struct ForceParts {
  double fn = 0;
  Turning<D> ft{};
};
double tangential_of(const RawContact& row, Vec2 /*n*/) { return row.ft; }
Vec3 tangential_of(const RawContact& /*row*/, Vec3 /*n*/) { return {}; }

/// Of the force on j, n pointing there.
template <int D> ForceParts<D> parts_of(const RawContact& row, const Frame<D>& frame, Vec<D> n) {
  if (!row.force_on_j) return {row.fn, tangential_of(row, n)};
  const Vec<D> force = frame.of(*row.force_on_j);
  return {dot(force, n), cross(n, force)};
}

template <int D> double force_of(const RawContact& row, const Frame<D>& frame) {
  return row.force_on_j ? norm(frame.of(*row.force_on_j)) : std::hypot(row.fn, row.ft);
}
/// What of it points out of the plane; of spheres nothing does.
double across(const RawContact& row, const Frame<2>& frame) {
  return row.force_on_j ? std::abs((*row.force_on_j)[3 - frame.axis[0] - frame.axis[1]]) : 0;
}
double across(const RawContact& /*row*/, const Frame<3>& /*frame*/) { return 0; }

template <int D> double mean_force(const std::vector<RawContact>& rows, const Frame<D>& frame) {
  double sum = 0;
  for (const RawContact& row : rows) sum += force_of(row, frame) / static_cast<double>(rows.size());
  return std::isfinite(sum) ? sum : 0;
}

/// What a grain touches that is no side: in the plane a boundary of that name, of whose shape only the first place
/// where it is touched is known; in space the side that it lies towards.
std::int32_t partner_of(const RawContact& row, const Frame<2>& frame, Domain& domain) {
  auto& boundaries = domain.boundaries;
  const auto at =
      static_cast<std::size_t>(std::ranges::find(boundaries, row.boundary, &Boundary::name) - boundaries.begin());
  if (at == boundaries.size()) {
    Boundary& boundary = boundaries.emplace_back();
    boundary.name = row.boundary;
    boundary.points = {row.point ? frame.of(*row.point) : Vec2{}};
  }
  return boundary_partner(2 * static_cast<int>(at));
}
std::int32_t partner_of(const RawContact& row, const Frame<3>& frame, DomainIn<3>& /*domain*/) {
  return wall_partner(side_towards(frame.of(*row.normal)));
}
void tell_of_others(std::size_t /*count*/, const Domain& /*domain*/, std::vector<std::string>& /*notes*/) {}
void tell_of_others(std::size_t count, const DomainIn<3>& /*domain*/, std::vector<std::string>& notes) {
  if (count > 0)
    notes.push_back(fmt::format(
        "{} contacts are with something that is no side of the box; each counts as one with the wall that it "
        "lies towards, and keeps its own normal.",
        count));
}

/// Makes contacts of rows, one after the other.
template <int D> class ContactRows {
 public:
  ContactRows(const Laid<D>& laid, const GrainIndex& index, const SampleOptions& options, SampleIn<D>& sample,
              Problems& problems)
      : laid_(laid),
        index_(index),
        options_(options),
        sample_(sample),
        packing_(sample.packing),
        problems_(problems) {}

  void add(const RawContacts& raw) {
    least_force_ = no_force * mean_force(raw.rows, laid_.frame);
    for (const RawContact& row : raw.rows) add(row, raw.lists_both_ways);
    walls_.tell(sample_.notes);
    normals_.tell(sample_.notes, problems_);
    const auto is_off = [](Vec<D> off) { return off != Vec<D>{}; };
    ContactsIn<D>& c = packing_.contacts;
    if (std::ranges::none_of(c.off_i, is_off) && std::ranges::none_of(c.off_j, is_off)) c.off_i = c.off_j = {};
    tell_of_others(others_, packing_.domain, sample_.notes);
    if (across_ > least_across * along_)
      sample_.notes.push_back(
          fmt::format("The forces have parts across the plane of the grains, {:.2g} times those in it on average; they "
                      "are left aside, and the sums over the contacts lack them.",
                      across_ / along_));
    if (apart_ > 0)
      sample_.notes.push_back(fmt::format(
          "{} of {} listed pairs have a gap between them and no force; they are no contacts and are left out.", apart_,
          raw.rows.size()));
  }

 private:
  void add(const RawContact& row, bool both_ways) {
    const std::int32_t i = grain(row.i, row), j = row.is_of_grains() ? grain(row.j, row) : other(row);
    if (i < 0 || (row.is_of_grains() && j < 0)) return;
    if (i == j) return problems_.add(row.line, "grain {} cannot touch itself; correct i or j", row.i);
    const auto gi = static_cast<std::size_t>(i);
    const auto geometry = row.is_of_grains()
                              ? grain_geometry(packing_, laid_.frame, row, gi, static_cast<std::size_t>(j), problems_)
                              : wall_geometry(packing_, laid_.frame, row, gi, laid_.has_box, problems_);
    if (!geometry) return;
    const ForceParts<D> f = parts_of(row, laid_.frame, geometry->n);
    if (!is_finite(f.fn) || !is_finite(f.ft))
      return problems_.add(row.line, "the force is beyond the range of numbers; correct it");
    if (force_of(row, laid_.frame) <= least_force_ &&
        geometry->gap.value_or(0) > touching * packing_.grains.radius[gi]) {
      ++apart_;
      return;
    }
    if (row.is_of_grains() && is_too_far(row, geometry->apart)) return;
    across_ += across(row, laid_.frame);
    along_ += force_of(row, laid_.frame);
    if (row.wall >= 0 && !walls_.take(packing_, laid_, row, gi, problems_)) return;
    normals_.take(*geometry);
    if (const auto earlier = repeated(i, j, *geometry, row)) return merge(*earlier, f, row, both_ways);
    taken_.emplace(std::minmax(i, j), packing_.contacts.size());
    lines_.push_back(row.line);
    rows_merged_.push_back(0);
    // The file's n points from i to j and its force acts on j; both turned round, fn and ft keep their signs.
    ContactsIn<D>& contacts = packing_.contacts;
    contacts.add(i, j, -geometry->n, f.fn, f.ft, geometry->arm_i, geometry->arm_j);
    contacts.off_i.push_back(negligible(geometry->off_i, gi) ? Vec<D>{} : geometry->off_i);
    contacts.off_j.push_back(negligible(geometry->off_j, gi) ? Vec<D>{} : geometry->off_j);
    if (row.overlap) contacts.overlap.back() = *row.overlap;
  }

  std::int32_t grain(std::int64_t id, const RawContact& row) {
    const auto it = index_.find(id);
    if (it != index_.end()) return it->second;
    problems_.add(row.line,
                  "this contact names grain {}, which is not among the grains; add the grain or remove the row", id);
    return -1;
  }

  /// A side, or something else that is no grain.
  std::int32_t other(const RawContact& row) {
    if (row.wall >= 0) return wall_partner(row.wall);
    ++others_;
    return partner_of(row, laid_.frame, packing_.domain);
  }

  /// Across a side that no one says is periodic. Where no box is known a normal of its own says that it is.
  bool is_too_far(const RawContact& row, double apart) {
    const bool explained = row.normal ? !laid_.has_box : row.overlap.has_value();
    if (explained || row.point || apart <= far_apart) return false;
    problems_.add(row.line,
                  "grains {} and {} are {:.3g} times the sum of their radii apart; correct the row, or give {} and {} "
                  "{}if they touch across a periodic side",
                  row.i, row.j, apart, option("box"), option("periodic"), laid_.has_box ? "" : "or nx, ny ");
    return true;
  }

  /// What six digits leave of a vector that is none.
  bool negligible(Vec<D> off, std::size_t i) const { return norm(off) <= 1e-6 * packing_.grains.radius[i]; }

  /// The contact that a row repeats: of the same pair, unless their normals differ (a small periodic cell) or their
  /// points (grains that are no disks).
  std::optional<std::size_t> repeated(std::int32_t i, std::int32_t j, const ContactGeometry<D>& g,
                                      const RawContact& row) const {
    const double least = row.is_of_grains() ? 0 : 1 - 1e-6;  // a boundary may be touched at several places
    const auto [first, last] = taken_.equal_range(std::minmax(i, j));
    const ContactsIn<D>& contacts = packing_.contacts;
    const auto found = std::find_if(first, last, [&](const auto& pair) {
      const std::size_t c = pair.second;
      const bool same_order = contacts.i[c] == i;
      if (row.point) {
        const Vec<D> lever = g.off_i + g.arm_i * g.n, other = same_order ? contacts.lever_i(c) : contacts.lever_j(c);
        return norm(lever - other) <= 1e-6 * packing_.grains.radius[static_cast<std::size_t>(i)];
      }
      return dot(same_order ? -contacts.normal[c] : contacts.normal[c], g.n) > least;  // from this row's i
    });
    return found != last ? std::optional(found->second) : std::nullopt;
  }

  void merge(std::size_t c, const ForceParts<D>& f, const RawContact& row, bool both_ways) {
    ContactsIn<D>& contacts = packing_.contacts;
    if (!options_.merge_doubled && !both_ways)
      return problems_.add(row.line,
                           "the contact of {} and {} is already in line {}; remove one, merge them with {}, or give "
                           "the contact points as x, y where grains that are no disks touch at several",
                           row.i, name_of_other(row), lines_[c], option("doubled merge"));
    const double n = ++rows_merged_[c];
    contacts.fn[c] += (f.fn - contacts.fn[c]) / (n + 1);
    contacts.ft[c] += (f.ft - contacts.ft[c]) / (n + 1);
    if (!both_ways) ++sample_.doubled_rows;
  }
  static std::string name_of_other(const RawContact& row) {
    if (row.wall >= 0) return any_side_names[static_cast<std::size_t>(row.wall)];
    return row.boundary.empty() ? std::to_string(row.j) : row.boundary;
  }

  static constexpr double touching = 1e-9, no_force = 1e-9;  ///< rounding: of a radius, and of the mean force
  static constexpr double least_across = 1e-5;               ///< six digits

  const Laid<D>& laid_;
  const GrainIndex& index_;
  const SampleOptions& options_;
  SampleIn<D>& sample_;
  PackingIn<D>& packing_;
  Problems& problems_;
  std::multimap<std::pair<std::int32_t, std::int32_t>, std::size_t> taken_;  ///< contacts by their pair of grains
  std::vector<int> lines_, rows_merged_;
  std::size_t apart_ = 0, others_ = 0;
  double across_ = 0, along_ = 0;  ///< N, sums
  PlacesOfWalls<D> walls_;
  TurnedNormals<D> normals_;
  double least_force_ = 0;  ///< N
};

}  // namespace

template <int D>
void add_contacts(const RawContacts& raw, const Laid<D>& laid, const GrainIndex& index, const SampleOptions& options,
                  SampleIn<D>& sample, Problems& problems) {
  ContactRows<D>(laid, index, options, sample, problems).add(raw);
}
template void add_contacts<2>(const RawContacts&, const Laid<2>&, const GrainIndex&, const SampleOptions&, Sample&,
                              Problems&);
template void add_contacts<3>(const RawContacts&, const Laid<3>&, const GrainIndex&, const SampleOptions&, SampleIn<3>&,
                              Problems&);

}  // namespace arenite::io
