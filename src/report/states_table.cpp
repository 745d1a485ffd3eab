#include "report/states_table.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "core/error.hpp"
#include "core/mapped.hpp"
#include "core/option.hpp"
#include "grains/fields/loading.hpp"
#include "grains/fields/state_curves.hpp"
#include "io/disk/store_file.hpp"
#include "io/results/results.hpp"

namespace arenite::report {
namespace {

using statistics::Columns;

/// A stage with what is told of its states.
struct Told {
  std::string stage;
  std::vector<std::string> labels;
  Columns columns;
};

template <int D> Told told_of(const StageResultIn<D>& stage, const DomainIn<D>& start) {
  Told told{stage.name, mapped(stage.snapshots, &SnapshotIn<D>::label), {}};
  Columns& to = told.columns;
  to.put("time", "s", "Time of the state", mapped(stage.snapshots, &SnapshotIn<D>::time));
  const Columns strains = fields::strains_of_boxes<D>(stage, start), numbers = fields::numbers_of_states<D>(stage);
  for (const Columns* part : {&strains, &numbers}) to.list.insert(to.list.end(), part->list.begin(), part->list.end());
  to.put("mobilisation", "", "Mean |F_t|/F_n of the contacts that push",
         mapped(stage.snapshots, [](const auto& state) { return state.equilibrium.mobilisation; }));
  return told;
}

/// Takes stages in their order; the first has its own first state for the one before.
template <int D> struct Before {
  std::optional<DomainIn<D>> domain;

  void tell(const StageResultIn<D>& stage, std::vector<Told>& to) {
    if (stage.snapshots.empty()) return;
    to.push_back(told_of(stage, domain.value_or(stage.snapshots.front().packing.domain)));
    domain = stage.snapshots.back().packing.domain;
  }
};

std::vector<Told> every_stage(const std::filesystem::path& result) {
  std::vector<Told> stages;
  Before<2> disks;
  Before<3> spheres;
  for (const auto& file : io::stage_files(result)) {
    const auto any = io::read_result(file);
    if (const auto* stage = std::get_if<StageResult>(&any)) disks.tell(*stage, stages);
    if (const auto* stage = std::get_if<SphereResult>(&any)) spheres.tell(*stage, stages);
  }
  if (stages.empty())
    throw InputError(result.string(), 0,
                     "holds no stages of loading, so there is no stress path; leave out " + option("states"));
  return stages;
}

/// Those that any stage has, each once, in the order of the stage that has most.
std::vector<const statistics::Column*> heads_of(const std::vector<Told>& stages) {
  auto order = mapped(stages, [](const Told& stage) { return &stage; });
  std::ranges::stable_sort(order, std::greater{}, [](const Told* stage) { return stage->columns.list.size(); });
  std::vector<const statistics::Column*> heads;
  for (const Told* stage : order)
    for (const statistics::Column& column : stage->columns.list) {
      const auto at = std::ranges::find(heads, column.name, [](const auto* head) { return head->name; });
      if (at == heads.end()) heads.push_back(&column);
      else if (column.tells_errors) *at = &column;
    }
  return heads;
}

std::string cell(const std::vector<double>& values, std::size_t row) {
  return row < values.size() && std::isfinite(values[row]) ? fmt::format(",{:.6g}", values[row] + 0.0) : ",";
}

}  // namespace

std::string states_table(const std::filesystem::path& result) {
  const std::vector<Told> stages = every_stage(result);
  const auto heads = heads_of(stages);
  std::string text = "stage,label";
  for (const statistics::Column* head : heads) {
    const std::string unit = head->meaning.unit.empty() ? "" : " [" + head->meaning.unit + "]";
    text += "," + head->name + unit;
    if (head->tells_errors) text += "," + head->name + "_error" + unit;
  }
  text += "\n";
  for (const Told& stage : stages)
    for (std::size_t row = 0; row < stage.labels.size(); ++row) {
      text += stage.stage + "," + stage.labels[row];
      for (const statistics::Column* head : heads) {
        const statistics::Column* column = stage.columns.find(head->name);
        text += column ? cell(column->values, row) : ",";
        if (head->tells_errors) text += column ? cell(column->error, row) : ",";
      }
      text += "\n";
    }
  return text;
}

}  // namespace arenite::report
