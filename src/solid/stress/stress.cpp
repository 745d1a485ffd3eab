#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "core/problems.hpp"
#include "solid/stress/component_statistics.hpp"
#include "solid/stress/grains.hpp"
#include "solid/stress/selection.hpp"
#include "solid/stress/stress.hpp"

namespace arenite::stress {
namespace {

using statistics::described;

double value(const StressField& field, Component component, std::size_t i) {
  switch (component) {
    case Component::xx: return field.xx[i];
    case Component::xy: return field.xy[i];
    case Component::hydrostatic: return 0.5 * (field.xx[i] + field.yy[i]);
    default: return field.yy[i];
  }
}

}  // namespace

const char* name_of(Component component) {
  constexpr const char* names[] = {"sigma_yy", "sigma_xx", "sigma_xy", "sigma_hyd"};
  return names[static_cast<int>(component)];
}

Statistics measure(const PhaseMap& map, const StressField& field, const StressOptions& options) {
  const Selection selection = select(map, field, options);
  Numbers j{
      {"nodes", described(selection.nodes, "", "Nodes of particles and matrix that are considered")},
      {"clamp_nodes", described(selection.clamp_nodes, "", "Nodes left out as clamp rows")},
      {"surface_nodes", described(selection.surface_nodes, "", "Nodes left out that border another phase or grain")},
      {"unloaded_nodes", described(selection.unloaded_nodes, "", "Nodes without any stress")},
      {"options",
       {{"clamp_rows", options.clamp_rows},
        {"leave_out_surface", options.leave_out_surface},
        {"leave_out_unloaded", options.leave_out_unloaded},
        {"sample_mean_over", options.mean_over_area ? "area" : "particles and matrix"},
        {"blocks", options.blocks}}}};
  j["options"].mark(Trait::detail);
  std::vector<std::pair<Component, std::string>> notes;
  bool any = false;
  for (const Component component : options.components) {
    std::vector<std::string> said;
    Numbers measured = component_statistics(
        selection, name_of(component), [&](std::size_t i) { return value(field, component, i); },
        options.mean_over_area, said);
    if (measured.is_known()) {
      j[name_of(component)] = std::move(measured);
      any = true;
    }
    for (std::string& note : said) notes.emplace_back(component, std::move(note));
  }
  if (!any) throw InputError(notes.front().second);
  GrainStresses grains = measure_grains(map, field, options.clamp_rows, options.blocks);
  if (!grains.nodes.empty()) j["grains"] = numbers(grains);
  return {std::move(j), std::move(grains), std::move(notes)};
}

Numbers numbers(const Statistics& s, bool curves, std::span<const Component> components) {
  const auto wanted = [&](Component component) { return std::ranges::count(components, component) > 0; };
  Numbers j = s.numbers, notes = Numbers::list();
  for (const Component component : all_components)
    if (!wanted(component)) j.erase(name_of(component));
  for (const auto& [component, note] : s.notes)
    if (wanted(component)) notes.push_back(note);
  j["notes"] = std::move(notes);
  if (!curves) erase(j, Trait::curve);
  return j;
}

std::string to_text(const Statistics& s) {
  Numbers shown = numbers(s);
  erase(shown, Trait::detail);
  return arenite::to_text(shown);
}

}  // namespace arenite::stress
