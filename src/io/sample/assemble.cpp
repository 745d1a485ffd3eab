#include "io/sample/sample.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <unordered_map>

#include "core/mapped.hpp"
#include "geometry/rectangle.hpp"

namespace arenite::io {
namespace {

using Index = std::unordered_map<std::int64_t, std::int32_t>;  // only looked up, never walked through

/// `closed`: the user gave the box, so that a centre outside is a slip.
Index add_grains(const RawGrains& raw, const Domain& domain, bool closed, Grains& grains, Problems& problems) {
  Index index;
  grains.resize(raw.rows.size());
  if (raw.rows.empty()) problems.add("there are no grains; give one row per grain");
  for (std::size_t g = 0; g < raw.rows.size(); ++g) {
    const RawGrain& row = raw.rows[g];
    if (!index.emplace(row.id, static_cast<std::int32_t>(g)).second) problems.add(row.line, "grain {} appears twice; give every grain its own id", row.id);
    if (!(row.radius > 0)) problems.add(row.line, "the radius of grain {} is {:g} m; a radius must be positive", row.id, row.radius);
    const bool outside_x = !domain.periodic[0] && (row.centre.x < domain.wall[left].position || row.centre.x > domain.wall[right].position);
    const bool outside_y = !domain.periodic[1] && (row.centre.y < domain.wall[bottom].position || row.centre.y > domain.wall[top].position);
    if (closed && (outside_x || outside_y)) problems.add(row.line, "grain {} lies outside the box; correct its centre, --box or --origin", row.id);
    if (row.zone < 0 || row.zone > 255) problems.add(row.line, "the zone of grain {} is {}; zones are numbers from 0 to 255", row.id, row.zone);
    else grains.zone[g] = static_cast<std::uint8_t>(row.zone);
    grains.id[g] = row.id;
    grains.position[g] = row.centre;
    grains.radius[g] = row.radius;
  }
  return index;
}

/// Where a contact's grains are, and how they lie to each other; n from i to j.
struct ContactGeometry {
  Vec2 n;
  double arm_i = 0, arm_j = 0;
};

constexpr double far_apart = 2;  ///< centre distance over the sum of radii beyond which a contact cannot be meant

std::optional<ContactGeometry> grain_geometry(const Packing& p, const RawContact& row, std::size_t i, std::size_t j, Problems& problems) {
  const Vec2 branch = p.domain.nearest_image(p.grains.position[j] - p.grains.position[i]);
  const double ri = p.grains.radius[i], rj = p.grains.radius[j];
  double distance = norm(branch);
  ContactGeometry g;
  if (row.normal) {
    const double length = norm(*row.normal);
    if (std::abs(length - 1) > 0.05) {
      problems.add(row.line, "the normal has length {:g}; give a unit vector", length);
      return std::nullopt;
    }
    g.n = 1 / length * *row.normal;
    if (distance > far_apart * (ri + rj)) distance = ri + rj;  // across a periodic side that the centres do not show
  } else if (distance == 0) {
    problems.add(row.line, "grains {} and {} have the same centre; correct it or give nx, ny", row.i, row.j);
    return std::nullopt;
  } else if (ri > 0 && rj > 0 && distance > far_apart * (ri + rj)) {
    problems.add(row.line,
                 "grains {} and {} are {:.3g} times the sum of their radii apart; correct the row, or give "
                 "--box and --periodic or nx, ny if they touch across a periodic side",
                 row.i, row.j, distance / (ri + rj));
    return std::nullopt;
  } else {
    g.n = 1 / distance * branch;
  }
  const double overlap = ri + rj - distance;
  g.arm_i = ri - overlap / 2;
  g.arm_j = rj - overlap / 2;
  return g;
}

ContactGeometry wall_geometry(const Packing& p, int side, std::size_t i, bool has_box) {
  const Vec2 n = -inward_normal(side);
  const double position = p.domain.wall[static_cast<std::size_t>(side)].position;
  const double distance = side == left || side == right ? std::abs(p.grains.position[i].x - position) : std::abs(p.grains.position[i].y - position);
  return {n, has_box ? distance : p.grains.radius[i], 0};
}

/// Force components along n (from i to j) and t: of the force on j.
Vec2 components(const RawContact& row, Vec2 n) {
  if (!row.force_on_j) return {row.fn, row.ft};
  return {dot(*row.force_on_j, n), dot(*row.force_on_j, perpendicular(n))};
}

using Taken = std::multimap<std::pair<std::int32_t, std::int32_t>, std::size_t>;  ///< contacts by their pair of grains

/// The contact that a row repeats: of the same pair, unless their normals differ (a small periodic cell).
std::optional<std::size_t> repeated(const Taken& taken, std::int32_t i, std::int32_t j, Vec2 n, const Contacts& contacts) {
  const auto [first, last] = taken.equal_range(std::minmax(i, j));
  const auto found = std::find_if(first, last, [&](const auto& pair) {
    const std::size_t c = pair.second;
    return dot(contacts.i[c] == i ? -contacts.normal[c] : contacts.normal[c], n) > 0;  // from this row's i
  });
  return found != last ? std::optional(found->second) : std::nullopt;
}

void add_contacts(const RawContacts& raw, const Index& index, bool has_box, const SampleOptions& options, Sample& sample, Problems& problems) {
  Packing& p = sample.packing;
  Taken taken;
  std::vector<int> lines, rows_merged;
  const auto grain = [&](std::int64_t id, const RawContact& row) -> std::int32_t {
    const auto it = index.find(id);
    if (it != index.end()) return it->second;
    problems.add(row.line, "this contact names grain {}, which is not among the grains; add the grain or remove the row", id);
    return -1;
  };
  for (const RawContact& row : raw.rows) {
    const std::int32_t i = grain(row.i, row), j = row.wall < 0 ? grain(row.j, row) : wall_partner(row.wall);
    if (i < 0 || (row.wall < 0 && j < 0)) continue;
    if (i == j) {
      problems.add(row.line, "grain {} cannot touch itself; correct i or j", row.i);
      continue;
    }
    const auto gi = static_cast<std::size_t>(i);
    const auto geometry =
        row.wall < 0 ? grain_geometry(p, row, gi, static_cast<std::size_t>(j), problems) : std::optional(wall_geometry(p, row.wall, gi, has_box));
    if (!geometry) continue;
    const Vec2 f = components(row, geometry->n);
    if (const auto earlier = repeated(taken, i, j, geometry->n, p.contacts)) {
      const std::size_t c = *earlier;
      if (!options.merge_doubled && !raw.lists_both_ways) {
        problems.add(row.line, "the contact of {} and {} is already in line {}; remove one, or merge them with --doubled merge", row.i,
                     row.wall < 0 ? std::to_string(row.j) : side_names[static_cast<std::size_t>(row.wall)], lines[c]);
        continue;
      }
      const double n = ++rows_merged[c];
      p.contacts.fn[c] += (f.x - p.contacts.fn[c]) / (n + 1);
      p.contacts.ft[c] += (f.y - p.contacts.ft[c]) / (n + 1);
      if (!raw.lists_both_ways) ++sample.doubled_rows;
      continue;
    }
    taken.emplace(std::minmax(i, j), p.contacts.size());
    lines.push_back(row.line);
    rows_merged.push_back(0);
    // The file's n points from i to j and its force acts on j; both turned round, fn and ft keep their signs.
    p.contacts.add(i, j, -geometry->n, f.x, f.y, geometry->arm_i, geometry->arm_j);
  }
}

}  // namespace

void place_box(RawGrains& grains, Problems& problems) {
  if (grains.rows.empty()) return;
  const auto centres = mapped(grains.rows, &RawGrain::centre);
  const geometry::Rectangle around = geometry::bounds(centres);
  const auto place = [&](int axis, double low, double high, const char* name) {
    const double size = grains.cell.extent(axis);
    if (grains.cell.periodic[axis] || (low >= 0 && high <= size)) return;
    if (high - low > size) problems.add("the centres span {:g} m along {}, more than the box's {:g} m; correct --box or --length-unit", high - low, name, size);
    const double corner = 0.5 * (low + high) - 0.5 * size;
    grains.cell.wall[2 * axis].position = corner;
    grains.cell.wall[2 * axis + 1].position = corner + size;
    grains.notes.push_back(
        fmt::format("The centres do not lie between 0 and the box's {:g} m along {}, so the box was placed around them, from {:g} m; "
                    "--origin sets its position.",
                    size, name, corner));
  };
  place(0, around.x_min, around.x_max, "x");
  place(1, around.y_min, around.y_max, "y");
}

void assemble(const RawGrains& grains, const RawContacts& contacts, const SampleOptions& options, Sample& sample, Problems& grain_problems,
              Problems& contact_problems) {
  const bool unreadable = contact_problems.any();
  if (grain_problems.any()) Problems::raise({&grain_problems, &contact_problems});
  Packing& packing = sample.packing;
  packing.domain = grains.cell;
  packing.domain.thickness = options.thickness.value_or(0);
  for (int side = 0; side < sides; ++side) packing.domain.wall[side].present = grains.has_box && !packing.domain.is_periodic(side);
  const Index index = add_grains(grains, packing.domain, options.box.has_value(), packing.grains, grain_problems);
  assign_materials(grains, options.materials, packing, grain_problems);
  if (!unreadable) add_contacts(contacts, index, grains.has_box, options, sample, contact_problems);
  Problems::raise({&grain_problems, &contact_problems});
  for (const auto* notes : {&grains.notes, &contacts.notes}) sample.notes.insert(sample.notes.end(), notes->begin(), notes->end());
}

}  // namespace arenite::io
