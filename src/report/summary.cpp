#include "report/summary.hpp"

#include <fmt/format.h>

#include "io/disk/store_file.hpp"
#include "io/results/results.hpp"
#include "report/page_document.hpp"
#include "report/result_text.hpp"
#include "report/test_curves.hpp"
#include "workflow/run.hpp"

namespace arenite::report {
namespace {

std::string made_by(const Provenance& p) {
  const std::string title = recipe::title_in(p.recipe);
  return fmt::format("{}{}Made by Arenite {}, {}{}seed {}; input {}\n", title, title.empty() ? "" : "\n", p.version, p.kernel.empty() ? "" : "kernel ",
                     p.kernel.empty() ? "" : p.kernel + ", ", p.seed, p.input_hash.substr(0, 12));
}

Numbers provenance(const Provenance& p) {
  Numbers j{{"title", recipe::title_in(p.recipe)}};
  j.update(provenance_of(p));
  return j;
}

Numbers walls(const Domain& domain) {
  Numbers j = Numbers::tree();
  for (std::size_t side = 0; side < domain.wall.size(); ++side) {
    const Wall& wall = domain.wall[side];
    if (!wall.present) continue;
    j[side_names[side]] = {{"position_m", wall.position}, {"velocity_m_s", wall.velocity}, {"force_N", wall.force}, {"shear_force_N", wall.shear_force}};
  }
  return j;
}

Numbers boundaries(const Domain& domain) {
  Numbers j = Numbers::tree();
  for (const Boundary& b : domain.boundaries)
    j[b.name] = {{"present", b.present}, {"centre_m", {b.centre.x, b.centre.y}}, {"velocity_m_s", {b.velocity.x, b.velocity.y}},
                 {"spin_rad_s", b.spin}, {"force_N", {b.force.x, b.force.y}},    {"torque_N_m", b.torque}};
  return j;
}

Numbers state(const Frame& frame) {
  Numbers energies = Numbers::tree();
  for (const EnergyTerm& term : energy_terms) energies[term.name] = frame.energies.*term.value;
  Numbers j{{"label", frame.label},
            {"time_s", frame.time},
            {"step", frame.step},
            {"walls", walls(frame.packing.domain)},
            {"equilibrium", rest_of(frame.equilibrium, "wall_speed_m_s")},
            {"energies_J", energies}};
  if (!frame.packing.domain.boundaries.empty()) j["boundaries"] = boundaries(frame.packing.domain);
  return j;
}

void describe_state(TextLines& lines, const Frame& frame) {
  lines.heading(fmt::format("Last state: {} (t = {:.6g} s, step {})", frame.label, frame.time, frame.step));
  const Domain& d = frame.packing.domain;
  for (std::size_t side = 0; side < d.wall.size(); ++side)
    if (d.wall[side].present)
      lines.add(fmt::format("{} wall", side_names[side]),
                fmt::format("at {:.6g} m, force {:.5g} N, along it {:.5g} N", d.wall[side].position, d.wall[side].force, d.wall[side].shear_force));
  for (const Boundary& b : d.boundaries)
    if (b.present) lines.add(b.name, fmt::format("force {:.5g} N and {:.5g} N along x and y, torque {:.5g} N m", b.force.x, b.force.y, b.torque));
  if (d.periodic[0] || d.periodic[1]) lines.add("periodic cell", fmt::format("{:.6g} m x {:.6g} m, tilt {:.6g} m", d.width(), d.height(), d.tilt));
  lines.add("unbalanced force ratio", fmt::format("{:.2e}", frame.equilibrium.unbalanced_ratio));
  lines.add("kinetic/elastic energy", fmt::format("{:.2e}", frame.equilibrium.kinetic_ratio));
  lines.add("the same of grains that carry nothing", fmt::format("{:.2e}", frame.equilibrium.loose_kinetic));
  if (frame.equilibrium.falling > 0) lines.add("share of grains that fall", fmt::format("{:.4f}", frame.equilibrium.falling));
  lines.add("mean |Ft|/Fn", fmt::format("{:.3f}", frame.equilibrium.mobilisation));
  for (const EnergyTerm& term : energy_terms)
    if (const double value = frame.energies.*term.value; value != 0) lines.add(term.phrase, fmt::format("{:.5g} J", value));
}

/// What the list of stages says of every kind of result.
Numbers entry(const ResultHead& head, const std::string& file) {
  return {{"name", head.name}, {"file", file}, {"input_hash", head.provenance.input_hash}, {"converged", head.converged}, {"outcome", head.outcome}};
}

/// As stored, or measured now.
Numbers last_texture(const StageResult& last) {
  if (!last.texture.empty()) return last.texture;
  if (last.frames.empty()) return Numbers::tree();
  return texture::numbers(texture::measure(last.frames.back().packing, workflow::texture_options(last.provenance)));
}

/// The text does not show the REV study, which takes longest.
texture::Texture texture_without_rev(const StageResult& last) {
  texture::Options options = workflow::texture_options(last.provenance);
  options.rev_sizes = 0;
  return texture::measure(last.frames.back().packing, options);
}

}  // namespace

Summary::Summary(const std::filesystem::path& result) {
  for (const auto& file : io::stage_files(result)) {
    auto any = io::read_result(file);
    if (const auto* field = std::get_if<FieldResult>(&any)) {
      fields_.push_back({file.filename().string(), *field, field->numbers});
    } else if (auto* film = std::get_if<FilmResult>(&any)) {
      films_.push_back(std::move(*film));
    } else {
      StageResult stage = std::get<StageResult>(std::move(any));
      const std::size_t states = stage.frames.size();
      if (states > 1) stage.frames.erase(stage.frames.begin(), stage.frames.end() - 1);
      stages_.push_back({file.filename().string(), std::move(stage), states});
    }
  }
}

Summary::Summary(const workflow::RunOutcome& outcome) {
  auto file = outcome.files.begin();
  for (const StageResult& s : outcome.stages) {
    StageResult stage{s, {}, s.history, {}, s.texture, {}};
    if (!s.frames.empty()) stage.frames.push_back(s.frames.back());
    stages_.push_back({(file++)->filename().string(), std::move(stage), s.frames.size()});
  }
  for (const FieldResult& field : outcome.fields) fields_.push_back({(file++)->filename().string(), field, field.numbers});
}

const ResultHead& Summary::last() const { return fields_.empty() ? stages_.back().result : fields_.back().head; }

Numbers Summary::numbers() const {
  if (!films_.empty()) return film_numbers(films_.back());
  const Numbers texture = stages_.empty() ? Numbers::tree() : last_texture(stages_.back().result);
  Numbers j = fields_.empty() ? texture : fields_.back().numbers;
  if (!fields_.empty() && !stages_.empty()) j["texture"] = texture;
  j["provenance"] = provenance(last().provenance);
  for (const Stage& stage : stages_) {
    Numbers one = entry(stage.result, stage.file);
    one["states"] = stage.states;
    if (!stage.result.frames.empty()) one["last_state"] = state(stage.result.frames.back());
    if (const auto curves = test_curves(stage.result))
      if (const auto critical = critical_state(*curves)) one["critical_state"] = j["critical_state"] = numbers_of(*curves, *critical);
    j["stages"].push_back(one);
  }
  for (const Field& field : fields_) {
    j["stages"].push_back(entry(field.head, field.file));
    j["stages"].back()["numbers"] = field.numbers;
  }
  return j;
}

std::string Summary::how_stages_ended() const {
  TextLines lines;
  lines.heading("Stages");
  for (const Stage& stage : stages_) {
    lines.add(stage.result.name, (stage.result.converged ? "" : "NOT IN EQUILIBRIUM: ") + stage.result.outcome);
    lines.add("", fmt::format("{} {} in {}", stage.states, stage.states == 1 ? "state" : "states", stage.file));
  }
  for (const Field& field : fields_) {
    lines.add(field.head.name, (field.head.converged ? "" : "NOT SOLVED: ") + field.head.outcome);
    lines.add("", field.file);
  }
  return made_by(last().provenance) + std::move(lines).text();
}

std::string Summary::text() const {
  const std::string more = "\n`arenite show RESULT --all` prints every number, `--json` the same for programs, `--numbers` what each number is.\n";
  if (!films_.empty()) return all();
  if (!fields_.empty()) return how_stages_ended() + field_headlines(fields_.back().numbers) + more;
  const StageResult& last = stages_.back().result;
  if (last.frames.empty()) return how_stages_ended();
  return how_stages_ended() + flow_text(last.texture) + headlines(last, texture_without_rev(last)) + critical_state_text(last) + more;
}

std::string Summary::all() const {
  if (!films_.empty()) return made_by(films_.back().provenance) + film_text(films_.back());
  if (!fields_.empty()) return how_stages_ended() + field_text(fields_.back().numbers);
  TextLines lines;
  const StageResult& last = stages_.back().result;
  if (!last.frames.empty()) {
    describe_state(lines, last.frames.back());
    lines.heading("Texture of the last state");
    lines.block(texture::to_text(texture_without_rev(last)));
  }
  return how_stages_ended() + flow_text(last.texture) + std::move(lines).text();
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
