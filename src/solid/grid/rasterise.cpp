#include <algorithm>
#include <cmath>

#include "core/problems.hpp"
#include "geometry/outline.hpp"
#include "geometry/rectangle.hpp"
#include "geometry/union_area.hpp"
#include "model/cement.hpp"
#include "model/periodic_images.hpp"
#include "solid/cement/cement.hpp"
#include "solid/grid/necks.hpp"
#include "solid/grid/rasterise.hpp"

namespace arenite::grid {
namespace {

/// Marks nodes of grains with their index among the placed ones.
void draw_grains(const PlacedCement& placed, const Lattice& lattice, PhaseMap& map) {
  const auto power = [](const PlacedCement::Grain& g, double x, double y) {
    const double dx = x - g.centre.x, dy = y - g.centre.y;
    return dx * dx + dy * dy - g.radius * g.radius;
  };
  for (std::size_t k = 0; k < placed.grains.size(); ++k) {
    const auto& grain = placed.grains[k];
    visit_disk(lattice, grain.centre, grain.radius, [&](int y, int x0, int x1) {
      for (int x = x0; x <= x1; ++x) {
        const std::size_t node = map.index(x, y);
        const double u = lattice.at(x), v = lattice.at(y);
        if (map.grain[node] >= 0 && power(placed.grains[map.grain[node]], u, v) <= power(grain, u, v)) continue;
        map.grain[node] = static_cast<std::int32_t>(k);
        map.phase[node] = Phase::particle;
      }
    });
  }
}

/// From indices among the placed grains to labels of grains of the packing.
void label_grains(const PlacedCement& placed, const std::vector<GrainClass>& class_of_grain, std::size_t grains,
                  PhaseMap& map, GridReport& report) {
  std::vector<std::int32_t> label(grains, -1);
  for (const auto k : map.grain)
    if (k >= 0) label[placed.grains[k].grain] = 0;
  for (std::size_t g = 0; g < grains; ++g) {
    if (label[g] < 0) continue;
    label[g] = static_cast<std::int32_t>(report.grain_of_label.size());
    report.grain_of_label.push_back(static_cast<std::int32_t>(g));
    map.grain_class.push_back(class_of_grain.empty() ? GrainClass::none : class_of_grain[g]);
  }
  for (auto& k : map.grain)
    if (k >= 0) k = label[placed.grains[k].grain];
}

/// Area of a neck that its own two grains leave bare.
double bare_area(const NeckShape& shape) {
  const auto& neck = shape.neck;
  std::vector<geometry::Outline> outlines{geometry::Outline::disk(neck.a, neck.radius_a),
                                          geometry::Outline::disk(neck.b, neck.radius_b)};
  const double reach = 2 * std::max({neck.radius_a, neck.radius_b, neck.half_a, neck.half_b}) + shape.length();
  const geometry::Rectangle all = geometry::square_about(neck.a, reach);
  const double grains = geometry::union_area(outlines, all);
  outlines.insert(outlines.end(), shape.outlines.begin(), shape.outlines.end());
  return geometry::union_area(outlines, all) - grains;
}

/// Fewest nodes of a neck on a line of the lattice (column or row, whichever lies more across it) that crosses the gap
/// between its grains; at least the line nearest to the gap's middle is looked at. Lines go on beyond the crop.
int nodes_across(const Lattice& lattice, const NeckShape& shape) {
  const auto& neck = shape.neck;
  const Vec2 along = shape.direction();
  const bool columns = std::abs(along.x) >= std::abs(along.y);
  const auto component = [&](Vec2 v, bool first) { return first == columns ? v.x : v.y; };
  const Vec2 from = neck.a + neck.radius_a * along, to = neck.b - neck.radius_b * along, middle = 0.5 * (from + to);
  const double p = lattice.place(component(from, true)), q = lattice.place(component(to, true));
  const int nearest = static_cast<int>(std::lround(lattice.place(component(middle, true))));
  // Overlapping grains have no gap: only the nearest line counts.
  const bool gap = shape.length() > neck.radius_a + neck.radius_b;
  const int low = gap ? std::min(nearest, static_cast<int>(std::ceil(std::min(p, q)))) : nearest;
  const int high = gap ? std::max(nearest, static_cast<int>(std::floor(std::max(p, q)))) : nearest;
  int fewest = -1;
  for (int line = low; line <= high; ++line) {
    const auto inside = [&](int k) {
      const double u = lattice.at(line), v = lattice.at(k);
      return shape.contains(columns ? Vec2{u, v} : Vec2{v, u});
    };
    const double step = (lattice.at(line) - component(middle, true)) / component(along, true);
    const int start =
        static_cast<int>(std::floor(lattice.place(component(middle, false) + step * component(along, false))));
    int count = 0;
    for (int k = start; inside(k); --k) ++count;
    for (int k = start + 1; inside(k); ++k) ++count;
    fewest = fewest < 0 ? count : std::min(fewest, count);
  }
  return fewest;
}

/// Notes a neck, which has nodes of matrix or not, if the middle of its gap lies in the crop.
void note_neck(const Lattice& lattice, const NeckShape& shape, bool has_matrix, GridReport& report) {
  const auto& neck = shape.neck;
  const Vec2 middle = neck.a + 0.5 * (shape.length() + neck.radius_a - neck.radius_b) * shape.direction();
  const double half = 0.5 * lattice.n * lattice.dx;
  if (std::abs(middle.x) > half || std::abs(middle.y) > half) return;
  const int across = nodes_across(lattice, shape);
  report.thinnest_neck = report.necks == 0 ? across : std::min(report.thinnest_neck, across);
  ++report.necks;
  if (has_matrix) return;
  const double bare = bare_area(shape);
  if (!(bare > 1e-9 * neck.radius_a * neck.radius_b)) return;
  ++report.lost_necks;
  report.lost_area += bare;
}

/// Whether a node became matrix, or was so already.
bool draw_neck(const NeckShape& shape, const Lattice& lattice, PhaseMap& map) {
  bool any = false;
  for (const geometry::Outline& outline : shape.outlines)
    visit_quadrilateral(lattice, outline.corner, [&](int y, int x0, int x1) {
      const double v = lattice.at(y);
      for (int x = x0; x <= x1; ++x) {
        Phase& phase = map.phase[map.index(x, y)];
        if (phase == Phase::particle || !shape.contains({lattice.at(x), v})) continue;
        phase = Phase::matrix;
        any = true;
      }
    });
  return any;
}

void draw_matrix(const PlacedCement& placed, const Lattice& lattice, PhaseMap& map, GridReport& report) {
  if (placed.full)
    for (auto& phase : map.phase) phase = phase == Phase::empty ? Phase::matrix : phase;
  if (placed.coating > 0)
    for (const auto& grain : placed.grains)
      visit_disk(lattice, grain.centre, grain.radius + placed.coating, [&](int y, int x0, int x1) {
        for (std::size_t node = map.index(x0, y); node <= map.index(x1, y); ++node)
          if (map.phase[node] == Phase::empty) map.phase[node] = Phase::matrix;
      });
  for (const auto& neck : placed.necks)
    if (const NeckShape shape(neck); !shape.outlines.empty())
      note_neck(lattice, shape, draw_neck(shape, lattice, map), report);
}

void measure_areas(const PlacedCement& placed, const PhaseMap& map, GridReport& report) {
  std::size_t particle = 0, matrix = 0;
  for (const Phase p : map.phase) particle += p == Phase::particle, matrix += p == Phase::matrix;
  const cement::Areas exact = cement::exact_areas(placed, report.window);
  const auto error = [&](std::size_t nodes, double area) {
    return area > 0 ? static_cast<double>(nodes) * report.dx * report.dx / area - 1 : 0;
  };
  report.exact_matrix_area = exact.matrix;
  report.particle_area_error = error(particle, exact.particle);
  report.matrix_area_error = error(matrix, exact.matrix);
}

int nodes_across_smallest(const PlacedCement& placed, const Lattice& lattice) {
  const double half = 0.5 * lattice.n * lattice.dx;
  const PlacedCement::Grain* smallest = nullptr;
  for (const auto& g : placed.grains) {
    const bool whole = std::abs(g.centre.x) + g.radius <= half && std::abs(g.centre.y) + g.radius <= half;
    if (whole && (!smallest || g.radius < smallest->radius)) smallest = &g;
  }
  int most = 0;
  if (smallest)
    visit_disk(lattice, smallest->centre, smallest->radius,
               [&](int, int x0, int x1) { most = std::max(most, x1 - x0 + 1); });
  return most;
}

/// The container; where there is none, what surrounds the grains.
geometry::Rectangle sample_of(const Packing& packing) {
  const Domain& d = packing.domain;
  if (d.width() > 0 && d.height() > 0) return box_of(d);
  const Grains& g = packing.grains;
  return g.size() == 0 ? geometry::Rectangle{} : geometry::bounds(g.position, g.radius);
}

}  // namespace

PhaseMap rasterise(const Packing& packing, const Cement& cement, const GridParameters& parameters,
                   const std::vector<GrainClass>& class_of_grain, GridReport& report) {
  const std::size_t grains = packing.grains.size(), classes = class_of_grain.size();
  Problems problems;
  problems.unless(parameters.nodes >= 1 && parameters.nodes <= 32768,
                  "a grid of {} nodes per side is out of range; give 1 to 32768", parameters.nodes);
  problems.unless(classes == 0 || classes == grains, "{} grains have {} size classes; give one per grain, or none",
                  grains, classes);
  problems.raise();
  report = {};
  report.window = crop_window(packing, parameters.crop);
  const int n = static_cast<int>(parameters.nodes);
  report.dx = report.window.width() / n;
  const PlacedCement placed = place(packing, cement, report.window);
  const Lattice lattice{n, report.dx};
  PhaseMap map = make_phase_map(n, n, report.dx);
  draw_grains(placed, lattice, map);
  label_grains(placed, class_of_grain, grains, map, report);
  draw_matrix(placed, lattice, map, report);
  measure_areas(placed, map, report);
  report.smallest_grain = nodes_across_smallest(placed, lattice);
  return map;
}

geometry::Rectangle crop_window(const Packing& packing, double crop) {
  const geometry::Rectangle sample = sample_of(packing);
  if (!(sample.width() > 0 && sample.height() > 0) || !std::isfinite(sample.area()))
    throw InputError("a sample without container and grains has nothing to crop; give it a domain with positive sides");
  if (!(crop >= 0) || !std::isfinite(crop))
    throw refusal("the crop is {:g} m wide; give a positive length, or 0 for the largest square", crop);
  const double largest = std::min(sample.width(), sample.height());
  if (crop > largest * (1 + 1e-12))
    throw refusal("the crop of {:g} m does not fit into the sample of {:g} x {:g} m; give at most {:g} m", crop,
                  sample.width(), sample.height(), largest);
  const double half = 0.5 * (crop > 0 ? std::min(crop, largest) : largest);
  return geometry::square_about(sample.middle(), half);
}

}  // namespace arenite::grid
