#include "io/placed_grains.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "core/error.hpp"
#include "core/nearest.hpp"
#include "core/problems.hpp"
#include "io/csv.hpp"
#include "io/read_file.hpp"

namespace arenite::io {

namespace {

std::int32_t material_of(const RawGrain& row, const Materials& materials, Problems& problems) {
  if (row.material.empty() && materials.size() == 1) return 0;
  const auto it = std::find_if(materials.begin(), materials.end(), [&](const Material& m) { return m.name == row.material; });
  if (it != materials.end()) return static_cast<std::int32_t>(it - materials.begin());
  std::vector<std::string> names;
  for (const auto& m : materials) names.push_back(m.name);
  const std::string near = nearest(row.material, names);
  problems.add(row.line, row.material.empty() ? std::string("this grain names no material; add a column \"material\"")
                                              : fmt::format("the recipe has no material \"{}\"{}", row.material,
                                                            near.empty() ? "; add it under [materials]" : fmt::format("; did you mean \"{}\"?", near)));
  return 0;
}

bool lies_inside(Vec2 p, const Domain& domain) {
  return p.x >= domain.wall[left].position && p.x <= domain.wall[right].position && p.y >= domain.wall[bottom].position &&
         p.y <= domain.wall[top].position;
}

}  // namespace

Grains read_placed_grains(const std::filesystem::path& path, const Materials& materials, const Domain& domain) {
  Problems problems(path.string());
  const std::string text = read_file(path);
  const RawGrains raw = read_grains_csv(text, "", {}, problems);
  Grains grains;
  grains.resize(raw.rows.size());
  std::map<std::int64_t, int> line_of;
  for (std::size_t i = 0; i < raw.rows.size(); ++i) {
    const RawGrain& row = raw.rows[i];
    if (const auto [seen, is_new] = line_of.emplace(row.id, row.line); !is_new)
      problems.add(row.line, fmt::format("grain {} stands in line {} already; give every grain its own id", row.id, seen->second));
    const Vec2 centre = row.centre + Vec2{domain.wall[left].position, domain.wall[bottom].position};
    if (!lies_inside(centre, domain))
      problems.add(row.line, fmt::format("the centre of grain {} at ({:g}, {:g}) m lies outside the frame of {:g} x {:g} m; correct it, "
                                         "the unit of the column or [frame]", row.id, row.centre.x, row.centre.y, domain.width(), domain.height()));
    grains.id[i] = row.id;
    grains.x[i] = centre.x;
    grains.y[i] = centre.y;
    grains.radius[i] = row.radius;
    grains.material[i] = material_of(row, materials, problems);
  }
  problems.raise();
  return grains;
}

}  // namespace arenite::io
