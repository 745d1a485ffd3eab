#include "io/sample/assemble.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <string>
#include <vector>

#include "core/option.hpp"
#include "io/sample/contact_rows.hpp"
#include "io/sample/materials.hpp"

namespace arenite::io {
namespace {

template <int D> bool is_outside(const DomainIn<D>& domain, Vec<D> centre) {
  for (int side = 0; side < sides_in<D>; ++side)
    if (!domain.is_periodic(side) && domain.depth(side, centre) < 0) return true;
  return false;
}

/// `closed`: the user gave the box, so that a centre outside is a slip.
template <int D>
GrainIndex add_grains(const RawGrains& raw, const Laid<D>& laid, bool closed, GrainsIn<D>& grains, Problems& problems) {
  GrainIndex index;
  grains.resize(raw.rows.size());
  for (std::size_t g = 0; g < raw.rows.size(); ++g) {
    const RawGrain& row = raw.rows[g];
    const Vec<D> centre = laid.frame.of(row.place);
    if (!index.emplace(row.id, static_cast<std::int32_t>(g)).second)
      problems.add(row.line, "grain {} appears twice; give every grain its own id", row.id);
    if (!(row.radius > 0) || !std::isfinite(row.radius))
      problems.add(row.line, "the radius of grain {} is {:g} m; a radius must be positive", row.id, row.radius);
    if (!is_finite(centre))
      problems.add(row.line, "the centre of grain {} is beyond the range of numbers; correct it", row.id);
    if (closed && is_outside<D>(laid.cell, centre))
      problems.add(row.line, "grain {} lies outside the box; correct its centre, {} or {}", row.id, option("box"),
                   option("origin"));
    if (row.zone < 0 || row.zone > 255)
      problems.add(row.line, "the zone of grain {} is {}; zones are numbers from 0 to 255", row.id, row.zone);
    else grains.zone[g] = static_cast<std::uint8_t>(row.zone);
    grains.id[g] = row.id;
    grains.position[g] = centre;
    grains.radius[g] = row.radius;
  }
  return index;
}

/// What the plane and space have each for themselves: a thickness; and where the box is not known, the smallest one.
void finish(const SampleOptions& options, bool /*has_box*/, Packing& packing, Problems& /*problems*/) {
  packing.domain.thickness = options.thickness.value_or(0);
}
void finish(const SampleOptions& options, bool has_box, PackingIn<3>& packing, Problems& problems) {
  if (options.thickness) problems.add("these are spheres, which have no thickness; leave out {}", option("thickness"));
  auto& wall = packing.domain.wall;
  GrainsIn<3>& grains = packing.grains;
  for (Vec3& place : grains.position) place = packing.domain.wrapped(place);
  if (has_box) return;
  for (int axis = 0; axis < 3; ++axis) {
    double low = INFINITY, high = -INFINITY;
    for (std::size_t g = 0; g < grains.size(); ++g) {
      low = std::min(low, grains.position[g][axis] - grains.radius[g]);
      high = std::max(high, grains.position[g][axis] + grains.radius[g]);
    }
    wall[2 * axis].position = low;
    wall[2 * axis + 1].position = high;
  }
}

template <int D> std::array<double, D> coordinates_of(Vec<D> place) {
  std::array<double, D> each{};
  for (int axis = 0; axis < D; ++axis) each[static_cast<std::size_t>(axis)] = place[axis];
  return each;
}

/// A record that stands in a file twice counts twice.
template <int D> void note_equal_places(const GrainsIn<D>& grains, std::vector<std::string>& notes) {
  const auto coordinates = [&](std::size_t g) { return coordinates_of<D>(grains.position[g]); };
  std::vector<std::size_t> order(grains.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, coordinates);
  std::size_t count = 0, first = 0;
  for (std::size_t k = 1; k < order.size(); ++k)
    if (coordinates(order[k]) == coordinates(order[k - 1])) {
      if (count++ == 0) first = k;
    }
  if (count == 0) return;
  notes.push_back(fmt::format("{} at the centre of another, the first with ids {} and {}; each counts",
                              count == 1 ? "One grain lies" : fmt::format("{} grains lie", count),
                              grains.id[order[first - 1]], grains.id[order[first]]));
}

}  // namespace

template <int D>
void assemble(const RawGrains& grains, const Laid<D>& laid, const RawContacts& contacts, const SampleOptions& options,
              SampleIn<D>& sample, Problems& grain_problems, Problems& contact_problems) {
  const bool unreadable = contact_problems.any();
  if (grain_problems.any()) Problems::raise({&grain_problems, &contact_problems});
  PackingIn<D>& packing = sample.packing;
  packing.domain = laid.cell;
  for (int side = 0; side < sides_in<D>; ++side)
    packing.domain.wall[side].present = laid.has_box && !packing.domain.is_periodic(side);
  const GrainIndex index = add_grains(grains, laid, !options.box.empty(), packing.grains, grain_problems);
  finish(options, laid.has_box, packing, grain_problems);
  assign_materials(grains, options.materials, packing.materials, packing.grains.material, sample.notes, grain_problems);
  if (!unreadable) add_contacts(contacts, laid, index, options, sample, contact_problems);
  Problems::raise({&grain_problems, &contact_problems});
  note_equal_places<D>(packing.grains, sample.notes);
  for (const auto* notes : {&grains.notes, &contacts.notes})
    sample.notes.insert(sample.notes.end(), notes->begin(), notes->end());
}

template void assemble<2>(const RawGrains&, const Laid<2>&, const RawContacts&, const SampleOptions&, Sample&,
                          Problems&, Problems&);
template void assemble<3>(const RawGrains&, const Laid<3>&, const RawContacts&, const SampleOptions&, SampleIn<3>&,
                          Problems&, Problems&);

}  // namespace arenite::io
