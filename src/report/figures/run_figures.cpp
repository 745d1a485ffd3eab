#include "report/figures/run_figures.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <utility>

#include "core/mapped.hpp"
#include "grains/packing/population.hpp"
#include "report/figures/flow_figures.hpp"
#include "report/figures/grains/grain_values.hpp"
#include "report/figures/spheres/orientations.hpp"
#include "report/figures/stage_figures.hpp"
#include "report/figures/state_figures.hpp"
#include "report/figures/test_figures.hpp"

namespace arenite::report::figures {
namespace {

using statistics::Estimate;

struct Followed {
  const char *name, *colour;
  std::function<Estimate(const Numbers&)> of;
};

auto at(const char* path) {
  return [path](const Numbers& texture) { return estimate_at(texture, path); };
}

Estimate stress_ratio(const Numbers& texture) {
  const double p = estimate_at(texture, "/stress_details/pressure_Pa").value,
               q = estimate_at(texture, "/stress_details/deviator_Pa").value;
  return p > 0 ? Estimate{q / p} : Estimate{};
}

/// Numbers of the states in their order, counted from 1.
Panel over_states(const RunData& run, const std::string& label, const std::vector<Followed>& lines) {
  Panel panel{{.label = "stored state"}, {.label = label}};
  for (const Followed& line : lines) {
    Series series{.name = line.name, .colour = line.colour, .line = Line::solid, .points = true};
    for (std::size_t k = 0; k < run.textures.size(); ++k) {
      if (!run.textures[k] || !std::isfinite(estimate_at(*run.textures[k], "/fabric/a_c").value)) continue;
      const Estimate number = line.of(*run.textures[k]);
      if (!std::isfinite(number.value)) continue;
      series.x.push_back(static_cast<double>(k + 1));
      series.y.push_back(number.value);
      series.error.push_back(number.error);
    }
    if (!series.x.empty()) panel.series.push_back(std::move(series));
  }
  for (std::size_t k = 0; k < run.textures.size(); ++k) panel.now.x.push_back(static_cast<double>(k + 1));
  return panel;
}

Drawings stress_path(const RunData& run) {
  const auto known = std::ranges::count_if(run.textures, [](const Numbers* texture) {
    return texture && std::isfinite(estimate_at(*texture, "/fabric/a_c").value);
  });
  if (known < 3) return {};
  Drawing drawing;
  drawing.panels = {over_states(run, "contacts per grain",
                                {{"z", "strong", at("/coordination/all")},
                                 {"z without rattlers", "weak", at("/coordination/without_rattlers")}}),
                    over_states(run, "anisotropy of contacts and stress",
                                {{"q/p", "accent", stress_ratio},
                                 {"a_{c}, all", "line 2", at("/fabric/a_c_signed")},
                                 {"a_{c}, strong", "line 0", at("/fabric/sets/strong/a_c_signed")},
                                 {"a_{c}, weak", "line 3", at("/fabric/sets/weak/a_c_signed")}})};
  for (const Panel& panel : drawing.panels)
    for (const Series& series : panel.series) drawing.key.push_back({series.name, series.colour});
  return {drawing};
}

/// Size curves by mass of the grains as they are and as the recipe asked for them.
Drawings size_curve(const RunData& run) {
  if (!run.last || run.asked.diameter.empty()) return {};
  const packing::SizeCurve measured = packing::measured_size_curve(run.last->grains, run.last->materials);
  Panel panel{{.label = "diameter", .unit = "mm"},
              {.label = "mass passing", .unit = "%", .brief = "passing", .low = 0, .high = 100}};
  double low = 1e300, high = 0;
  const auto add = [&](const char* name, const char* colour, Line line, const packing::SizeCurve& curve) {
    for (const double d : curve.diameter) low = std::min(low, 1e3 * d), high = std::max(high, 1e3 * d);
    panel.series.push_back({.name = name,
                            .colour = colour,
                            .x = scaled(curve.diameter, 1e3),
                            .y = scaled(curve.passing, 100),
                            .line = line,
                            .steps = true});
  };
  add("measured", "strong", Line::solid, measured);
  add("asked", "accent", Line::dashed, {run.asked.diameter, run.asked.passing});
  if (panel.series.front().x.empty()) return {};
  panel.x.logarithmic = low > 0 && high > 20 * low;
  panel.x.low = high > low ? low : 0.9 * low;
  panel.x.high = high > low ? high : 1.1 * low;
  panel.selected = "diameter";
  return {{.panels = {panel}, .key = {{"measured", "strong"}, {"asked", "accent", {}, Line::dashed}}}};
}

Drawings scatter_of_last(const RunData& run) { return run.grains ? grain_scatter(run.grains) : Drawings{}; }

}  // namespace

const std::vector<Row<RunData>>& run_figures() {
  static const std::vector<Row<RunData>> list{
      {{"size-curve", "size-curve", "Size curve",
        "Fraction of the mass in grains no wider than the given diameter, for the grains drawn and for the size laws "
        "of "
        "the recipe."},
       size_curve},
      {grain_scatter_head(), scatter_of_last},
      {{"stress-path", "stress-path", "Stress path",
        "Stored states in order, with standard errors: coordination number; signed a_{c} of the contacts along the "
        "loading axis, and the stress ratio q/p.",
        true},
       stress_path}};
  return list;
}

namespace {

/// Those of disks that say the same of spheres.
const Head orientations_of_spheres{
    "orientations",
    "contact-orientations",
    "Contact orientations",
    {"Contacts by their direction over the number in each of 75 equal parts of half the sphere "
     "that no preferred direction would give; strong: F_{n} > \u27e8F_{n}\u27e9.",
     "Lambert's equal-area projection, seen from above, or the sphere as the picture shows the sample; the cross is "
     "the "
     "direction of most."},
    true,
    {{"half", "", {{"above", "From above"}, {"turned", "As the picture"}}, Choice::Print::first}}};

constexpr const char *of_spheres[] = {"contact-numbers", "forces", "sigma-norm", "rev"},
                     *over_time[] = {"discharge",       "grain-bonds", "wall-forces",
                                     "boundary-forces", "energies",    "equilibrium"};

template <class Data> const Row<Data>& row_of(const std::vector<Row<Data>>& list, std::string_view id) {
  return *std::ranges::find_if(list, [&](const Row<Data>& row) { return row.head.id == id; });
}

Drawings draw_orientations(const SphereResult& stage) {
  Drawings drawings = stage.texture.is_tree() ? orientations_in_space(stage.texture) : Drawings{};
  if (drawings.empty()) return drawings;
  drawings.push_back(drawings.front());
  for (std::size_t k = 0; k < drawings.size(); ++k)
    drawings[k].chosen = {{"half", orientations_of_spheres.choices.front().options[k].value}};
  return drawings;
}

Drawings scatter_of_spheres(const SphereResult& stage) {
  if (stage.snapshots.empty()) return {};
  return grain_scatter([&](std::string_view name) { return grain_values(stage, stage.snapshots.back(), name); });
}

template <std::size_t k> Drawings draw_state(const SphereResult& stage) {
  if (!stage.texture.is_tree() || stage.snapshots.empty()) return {};
  const auto names = mapped(stage.snapshots.back().packing.materials, &Material::name);
  return row_of(state_figures(), of_spheres[k]).draw({stage.texture, names});
}

bool has_walls(const SphereResult& stage) {
  return !stage.snapshots.empty() &&
         std::ranges::any_of(stage.snapshots.back().packing.domain.wall, &WallIn<3>::present);
}

/// Figures of the history are the same whatever the dimension of its states.
template <std::size_t k> Drawings draw_history(const SphereResult& stage) {
  StageResult rows;
  rows.name = stage.name;
  rows.history = stage.history;
  rows.texture = stage.texture;
  for (const SnapshotIn<3>& state : stage.snapshots) rows.snapshots.emplace_back().time = state.time;
  const StageData data{rows, mapped(rows.snapshots, [](const Snapshot& state) { return &state; }), nullptr};
  const std::string_view id = over_time[k];
  if (id == "wall-forces" && !has_walls(stage)) return {};
  if (id == "boundary-forces" && !stage.snapshots.empty())
    return boundary_forces(data, stage.snapshots.back().packing.domain.boundaries);
  return row_of(stage_figures(), over_time[k]).draw(data);
}

}  // namespace

const std::vector<Row<SphereResult>>& sphere_figures() {
  static const std::vector<Row<SphereResult>> all{{row_of(stage_figures(), "test-curves").head, test_curves},
                                                  {row_of(stage_figures(), over_time[0]).head, draw_history<0>},
                                                  {row_of(stage_figures(), "collapse").head, collapse},
                                                  {row_of(stage_figures(), "surface-angle").head, surface_angle},
                                                  {orientations_of_spheres, draw_orientations},
                                                  {row_of(state_figures(), of_spheres[0]).head, draw_state<0>},
                                                  {row_of(state_figures(), of_spheres[1]).head, draw_state<1>},
                                                  {row_of(state_figures(), of_spheres[2]).head, draw_state<2>},
                                                  {grain_scatter_head(), scatter_of_spheres},
                                                  {row_of(state_figures(), of_spheres[3]).head, draw_state<3>},
                                                  {row_of(stage_figures(), over_time[1]).head, draw_history<1>},
                                                  {row_of(stage_figures(), over_time[2]).head, draw_history<2>},
                                                  {row_of(stage_figures(), over_time[3]).head, draw_history<3>},
                                                  {row_of(stage_figures(), over_time[4]).head, draw_history<4>},
                                                  {row_of(stage_figures(), over_time[5]).head, draw_history<5>}};
  return all;
}

}  // namespace arenite::report::figures
