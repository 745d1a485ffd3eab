#include "report/field_drawing.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "core/error.hpp"
#include "core/mapped.hpp"
#include "model/field_quantities.hpp"
#include "model/kinds.hpp"
#include "solid/grid/map_numbers.hpp"
#include "solid/stress/grains.hpp"
#include "solid/stress/sample_means.hpp"

namespace arenite::report {
namespace {

constexpr int most_nodes = 512, most_zoomed = 256;  // across a picture
constexpr double view_over_radius = 1.35;
constexpr double rounding = 1e-6;  // nodes, of a centre that lies on one

/// Nodes of a map from its lower left corner: every `step`th.
struct View {
  int x = 0, y = 0, width = 0, height = 0, step = 1;
  std::size_t node(const PhaseMap& map, int column, int row_from_top) const {
    return map.index(x + column * step, y + (height - 1 - row_from_top) * step);
  }
  Numbers json(const PhaseMap& map) const {
    const double mm = 1e3 * map.dx * step;
    return {{"size", {std::round(1e4 * width * mm) / 1e4, std::round(1e4 * height * mm) / 1e4}},
            {"nodes", {width, height}}};
  }
};

/// Nodes in and about the large grain nearest to the middle.
View about_middle_grain(const PhaseMap& map) {
  const stress::GrainStresses grains = stress::measure_grains(map, {}, 0, 1);
  const bool classes = std::ranges::count(map.grain_class, GrainClass::large) > 0;
  Vec2 middle;
  double radius = 0, least = INFINITY;
  for (std::size_t g = 0; g < grains.nodes.size(); ++g) {
    const Vec2 centre = (1 / map.dx) * grains.centre[g] - Vec2{0.5, 0.5};
    const double away = norm(centre - 0.5 * Vec2{static_cast<double>(map.width), static_cast<double>(map.height)});
    if (grains.nodes[g] == 0 || (classes && map.grain_class[g] != GrainClass::large) || away >= least) continue;
    middle = centre;
    radius = grid::radius_over(static_cast<double>(grains.nodes[g]));
    least = away;
  }
  if (radius == 0) throw InputError("the sample has no grain to draw");
  const int reach = static_cast<int>(std::ceil(view_over_radius * radius));
  View view;
  view.step = (2 * reach + most_zoomed - 1) / most_zoomed;
  view.x = std::max(0, static_cast<int>(middle.x + rounding) - reach);
  view.y = std::max(0, static_cast<int>(middle.y + rounding) - reach);
  view.width = std::min(map.width - view.x, 2 * reach) / view.step;
  view.height = std::min(map.height - view.y, 2 * reach) / view.step;
  return view;
}

/// Where the grain changes: grain -1 is matrix and void, whose own border the picture shows.
Numbers edges_of(const PhaseMap& map, const View& view) {
  Numbers edges = Numbers::list();
  for (int row = 0; row < view.height; ++row)
    for (int column = 0; column < view.width; ++column) {
      const std::int32_t here = map.grain[view.node(map, column, row)];
      if (column > 0 && map.grain[view.node(map, column - 1, row)] != here) edges.push_back({column, row, 1});
      if (row > 0 && map.grain[view.node(map, column, row - 1)] != here) edges.push_back({column, row, 0});
    }
  return edges;
}

View whole(const PhaseMap& map) {
  View view;
  view.step = (std::max(map.width, map.height) + most_nodes - 1) / most_nodes;
  view.width = map.width / view.step;
  view.height = map.height / view.step;
  return view;
}

Numbers phases_of(const PhaseMap& map, const View& view) {
  Numbers runs = Numbers::list();
  int last = -1, count = 0;
  const auto end_run = [&] {
    if (count > 0) runs.push_back(last), runs.push_back(count);
    count = 0;
  };
  for (int row = 0; row < view.height; ++row)
    for (int column = 0; column < view.width; ++column) {
      const int kind = static_cast<int>(kind_of(map, view.node(map, column, row)));
      if (kind != last) end_run();
      last = kind;
      ++count;
    }
  end_run();
  Numbers j = view.json(map);
  j["phases"] = std::move(runs);
  return j;
}

}  // namespace

Numbers phases_drawing(const FieldResult& sample) { return phases_of(sample.map, whole(sample.map)); }

Numbers zoom_drawing(const FieldResult& load) {
  if (load.field.size() == 0) throw InputError("this run has no stress field to draw");
  const View view = about_middle_grain(load.map);
  const double mean = stress::SampleMeans(load).of(field_quantity("sigma_yy"));
  Numbers j = view.json(load.map), stress = Numbers::list();
  for (int row = 0; row < view.height; ++row)
    for (int column = 0; column < view.width; ++column) {
      const std::size_t node = view.node(load.map, column, row);
      stress.push_back(load.map.phase[node] == Phase::empty
                           ? Numbers()
                           : Numbers(std::round(100 * load.field.yy[node] / mean) / 100));
    }
  j["stress"] = std::move(stress);
  j["edges"] = edges_of(load.map, view);
  return j;
}

Numbers cracks_drawing(const FieldResult& test) {
  if (test.cracks.empty())
    throw InputError("no bond of this run is broken; `failure = true` in [[loads]] loads the sample to failure");
  const View view = whole(test.map);
  const double node = test.map.dx * view.step;
  const auto rounded = [](double v) { return std::round(10 * v) / 10; };
  Numbers j = phases_of(test.map, view);
  j["cracks"] = {{"x", mapped(test.cracks, [&](const Crack& c) { return rounded(static_cast<double>(c.x) / node); })},
                 {"y", mapped(test.cracks,
                              [&](const Crack& c) { return rounded(view.height - static_cast<double>(c.y) / node); })},
                 {"type", mapped(test.cracks, &Crack::type)}};
  return j;
}

}  // namespace arenite::report
