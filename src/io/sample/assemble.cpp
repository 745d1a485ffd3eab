#include "io/sample/assemble.hpp"

#include <cstdint>

#include "io/sample/contact_rows.hpp"
#include "io/sample/materials.hpp"

namespace arenite::io {
namespace {

/// `closed`: the user gave the box, so that a centre outside is a slip.
GrainIndex add_grains(const RawGrains& raw, const Domain& domain, bool closed, Grains& grains, Problems& problems) {
  GrainIndex index;
  grains.resize(raw.rows.size());
  for (std::size_t g = 0; g < raw.rows.size(); ++g) {
    const RawGrain& row = raw.rows[g];
    if (!index.emplace(row.id, static_cast<std::int32_t>(g)).second)
      problems.add(row.line, "grain {} appears twice; give every grain its own id", row.id);
    if (!(row.radius > 0))
      problems.add(row.line, "the radius of grain {} is {:g} m; a radius must be positive", row.id, row.radius);
    if (!is_finite(row.centre))
      problems.add(row.line, "the centre of grain {} is beyond the range of numbers; correct it", row.id);
    const bool outside_x = !domain.periodic[0] &&
                           (row.centre.x < domain.wall[left].position || row.centre.x > domain.wall[right].position);
    const bool outside_y = !domain.periodic[1] &&
                           (row.centre.y < domain.wall[bottom].position || row.centre.y > domain.wall[top].position);
    if (closed && (outside_x || outside_y))
      problems.add(row.line, "grain {} lies outside the box; correct its centre, --box or --origin", row.id);
    if (row.zone < 0 || row.zone > 255)
      problems.add(row.line, "the zone of grain {} is {}; zones are numbers from 0 to 255", row.id, row.zone);
    else grains.zone[g] = static_cast<std::uint8_t>(row.zone);
    grains.id[g] = row.id;
    grains.position[g] = row.centre;
    grains.radius[g] = row.radius;
  }
  return index;
}

}  // namespace

void assemble(const RawGrains& grains, const RawContacts& contacts, const SampleOptions& options, Sample& sample,
              Problems& grain_problems, Problems& contact_problems) {
  const bool unreadable = contact_problems.any();
  if (grain_problems.any()) Problems::raise({&grain_problems, &contact_problems});
  Packing& packing = sample.packing;
  packing.domain = grains.cell;
  packing.domain.thickness = options.thickness.value_or(0);
  for (int side = 0; side < sides; ++side)
    packing.domain.wall[side].present = grains.has_box && !packing.domain.is_periodic(side);
  const GrainIndex index = add_grains(grains, packing.domain, options.box.has_value(), packing.grains, grain_problems);
  assign_materials(grains, options.materials, packing, grain_problems);
  if (!unreadable) add_contacts(contacts, grains, index, options, sample, contact_problems);
  Problems::raise({&grain_problems, &contact_problems});
  for (const auto* notes : {&grains.notes, &contacts.notes})
    sample.notes.insert(sample.notes.end(), notes->begin(), notes->end());
}

}  // namespace arenite::io
