#include <fmt/format.h>

#include <cmath>

#include "io/disk/store_file.hpp"
#include "io/results/results.hpp"
#include "report/summary.hpp"
#include "workflow/run.hpp"

namespace arenite::report {
namespace {

/// One stored state on the way of a loading, with its box before the stage.
struct State {
  const Frame& frame;
  const Domain& start;
  texture::Texture texture;

  double mean_contacts(const char* of) const {
    const auto* estimate = texture::find(texture.coordination.mean, of);
    return estimate ? estimate->value : texture::unknown;
  }
  /// a_c, signed against the axis of loading, or of greatest compression where there are several.
  double anisotropy(const char* of) const {
    const auto* fabric = texture::find(texture.fabric, of);
    return fabric ? fabric->a_c_signed.value : texture::unknown;
  }
};

struct Column {
  const char* head;
  double (*value)(const State& state);
};

/// Strains are compression positive since the state before the stage; those of the volume are negative where the sample dilates. q/p is
/// the sine of the mobilised angle of friction. Anisotropies have a sign here; `show` without --states prints how large they are.
constexpr Column columns[] = {
    {"time [s]", [](const State& s) { return s.frame.time; }},
    {"strain_x", [](const State& s) { return 1 - s.frame.packing.domain.width() / s.start.width(); }},
    {"strain_y", [](const State& s) { return 1 - s.frame.packing.domain.height() / s.start.height(); }},
    {"volume_strain", [](const State& s) { return 1 - s.frame.packing.domain.area() / s.start.area(); }},
    {"p [Pa]", [](const State& s) { return s.texture.stress.pressure; }},
    {"q [Pa]", [](const State& s) { return s.texture.stress.deviator; }},
    {"q_over_p", [](const State& s) { return s.texture.stress.deviator / s.texture.stress.pressure; }},
    {"solid_fraction", [](const State& s) { return s.texture.solid_fraction.value; }},
    {"z", [](const State& s) { return s.mean_contacts("all"); }},
    {"z_without_rattlers", [](const State& s) { return s.mean_contacts("all without rattlers"); }},
    {"rattlers", [](const State& s) { return s.texture.coordination.rattlers.value; }},
    {"a_c_signed", [](const State& s) { return s.anisotropy("all"); }},
    {"a_c_signed_strong", [](const State& s) { return s.anisotropy("strong"); }},
    {"a_c_signed_weak", [](const State& s) { return s.anisotropy("weak"); }},
    {"strong_share",
     [](const State& s) {
       const auto* all = texture::find(s.texture.force.compressive, "all");
       return all ? all->fraction_above_mean.value : 0;
     }},
    {"q_on_strong", [](const State& s) { return s.texture.stress.strong_deviator_share.value; }},
    {"mobilisation", [](const State& s) { return s.frame.equilibrium.mobilisation; }},
};

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
  std::string text = "stage,label";
  for (const Column& column : columns) text += fmt::format(",{}", column.head);
  text += "\n";
  const auto stages = stages_of(result);
  const Domain* before = nullptr;  // of the first stage the reference is its own first state
  for (const StageResult& stage : stages) {
    if (stage.frames.empty()) continue;
    texture::Options options = workflow::texture_options(stage.provenance);
    options.rev_sizes = options.rev_places = 1;
    const Domain& start = before ? *before : stage.frames.front().packing.domain;
    for (const Frame& frame : stage.frames) {
      const State state{frame, start, texture::measure(frame.packing, options)};
      text += fmt::format("{},{}", stage.name, frame.label);
      for (const Column& column : columns) {
        const double value = column.value(state);
        text += std::isfinite(value) ? fmt::format(",{:.6g}", value + 0.0) : ",";
      }
      text += "\n";
    }
    before = &stage.frames.back().packing.domain;
  }
  return text;
}

}  // namespace arenite::report
