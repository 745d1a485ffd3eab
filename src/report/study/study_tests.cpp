#include "report/study/study_tests.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <list>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

#include "campaign/study_kind.hpp"
#include "core/mapped.hpp"
#include "core/problems.hpp"
#include "core/text.hpp"
#include "grains/fields/laboratory/tested_stage.hpp"
#include "grains/fields/over_runs.hpp"
#include "io/disk/store_file.hpp"
#include "io/results/results.hpp"
#include "report/figures/over_runs.hpp"
#include "report/study/default_figures.hpp"

namespace arenite::report {
namespace {

using campaign::CollectedTable;
using fields::AnyTest;
using Tests = std::vector<AnyTest>;

/// The stages of a run, of disks or of spheres, with their last states, and which of them is its test.
struct Run {
  std::vector<StageResult> stages = {};
  std::vector<SphereResult> spheres = {};
  std::size_t place = 0;
  const CollectedTable::Row* row = nullptr;

  AnyTest test() const {
    if (!spheres.empty()) return &spheres[place];
    const bool is_after = place > 0 && !stages[place - 1].snapshots.empty();
    return fields::Test{stages[place], is_after ? &stages[place - 1].snapshots.back().packing : nullptr};
  }
};

template <int D> void add_stage(std::vector<StageResultIn<D>>& list, StageResultIn<D> stage) {
  if (auto& states = stage.snapshots; states.size() > 1) states.erase(states.begin(), states.end() - 1);
  list.push_back(std::move(stage));
}

template <int D> std::size_t place_of_test(const std::vector<StageResultIn<D>>& stages) {
  return fields::stage_with_history(mapped(stages, [](const auto& stage) { return &stage; }), {});
}

/// Throws InputError for a run whose files are not there, or that has no stage.
Run read_run(const std::filesystem::path& folder, const CollectedTable::Row& row) {
  Run run;
  for (const auto& file : io::stage_files(folder)) {
    auto any = io::read_result(file);
    if (auto* disks = std::get_if<StageResult>(&any)) add_stage(run.stages, std::move(*disks));
    else if (auto* spheres = std::get_if<SphereResult>(&any)) add_stage(run.spheres, std::move(*spheres));
    else throw refusal("{} goes on to nodes, and its stages are no test of it", row.run);
  }
  run.place = run.spheres.empty() ? place_of_test(run.stages) : place_of_test(run.spheres);
  run.row = &row;
  return run;
}

/// A list, whose items stay where they are: tests refer to them.
std::list<Run> done_runs(const std::filesystem::path& study, const CollectedTable& table, bool all) {
  std::list<Run> runs;
  for (const auto& row : table.rows) {
    if (row.status != "done" || (!all && !runs.empty())) continue;
    try {
      runs.push_back(read_run(study / "runs" / row.run, row));
    } catch (const InputError&) {}  // without a test it has no place among them
  }
  return runs;
}

/// Over how much of its abscissa the points of a drawing reach.
double reach_of(const figures::Drawing& drawing) {
  double reach = 0;
  for (const figures::Series& series : drawing.panels.front().series)
    if (series.points) {
      const auto [low, high] = std::ranges::minmax(series.x);
      reach = std::max(reach, high > 0 ? 1 - low / high : 0);
    }
  return reach;
}

/// The same drawing with another's series in it, under a name and in a colour of their own.
void take_up(figures::Drawing& whole, figures::Drawing part, const std::string& name, const std::string& colour) {
  if (whole.panels.empty()) {
    whole.panels = part.panels;
    for (figures::Panel& panel : whole.panels) panel.series.clear();
  }
  for (std::size_t k = 0; k < whole.panels.size(); ++k) {
    figures::Panel &panel = whole.panels[k], &from = part.panels[k];
    if (panel.x.low && from.x.low) panel.x.low = std::min(*panel.x.low, *from.x.low);
    if (panel.x.high && from.x.high) panel.x.high = std::max(*panel.x.high, *from.x.high);
    for (figures::Series& series : from.series) {
      series.colour = colour;
      if (series.points) series.name = name;
      panel.series.push_back(std::move(series));
    }
  }
  whole.key.push_back({.name = name,
                       .colour = colour,
                       .numbers = part.key.empty() ? std::vector<figures::Said>{} : part.key.front().numbers});
  if (!part.note.empty()) whole.note += fmt::format("{}{}: {}", whole.note.empty() ? "" : " ", name, part.note);
}

struct Grouped {
  figures::Drawing drawing;
  double reach = 0;
};

/// "D = 40 mm, friction = 0.3".
std::string name_of(const CollectedTable& table, const std::vector<SweptAxis>& by, const CollectedTable::Row& row) {
  return list_of(mapped(by,
                        [&](const SweptAxis& axis) {
                          const auto& key = table.keys[axis.place];
                          return fmt::format("{} = {}{}{}", key.words, row.values[axis.place],
                                             key.unit.empty() ? "" : " ", key.unit);
                        }),
                 ", ");
}

/// A curve for each combination of the values of swept keys.
Grouped grouped(const figures::Row<Tests>& row, const std::list<Run>& runs, const CollectedTable& table,
                const std::vector<SweptAxis>& by) {
  std::vector<std::pair<std::string, Tests>> groups;
  for (const Run& run : runs) {
    const std::string name = name_of(table, by, *run.row);
    auto at = std::ranges::find(groups, name, &std::pair<std::string, Tests>::first);
    if (at == groups.end()) at = groups.insert(at, {name, {}});
    at->second.push_back(run.test());
  }
  Grouped found;
  for (std::size_t k = 0; k < groups.size(); ++k) {
    const auto drawings = row.draw(groups[k].second);
    if (drawings.empty()) continue;
    const double reach = reach_of(drawings.front());
    found.reach = found.drawing.panels.empty() ? reach : std::min(found.reach, reach);
    take_up(found.drawing, drawings.front(), groups[k].first,
            groups.size() < 3
                ? fmt::format("line {}", k)
                : fmt::format("scale {}", static_cast<double>(k) / static_cast<double>(groups.size() - 1)));
  }
  return found;
}

/// By all keys but the one that leaves most to the abscissa of the law.
figures::Drawing drawing_of(const figures::Row<Tests>& row, const std::list<Run>& runs, const CollectedTable& table) {
  auto axes = swept_axes(table);
  std::erase_if(axes, [](const SweptAxis& axis) { return axis.values < 2; });
  if (axes.size() < 2) {
    const auto drawings = row.draw(mapped(runs, &Run::test));
    return drawings.empty() ? figures::Drawing{} : drawings.front();
  }
  Grouped best;
  for (std::size_t along = 0; along < axes.size(); ++along) {
    std::vector<SweptAxis> by = axes;
    by.erase(by.begin() + static_cast<std::ptrdiff_t>(along));
    if (Grouped found = grouped(row, runs, table, by); found.reach > best.reach) best = std::move(found);
  }
  return best.drawing;
}

}  // namespace

std::vector<figures::Headline> StudyTests::headlines() const {
  auto all = figures::headlines_of(kind);
  const bool has_plateaus = std::ranges::any_of(
      laws, [](const Figure& figure) { return figure.head.id == "rheology" || figure.head.id == "critical-state"; });
  if (has_plateaus)
    std::erase_if(all, [](const auto& one) { return std::string_view(one.name).starts_with("critical_state."); });
  return all;
}

StudyTests tests_of_study(const std::filesystem::path& study, const CollectedTable& table) {
  const auto ids = campaign::kind_of_study(study).figures();
  const auto runs = done_runs(study, table, !ids.empty());
  StudyTests found;
  if (runs.empty()) return found;
  const Run& first = runs.front();
  found.kind = first.spheres.empty() ? fields::kind_of(std::get<fields::Test>(first.test()))
                                     : fields::kind_of(first.spheres[first.place]);
  for (const std::string& id : ids) {
    const auto& row = figures::figure_over_runs(id);
    try {
      if (auto drawing = drawing_of(row, runs, table); !drawing.panels.empty())
        found.laws.push_back({row.head, std::move(drawing)});
    } catch (const InputError&) {}  // runs of which one cannot be asked this
  }
  return found;
}

}  // namespace arenite::report
