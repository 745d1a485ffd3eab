#include "thermal/camera/scene.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "core/mapped.hpp"
#include "core/problems.hpp"
#include "model/elasticity/disk_field.hpp"
#include "thermal/camera/camera.hpp"

namespace arenite::camera {
namespace {

/// The patch of a grain of that radius, in cells that wide, m. `stress(middle, away)` is the mean of sigma_kk over the
/// cell whose middle lies there, seen from the grain's centre and `away` from it, Pa. It is asked for a ring of cells
/// beyond the rim too, so that what lies between cells can be read off; cells farther out stay 0.
template <class Stress> Patch fill_patch(double radius, double cell, const Stress& stress) {
  Patch patch;
  patch.cells = 2 * static_cast<int>(std::ceil(radius / cell)) + 2;
  patch.cell = cell;
  const double first = -0.5 * (patch.cells - 1) * cell;
  for (int r = 0; r < patch.cells; ++r)
    for (int c = 0; c < patch.cells; ++c) {
      const Vec2 middle{first + c * cell, first + r * cell};
      const double away = norm(middle);
      patch.value.push_back(away > radius + 1.5 * cell ? 0.0F : static_cast<float>(stress(middle, away)));
    }
  return patch;
}

/// Throws InputError if the points of the scene in the first `count` grains are more than `most_points`.
void check_points(const Grains& grains, std::size_t count, const Optics& optics) {
  const double cell = optics.pixel / static_cast<double>(optics.supersampling);
  double points = 0;
  for (std::size_t g = 0; g < count; ++g) points += 4 * (grains.radius[g] / cell) * (grains.radius[g] / cell);
  if (!(points <= most_points))
    throw refusal(
        "pixels of {:.3g} mm with {} x {} points each give {:.2g} points on the grains, too many to compute; raise "
        "camera.pixel or lower supersampling",
        1e3 * optics.pixel, optics.supersampling, optics.supersampling, points);
}

/// The grains as disks under the change of their contact forces from `low`, or from none, to `high`: fields of forces
/// add up.
std::vector<elasticity::Disk> pressed_disks(const Packing* low, const Packing& high, double arc) {
  auto disks = mapped(high.grains.radius, [&](double radius) {
    return elasticity::Disk{
        radius, high.domain.thickness, {}, arc > 0 ? elasticity::Traction::elliptic : elasticity::Traction::point};
  });
  const auto press = [&](const Contacts& contacts, double sign) {
    for (std::size_t c = 0; c < contacts.size(); ++c) {
      const elasticity::RimForce force{contacts.normal[c], sign * contacts.fn[c], sign * contacts.ft[c], arc};
      disks[static_cast<std::size_t>(contacts.i[c])].forces.push_back(force);
      if (!contacts.is_wall(c))
        disks[static_cast<std::size_t>(contacts.j[c])].forces.push_back({-force.normal, force.fn, force.ft, arc});
    }
  };
  press(high.contacts, 1);
  if (low) press(low->contacts, -1);
  return disks;
}

void require_factors(const Packing& packing) {
  for (const auto m : packing.grains.material)
    if (packing.materials[static_cast<std::size_t>(m)].thermoelastic_factor <= 0)
      throw refusal(
          "material {}: its thermoelastic factor is not known; set thermoelastic_factor = \"... K/MPa\" in the recipe",
          packing.materials[static_cast<std::size_t>(m)].name);
}

Scene make_scene(const Packing* low, const Packing& high, const Parameters& p) {
  require_factors(high);
  check_points(high.grains, high.grains.size(), p.optics);
  const Packing& start = low ? *low : high;
  Scene scene{start.grains, {}, {}, start.domain, high.domain, high.materials};
  const double cell = p.optics.pixel / static_cast<double>(p.optics.supersampling);
  for (std::size_t i = 0; i < start.grains.size(); ++i)
    scene.travel.push_back(high.grains.position[i] - start.grains.position[i]);
  for (const elasticity::Disk& disk : pressed_disks(low, high, p.contact_arc))
    scene.stress.push_back(fill_patch(disk.radius, cell, [&](Vec2 at, double away) {
      // Cells on the rim and beyond it hold what its nearest point has.
      const double inner = disk.radius - 0.71 * cell;
      return elasticity::square_mean(disk, away > inner ? inner / away * at : at, cell);
    }));
  return scene;
}

constexpr int farthest = 3;  // nodes: how far beyond a grain's own nodes its rim is looked for

/// Nodes of one grain of a loaded map, read between.
class GrainNodes {
 public:
  GrainNodes(const FieldResult& result, std::int32_t label) : map_(result.map), field_(result.field), label_(label) {}

  bool own(int x, int y) const {
    return x >= 0 && y >= 0 && x < map_.width && y < map_.height && map_.grain[map_.index(x, y)] == label_;
  }
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
        const double away = norm(Vec2{x + i - u, y + j - v});
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
    for (int i = 0; i < points; ++i)
      sum += nodes.at({middle.x + cell * ((i + 0.5) / points - 0.5), middle.y + cell * ((j + 0.5) / points - 0.5)});
  return sum / (points * points);
}

/// Mean displacement of every grain of the map, m.
std::vector<Vec2> mean_displacements(const FieldResult& result) {
  std::vector<Vec2> sum(result.map.grain_class.size());
  std::vector<double> count(sum.size(), 0);
  for (std::size_t k = 0; k < result.map.size(); ++k) {
    const auto label = result.map.grain[k];
    if (label < 0) continue;
    sum[static_cast<std::size_t>(label)] += result.field.displacement(k);
    ++count[static_cast<std::size_t>(label)];
  }
  for (std::size_t g = 0; g < sum.size(); ++g) sum[g] = (1 / std::max(count[g], 1.0)) * sum[g];
  return sum;
}

}  // namespace

float Patch::at(Vec2 offset) const {
  const auto along = [&](double x) { return std::clamp(x / cell + 0.5 * (cells - 1), 0.0, cells - 1.001); };
  const double u = along(offset.x), v = along(offset.y);
  const auto c = static_cast<std::size_t>(u), r = static_cast<std::size_t>(v), n = static_cast<std::size_t>(cells);
  const auto fx = static_cast<float>(u - static_cast<double>(c)), fy = static_cast<float>(v - static_cast<double>(r));
  const float* at = value.data() + r * n + c;
  return (1 - fy) * ((1 - fx) * at[0] + fx * at[1]) + fy * ((1 - fx) * at[n] + fx * at[n + 1]);
}

Scene scene_between(const Packing& low, const Packing& high, const Parameters& parameters) {
  if (low.grains.radius != high.grains.radius || low.grains.material != high.grains.material ||
      low.grains.id != high.grains.id)
    throw refusal(
        "the two states do not hold the same grains ({} and {}); take them from one run, between which none came in or "
        "left",
        low.grains.size(), high.grains.size());
  return make_scene(&low, high, parameters);
}

Scene scene_of_state(const Packing& state, const Parameters& parameters) {
  return make_scene(nullptr, state, parameters);
}

Scene scene_of_field(const FieldResult& result, const Parameters& parameters) {
  const std::size_t grains = result.map.grain_class.size();
  if (result.field.size() == 0)
    throw refusal("\"{}\" is not loaded, so its stress does not change; name a load of the cemented sample",
                  result.name);
  if (result.packing.grains.size() < grains || grains == 0)
    throw refusal("\"{}\" was loaded from a picture, whose grains are not disks; the camera films results of a recipe",
                  result.name);
  check_points(result.packing.grains, grains, parameters.optics);
  Scene scene{result.packing.grains,   mean_displacements(result), {}, result.packing.domain, {},
              result.packing.materials};
  scene.grains.resize(grains);
  scene.low.wall[right].position = result.map.width * result.map.dx;
  scene.low.wall[top].position = result.map.height * result.map.dx;
  scene.low.wall[left].position = scene.low.wall[bottom].position = 0;
  scene.high = scene.low;
  const double cell = parameters.optics.pixel / static_cast<double>(parameters.optics.supersampling);
  const int points = std::clamp(static_cast<int>(std::ceil(cell / result.map.dx)), 1, 16);
  for (std::size_t g = 0; g < grains; ++g) {
    const GrainNodes nodes(result, static_cast<std::int32_t>(g));
    scene.stress.push_back(fill_patch(scene.grains.radius[g], cell, [&](Vec2 middle, double) {
      return cell_mean(nodes, scene.grains.position[g] + middle, cell, points);
    }));
  }
  return scene;
}

WallChange change_of_lower_wall(const Packing* low, const Packing& high) {
  const Wall& end = high.domain.wall[bottom];
  if (!low) return {end.force, 0};
  const Wall& start = low->domain.wall[bottom];
  return {end.force - start.force, end.position - start.position};
}

}  // namespace arenite::camera
