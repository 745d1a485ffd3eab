#include "report/states_table.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>
#include <vector>

#include "grains/fields/loading.hpp"
#include "grains/fields/stage_numbers.hpp"
#include "io/disk/store_file.hpp"
#include "io/results/results.hpp"
#include "statistics/run_means.hpp"

namespace arenite::report {
namespace {

/// Names of columns, and the numbers of the texture that stand below them, whose units are those of the heads; q/p, the
/// sine of the mobilised angle of friction, is of the two before it. Anisotropies have a sign against the axis of
/// loading, or of greatest compression where there are several; `show` without --states prints how large they are.
constexpr std::pair<const char*, const char*> columns[] = {{"p", "stress_details.pressure_Pa"},
                                                           {"q", "stress_details.deviator_Pa"},
                                                           {"q_over_p", ""},
                                                           {"solid_fraction", "solid_fraction"},
                                                           {"z", "coordination.all"},
                                                           {"z_without_rattlers", "coordination.without_rattlers"},
                                                           {"rattlers", "coordination.rattlers"},
                                                           {"a_c_signed", "fabric.a_c_signed"},
                                                           {"a_c_signed_strong", "fabric.sets.strong.a_c_signed"},
                                                           {"a_c_signed_weak", "fabric.sets.weak.a_c_signed"},
                                                           {"strong_share", "force.strong_share"},
                                                           {"q_on_strong", "stress_details.strong_share_of_deviator"}};

/// The same of the strains, compression positive since the state before the stage.
constexpr std::pair<const char*, const char*> strains[] = {
    {"strain_x", "strain_x"}, {"strain_y", "strain_y"}, {"volume_strain", "volumetric_strain"}};

std::string head_of(const char* name, const Meaning* meaning) {
  return fmt::format(",{}{}", name, !meaning || meaning->unit.empty() ? "" : " [" + meaning->unit + "]");
}

std::string heads_of(const statistics::Columns& of_box, const Numbers& texture) {
  const auto numbers = named_numbers(texture);
  std::string heads = "stage,label,time [s]";
  for (const auto& [head, name] : strains) {
    const statistics::Column* column = of_box.find(name);
    heads += head_of(head, column ? &column->meaning : nullptr);
  }
  for (const auto& [head, name] : columns) {
    const auto at = std::ranges::find(numbers, name, &NamedNumber::name);
    heads += head_of(head, at == numbers.end() ? nullptr : at->meaning);
  }
  return heads + ",mobilisation\n";
}

std::vector<double> row_of(const StageResult& stage, std::size_t k, const statistics::Columns& of_box,
                           const Numbers& texture) {
  const Snapshot& snapshot = stage.snapshots[k];
  std::vector<double> row{snapshot.time};
  for (const auto& [head, name] : strains) row.push_back(of_box[name][k]);
  for (const auto& [head, name] : columns)
    row.push_back(*name ? statistics::number_at(texture, name) : row.back() / row[row.size() - 2]);
  row.push_back(snapshot.equilibrium.mobilisation);
  return row;
}

std::vector<StageResult> stages_of(const std::filesystem::path& result) {
  std::vector<StageResult> stages;
  for (const auto& file : io::stage_files(result)) {
    auto any = io::read_result(file);
    if (std::holds_alternative<SphereResult>(any))
      throw InputError(result.string(), 0,
                       "is of spheres, whose states are not in a table; leave out --states, or take the curves of "
                       "`arenite export --to csv`");
    if (auto* stage = std::get_if<StageResult>(&any)) stages.push_back(std::move(*stage));
  }
  if (stages.empty())
    throw InputError(result.string(), 0, "holds no stages of loading, so there is no stress path; leave out --states");
  return stages;
}

}  // namespace

std::string states_table(const std::filesystem::path& result) {
  Numbers last;
  statistics::Columns of_box;
  std::string rows;
  const auto stages = stages_of(result);
  const Domain* before = nullptr;  // of the first stage the reference is its own first state
  for (const StageResult& stage : stages) {
    if (stage.snapshots.empty()) continue;
    texture::Options options = fields::texture_options(stage);
    options.rev = {1, 1};
    const Domain& start = before ? *before : stage.snapshots.front().packing.domain;
    of_box = fields::strains_of_box(stage.snapshots, start);
    for (std::size_t k = 0; k < stage.snapshots.size(); ++k) {
      last = texture::numbers(texture::measure(stage.snapshots[k].packing, options));
      rows += fmt::format("{},{}", stage.name, stage.snapshots[k].label);
      for (const double value : row_of(stage, k, of_box, last))
        rows += std::isfinite(value) ? fmt::format(",{:.6g}", value + 0.0) : ",";
      rows += "\n";
    }
    before = &stage.snapshots.back().packing.domain;
  }
  return heads_of(of_box, last) + rows;
}

}  // namespace arenite::report
