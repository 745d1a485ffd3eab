#include "report/summary.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.hpp"
#include "io/field_file.hpp"
#include "io/film_result_file.hpp"
#include "io/run_folder.hpp"
#include "io/sealed_file.hpp"
#include "io/stage_file.hpp"
#include "report/field_text.hpp"
#include "report/film_text.hpp"
#include "report/headlines.hpp"
#include "statistics/numbers.hpp"
#include "recipe/recipe.hpp"
#include "workflow/run.hpp"
#include "grains/texture/texture.hpp"

namespace arenite::report {
namespace {


std::string made_by(const Provenance& p) {
  const std::string title = study::title_in(p.recipe);
  return fmt::format("{}{}Made by Arenite {}, {}{}seed {}; input {}\n", title, title.empty() ? "" : "\n", p.version,
                     p.kernel.empty() ? "" : "kernel ", p.kernel.empty() ? "" : p.kernel + ", ", p.seed, p.input_hash.substr(0, 12));
}

Numbers provenance(const Provenance& p) {
  Numbers options = Numbers::tree();
  for (const auto& [key, value] : p.options) options[key] = value;
  return {{"title", study::title_in(p.recipe)}, {"version", p.version}, {"stage", p.stage}, {"input_hash", p.input_hash}, {"seed", p.seed},
          {"kernel", p.kernel},   {"options", options}, {"recipe", p.recipe}};
}

Numbers walls(const Domain& domain) {
  Numbers j = Numbers::tree();
  for (std::size_t side = 0; side < domain.wall.size(); ++side) {
    const Wall& wall = domain.wall[side];
    if (!wall.present) continue;
    j[side_names[side]] = {{"position_m", wall.position}, {"velocity_m_s", wall.velocity}, {"force_N", wall.force},
                           {"shear_force_N", wall.shear_force}};
  }
  return j;
}

Numbers energies(const Energies& e) {
  Numbers j = Numbers::tree();
  for (const EnergyTerm& term : energy_terms) j[term.name] = e.*term.value;
  return j;
}

Numbers state(const Frame& frame) {
  const Equilibrium& q = frame.equilibrium;
  return {{"label", frame.label}, {"time_s", frame.time}, {"step", frame.step}, {"walls", walls(frame.packing.domain)},
          {"equilibrium", {{"unbalanced_ratio", q.unbalanced_ratio}, {"kinetic_ratio", q.kinetic_ratio},
                           {"loose_kinetic_ratio", q.loose_kinetic}, {"falling", q.falling}, {"mobilisation", q.mobilisation}, {"wall_speed_m_s", q.wall_speed}}},
          {"energies_J", energies(frame.energies)}};
}

/// Lines "name  value", the values in one column.
class Lines {
 public:
  void heading(const std::string& text) { text_ += "\n" + text + "\n"; }
  void add(const std::string& name, const std::string& value) {
    if (!value.empty()) text_ += fmt::format("  {:<34} {}\n", name, value);
  }
  /// Lines that are laid out already.
  void block(std::string_view lines) {
    while (!lines.empty()) {
      const auto length = std::min(lines.find('\n'), lines.size());
      text_ += fmt::format("  {}\n", lines.substr(0, length));
      lines.remove_prefix(std::min(length + 1, lines.size()));
    }
  }
  std::string text() && { return std::move(text_); }

 private:
  std::string text_;
};

void describe_state(Lines& lines, const Frame& frame) {
  lines.heading(fmt::format("Last state: {} (t = {:.6g} s, step {})", frame.label, frame.time, frame.step));
  const Domain& d = frame.packing.domain;
  for (std::size_t side = 0; side < d.wall.size(); ++side)
    if (d.wall[side].present)
      lines.add(fmt::format("{} wall", side_names[side]), fmt::format("at {:.6g} m, force {:.5g} N, along it {:.5g} N", d.wall[side].position,
                                                                      d.wall[side].force, d.wall[side].shear_force));
  if (d.periodic_x || d.periodic_y)
    lines.add("periodic cell", fmt::format("{:.6g} m x {:.6g} m, tilt {:.6g} m", d.width(), d.height(), d.tilt));
  lines.add("unbalanced force ratio", fmt::format("{:.2e}", frame.equilibrium.unbalanced_ratio));
  lines.add("kinetic/elastic energy", fmt::format("{:.2e}", frame.equilibrium.kinetic_ratio));
  lines.add("the same of grains that carry nothing", fmt::format("{:.2e}", frame.equilibrium.loose_kinetic));
  if (frame.equilibrium.falling > 0) lines.add("share of grains that fall", fmt::format("{:.4f}", frame.equilibrium.falling));
  lines.add("mean |Ft|/Fn", fmt::format("{:.3f}", frame.equilibrium.mobilisation));
  for (const EnergyTerm& term : energy_terms)
    if (const double value = frame.energies.*term.value; value != 0) lines.add(term.phrase, fmt::format("{:.5g} J", value));
}

/// As stored, or measured now.
Numbers last_texture(const StageResult& last) {
  if (!last.texture.empty()) return last.texture;
  if (last.frames.empty()) return Numbers::tree();
  return texture::numbers(texture::measure(last.frames.back().packing, study::texture_options(last.provenance)));
}

/// The text does not show the REV study, which takes longest.
texture::Texture texture_without_rev(const StageResult& last) {
  texture::Options options = study::texture_options(last.provenance);
  options.rev_sizes = 0;
  return texture::measure(last.frames.back().packing, options);
}

}  // namespace

Summary::Summary(const std::filesystem::path& result) {
  for (const auto& file : io::stage_files(result)) {
    if (io::sealed_kind(file) == "field") {
      FieldResult field = io::read_field(file);
      fields_.push_back({file.filename().string(), field.name, field.outcome, field.numbers, field.converged, field.provenance});
      continue;
    }
    if (io::sealed_kind(file) == "film") {
      films_.push_back(io::read_film_result(file));
      continue;
    }
    Stage stage{file.filename().string(), io::read_stage(file), 0};
    stage.states = stage.result.frames.size();
    if (stage.states > 1) stage.result.frames.erase(stage.result.frames.begin(), stage.result.frames.end() - 1);
    stages_.push_back(std::move(stage));
  }
}

Summary::Summary(const study::RunOutcome& outcome) {
  for (std::size_t s = 0; s < outcome.stages.size(); ++s) {
    const StageResult& result = outcome.stages[s];
    Stage stage{outcome.files[s].filename().string(), {}, result.frames.size()};
    stage.result.provenance = result.provenance;
    stage.result.name = result.name;
    stage.result.converged = result.converged;
    stage.result.outcome = result.outcome;
    stage.result.texture = result.texture;
    if (!result.frames.empty()) stage.result.frames.push_back(result.frames.back());
    stages_.push_back(std::move(stage));
  }
  for (std::size_t f = 0; f < outcome.fields.size(); ++f) {
    const FieldResult& field = outcome.fields[f];
    fields_.push_back({outcome.files[outcome.stages.size() + f].filename().string(), field.name, field.outcome, field.numbers,
                       field.converged, field.provenance});
  }
}

Numbers Summary::numbers() const {
  if (!films_.empty()) return film_numbers(films_.back());
  const Numbers texture = stages_.empty() ? Numbers::tree() : last_texture(stages_.back().result);
  Numbers j = fields_.empty() ? texture : fields_.back().numbers;
  if (!fields_.empty() && !stages_.empty()) j["texture"] = texture;
  j["provenance"] = provenance(fields_.empty() ? stages_.back().result.provenance : fields_.back().provenance);
  for (const Stage& stage : stages_) {
    Numbers one{{"name", stage.result.name}, {"file", stage.file}, {"input_hash", stage.result.provenance.input_hash},
             {"converged", stage.result.converged}, {"outcome", stage.result.outcome}, {"states", stage.states}};
    if (!stage.result.frames.empty()) one["last_state"] = state(stage.result.frames.back());
    j["stages"].push_back(one);
  }
  for (const Field& field : fields_)
    j["stages"].push_back({{"name", field.name}, {"file", field.file}, {"input_hash", field.provenance.input_hash},
                           {"converged", field.converged}, {"outcome", field.outcome}, {"numbers", field.numbers}});
  return j;
}

std::string Summary::how_stages_ended() const {
  Lines lines;
  lines.heading("Stages");
  for (const Stage& stage : stages_) {
    lines.add(stage.result.name, (stage.result.converged ? "" : "NOT AT REST: ") + stage.result.outcome);
    lines.add("", fmt::format("{} {} in {}", stage.states, stage.states == 1 ? "state" : "states", stage.file));
  }
  for (const Field& field : fields_) {
    lines.add(field.name, (field.converged ? "" : "NOT SOLVED: ") + field.outcome);
    lines.add("", field.file);
  }
  return made_by(fields_.empty() ? stages_.back().result.provenance : fields_.back().provenance) + std::move(lines).text();
}

std::string Summary::text() const {
  const std::string more = "\n`arenite show RESULT --all` prints every number, `--json` the same for programs; docs/measure.md and docs/stress.md say what each is.\n";
  if (!films_.empty()) return all();
  if (!fields_.empty()) return how_stages_ended() + field_headlines(fields_.back().numbers) + more;
  const StageResult& last = stages_.back().result;
  if (last.frames.empty()) return how_stages_ended();
  return how_stages_ended() + headlines(last, texture_without_rev(last)) + more;
}

std::string Summary::all() const {
  if (!films_.empty()) return made_by(films_.back().provenance) + film_text(films_.back());
  if (!fields_.empty()) return how_stages_ended() + field_text(fields_.back().numbers);
  Lines lines;
  const StageResult& last = stages_.back().result;
  if (!last.frames.empty()) {
    describe_state(lines, last.frames.back());
    lines.heading("Texture of the last state");
    lines.block(texture::to_text(texture_without_rev(last)));
  }
  return how_stages_ended() + std::move(lines).text();
}

std::string field_summary(const FieldResult& result) {
  return fmt::format("{}{}: {}\n", result.name, result.converged ? "" : " NOT SOLVED", result.outcome) + field_text(result.numbers);
}

Numbers field_numbers(const FieldResult& result) {
  Numbers j = result.numbers;
  j["provenance"] = provenance(result.provenance);
  j["converged"] = result.converged;
  j["outcome"] = result.outcome;
  return j;
}

}  // namespace arenite::report
