#include <fmt/format.h>

#include <cmath>

#include "io/disk/store_file.hpp"
#include "io/results/results.hpp"
#include "report/run_means.hpp"
#include "report/summary.hpp"
#include "workflow/run.hpp"

namespace arenite::report {
namespace {

constexpr const char* path_heads = "time [s],strain_x,strain_y,volume_strain,p [Pa],q [Pa],q_over_p";

/// Heads of columns, and the numbers of the texture that stand below them. Anisotropies have a sign against the axis of loading, or of greatest
/// compression where there are several; `show` without --states prints how large they are.
constexpr std::pair<const char*, const char*> columns[] = {{"solid_fraction", "solid_fraction"},
                                                           {"z", "coordination.all"},
                                                           {"z_without_rattlers", "coordination.without_rattlers"},
                                                           {"rattlers", "coordination.rattlers"},
                                                           {"a_c_signed", "fabric.a_c_signed"},
                                                           {"a_c_signed_strong", "fabric.sets.strong.a_c_signed"},
                                                           {"a_c_signed_weak", "fabric.sets.weak.a_c_signed"},
                                                           {"strong_share", "force.strong_share"},
                                                           {"q_on_strong", "stress_details.strong_share_of_deviator"}};

/// Strains are compression positive since the state before the stage; those of the volume are negative where the sample dilates. q/p is the sine of
/// the mobilised angle of friction.
std::vector<double> row_of(const Frame& frame, const Domain& start, const Numbers& texture) {
  const Domain& now = frame.packing.domain;
  const double p = number_at(texture, "stress_details.pressure_Pa"), q = number_at(texture, "stress_details.deviator_Pa");
  std::vector<double> row{frame.time, 1 - now.width() / start.width(), 1 - now.height() / start.height(), 1 - now.area() / start.area(), p, q, q / p};
  for (const auto& [head, name] : columns) row.push_back(number_at(texture, name));
  row.push_back(frame.equilibrium.mobilisation);
  return row;
}

std::vector<StageResult> stages_of(const std::filesystem::path& result) {
  std::vector<StageResult> stages;
  for (const auto& file : io::stage_files(result)) {
    auto any = io::read_result(file);
    if (auto* stage = std::get_if<StageResult>(&any)) stages.push_back(std::move(*stage));
  }
  if (stages.empty()) throw InputError(result.string(), 0, "holds no stages of loading, so there is no stress path; leave out --states");
  return stages;
}

}  // namespace

std::string states_table(const std::filesystem::path& result) {
  std::string text = fmt::format("stage,label,{}", path_heads);
  for (const auto& [head, name] : columns) text += fmt::format(",{}", head);
  text += ",mobilisation\n";
  const auto stages = stages_of(result);
  const Domain* before = nullptr;  // of the first stage the reference is its own first state
  for (const StageResult& stage : stages) {
    if (stage.frames.empty()) continue;
    texture::Options options = workflow::texture_options(stage.provenance);
    options.rev_sizes = options.rev_places = 1;
    const Domain& start = before ? *before : stage.frames.front().packing.domain;
    for (const Frame& frame : stage.frames) {
      text += fmt::format("{},{}", stage.name, frame.label);
      for (const double value : row_of(frame, start, texture::numbers(texture::measure(frame.packing, options))))
        text += std::isfinite(value) ? fmt::format(",{:.6g}", value + 0.0) : ",";
      text += "\n";
    }
    before = &stage.frames.back().packing.domain;
  }
  return text;
}

}  // namespace arenite::report
