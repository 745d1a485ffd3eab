#include "io/sample/placed_grains.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <string>

#include "core/error.hpp"
#include "core/mapped.hpp"
#include "io/sample/formats.hpp"
#include "io/sample/layout.hpp"
#include "io/sample/snapshots.hpp"
#include "io/table/text_file.hpp"

namespace arenite::io {
namespace {

std::int32_t material_of(const RawGrain& row, const Materials& materials, Problems& problems) {
  if (row.material.empty() && materials.size() == 1) return 0;
  const auto it =
      std::find_if(materials.begin(), materials.end(), [&](const Material& m) { return m.name == row.material; });
  if (it != materials.end()) return static_cast<std::int32_t>(it - materials.begin());
  const std::string near = nearest(row.material, mapped(materials, &Material::name));
  if (row.material.empty()) problems.add(row.line, "this grain has no material; add a column \"material\"");
  else
    problems.add(row.line, "the recipe has no material \"{}\"{}", row.material,
                 near.empty() ? "; add it under [materials]" : fmt::format("; did you mean \"{}\"?", near));
  return 0;
}

bool lies_inside(Vec2 p, const Domain& domain) {
  return p.x >= domain.wall[left].position && p.x <= domain.wall[right].position &&
         p.y >= domain.wall[bottom].position && p.y <= domain.wall[top].position;
}

}  // namespace

Grains read_placed_grains(const std::filesystem::path& path, const Materials& materials, const Domain& domain,
                          std::vector<std::string>& notes) {
  Problems problems(path.string());
  if (const SampleFormat* other = known_sample_format(path))
    throw InputError(path.string(), 0,
                     fmt::format("is {}; a recipe takes grains from a table with the columns x, y, radius and material",
                                 other->grains_are));
  const std::string text = read_text(path);
  SampleOptions options;
  options.may_be_given = false;
  const auto taken = common_snapshot(samples::csv.grain_moments(text, ""), {}, false, notes, problems);
  RawGrains raw = samples::csv.grains({text, taken.grains, options, problems});
  if (!problems.any() && !raw.rows.empty()) lay_out(raw, 2, problems);
  if (raw.plane.frame.axis != Frame<2>{}.axis)
    problems.add("the centres do not lie in the plane x-y; give x and y as those of the container");
  Grains grains;
  grains.resize(raw.rows.size());
  std::map<std::int64_t, int> line_of;
  for (std::size_t i = 0; i < raw.rows.size(); ++i) {
    const RawGrain& row = raw.rows[i];
    if (const auto [seen, is_new] = line_of.emplace(row.id, row.line); !is_new)
      problems.add(row.line, "grain {} is already in line {}; give every grain its own id", row.id, seen->second);
    const Vec2 centre = raw.plane.frame.of(row.place) + domain.corner();
    if (!lies_inside(centre, domain))
      problems.add(row.line,
                   "the centre of grain {} at ({:g}, {:g}) m lies outside the container of {:g} x {:g} m; correct it, "
                   "the unit of the column or [container]",
                   row.id, centre.x - domain.corner().x, centre.y - domain.corner().y, domain.width(), domain.height());
    grains.id[i] = row.id;
    grains.position[i] = centre;
    grains.radius[i] = row.radius;
    grains.material[i] = material_of(row, materials, problems);
  }
  problems.raise();
  notes.insert(notes.end(), raw.notes.begin(), raw.notes.end());
  return grains;
}

}  // namespace arenite::io
