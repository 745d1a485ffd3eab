#include "report/grain_means.hpp"

namespace arenite::report {

GrainMeans grain_means(const PhaseMap& map, const StressField& field) {
  const std::size_t grains = map.grain_class.size();
  const bool loaded = field.size() == map.size() && map.size() > 0;
  GrainMeans out;
  out.nodes.resize(grains);
  for (auto* values : {&out.x, &out.y}) values->resize(grains);
  if (loaded)
    for (auto* values : {&out.xx, &out.yy, &out.xy}) values->resize(grains);
  for (int y = 0; y < map.height; ++y)
    for (int x = 0; x < map.width; ++x) {
      const std::size_t k = map.index(x, y);
      if (map.grain[k] < 0) continue;
      const auto g = static_cast<std::size_t>(map.grain[k]);
      ++out.nodes[g];
      out.x[g] += (x + 0.5) * map.dx;
      out.y[g] += (y + 0.5) * map.dx;
      if (!loaded) continue;
      out.xx[g] += field.xx[k];
      out.yy[g] += field.yy[k];
      out.xy[g] += field.xy[k];
    }
  for (auto* values : {&out.x, &out.y, &out.xx, &out.yy, &out.xy})
    for (std::size_t g = 0; g < values->size(); ++g)
      if (out.nodes[g] > 0) (*values)[g] /= out.nodes[g];
  return out;
}

}  // namespace arenite::report
