#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "thermal/camera/camera.hpp"
#include "thermal/camera/patch.hpp"
#include "core/error.hpp"

namespace arenite::camera {
namespace {

constexpr int farthest = 3;  // nodes: how far beyond a grain's own nodes its rim is looked for

/// Nodes of one grain of a loaded map, read between.
class GrainNodes {
 public:
  GrainNodes(const FieldResult& result, std::int32_t label) : map_(result.map), field_(result.field), label_(label) {}

  bool own(int x, int y) const { return x >= 0 && y >= 0 && x < map_.width && y < map_.height && map_.grain[map_.index(x, y)] == label_; }
  double sigma_kk(int x, int y) const {
    const std::size_t k = map_.index(x, y);
    return field_.xx[k] + field_.yy[k];
  }

  /// Bilinear between the grain's own nodes; beyond them what the nearest one has, 0 where none is near.
  double at(Vec2 p) const {
    const double u = p.x / map_.dx - 0.5, v = p.y / map_.dx - 0.5;
    const int x = static_cast<int>(std::floor(u)), y = static_cast<int>(std::floor(v));
    double sum = 0, weight = 0;
    for (int j = 0; j < 2; ++j)
      for (int i = 0; i < 2; ++i) {
        if (!own(x + i, y + j)) continue;
        const double w = (1 - std::abs(u - x - i)) * (1 - std::abs(v - y - j));
        sum += w * sigma_kk(x + i, y + j);
        weight += w;
      }
    return weight > 1e-9 ? sum / weight : nearest(u, v);
  }

 private:
  double nearest(double u, double v) const {
    const int x = static_cast<int>(std::lround(u)), y = static_cast<int>(std::lround(v));
    double best = std::numeric_limits<double>::infinity(), value = 0;
    for (int j = -farthest; j <= farthest; ++j)
      for (int i = -farthest; i <= farthest; ++i) {
        const double away = std::hypot(x + i - u, y + j - v);
        if (away >= best || !own(x + i, y + j)) continue;
        best = away;
        value = sigma_kk(x + i, y + j);
      }
    return value;
  }

  const PhaseMap& map_;
  const StressField& field_;
  std::int32_t label_;
};

/// The mean over `points` x `points` of a cell, so that no node between two cells is lost.
double cell_mean(const GrainNodes& nodes, Vec2 middle, double cell, int points) {
  double sum = 0;
  for (int j = 0; j < points; ++j)
    for (int i = 0; i < points; ++i) sum += nodes.at({middle.x + cell * ((i + 0.5) / points - 0.5), middle.y + cell * ((j + 0.5) / points - 0.5)});
  return sum / (points * points);
}

Patch patch_of(const GrainNodes& nodes, Vec2 centre, double radius, double cell, double dx) {
  const int points = std::clamp(static_cast<int>(std::ceil(cell / dx)), 1, 16);
  return fill_patch(radius, cell, [&](Vec2 middle, double) { return cell_mean(nodes, centre + middle, cell, points); });
}

/// Mean displacement of every grain of the map, m.
std::vector<Vec2> mean_displacements(const FieldResult& result) {
  std::vector<Vec2> sum(result.map.grain_class.size());
  std::vector<double> count(sum.size(), 0);
  for (std::size_t k = 0; k < result.map.size(); ++k) {
    const auto label = result.map.grain[k];
    if (label < 0) continue;
    sum[static_cast<std::size_t>(label)] = sum[static_cast<std::size_t>(label)] + Vec2{result.field.ux[k], result.field.uy[k]};
    ++count[static_cast<std::size_t>(label)];
  }
  for (std::size_t g = 0; g < sum.size(); ++g) sum[g] = (1 / std::max(count[g], 1.0)) * sum[g];
  return sum;
}

}  // namespace

Scene scene_of_field(const FieldResult& result, const Parameters& parameters) {
  const std::size_t grains = result.map.grain_class.size();
  if (result.field.size() == 0) throw InputError(fmt::format("\"{}\" is not loaded, so nothing swings; name a load of the cemented sample", result.name));
  if (result.packing.grains.size() < grains || grains == 0)
    throw InputError(fmt::format("\"{}\" was loaded from a picture, whose grains are no disks; the camera films results of a recipe", result.name));
  check_points(result.packing.grains, grains, parameters.optics);
  Scene scene;
  scene.grains = result.packing.grains;
  scene.grains.resize(grains);
  scene.materials = result.packing.materials;
  scene.low = result.packing.domain;
  scene.low.wall[right].position = result.map.width * result.map.dx;
  scene.low.wall[top].position = result.map.height * result.map.dx;
  scene.low.wall[left].position = scene.low.wall[bottom].position = 0;
  scene.high = scene.low;
  scene.travel = mean_displacements(result);
  const double cell = parameters.optics.pixel / static_cast<double>(parameters.optics.supersampling);
  for (std::size_t g = 0; g < grains; ++g)
    scene.swing.push_back(patch_of({result, static_cast<std::int32_t>(g)}, scene.grains.centre(g), scene.grains.radius[g], cell, result.map.dx));
  return scene;
}

}  // namespace arenite::camera
