#include "report/summary/summary.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <utility>
#include <variant>

#include "grains/fields/laboratory/test_numbers.hpp"
#include "grains/fields/stage_numbers.hpp"
#include "grains/texture/spheres/spheres.hpp"
#include "io/disk/store_file.hpp"
#include "io/results/results.hpp"
#include "report/figures/headlines.hpp"
#include "report/film_text.hpp"
#include "report/page_document.hpp"
#include "report/stage_doubts.hpp"
#include "report/summary/state.hpp"
#include "workflow/run.hpp"

namespace arenite::report {
namespace {

using statistics::described;

std::string made_by(const Provenance& p) {
  return fmt::format("{}{}Made by Arenite {}, {}{}seed {}; input {}\n", p.title, p.title.empty() ? "" : "\n", p.version,
                     p.kernel.empty() ? "" : "kernel ", p.kernel.empty() ? "" : p.kernel + ", ", p.seed,
                     p.input_hash.substr(0, 12));
}

Numbers provenance(const Provenance& p) {
  Numbers j{{"title", p.title}};
  j.update(provenance_of(p));
  return j;
}

Numbers converged(const ResultHead& head) {
  return described(head.converged, "", "Whether equilibrium, or a solution, was reached");
}

/// What the list of stages says of every kind of result.
Numbers entry(const ResultHead& head, const std::string& file) {
  return {{"name", head.name},
          {"file", file},
          {"input_hash", head.provenance.input_hash},
          {"converged", converged(head)},
          {"outcome", head.outcome}};
}

/// As stored, or measured now.
Numbers measured_now(const StageResult& stage) {
  return texture::numbers(texture::measure(stage.snapshots.back().packing, fields::texture_options(stage)));
}
Numbers measured_now(const SphereResult& stage) {
  return texture::measure_spheres(stage.snapshots.back().packing, texture::sphere_options(stage.asked));
}
template <int D> Numbers last_texture(const StageResultIn<D>& stage) {
  if (!stage.texture.empty()) return stage.texture;
  return stage.snapshots.empty() ? Numbers::tree() : measured_now(stage);
}

/// What a stage tells of a test of the laboratory; `before` is the packing that it began with, or null.
Numbers test_of(const SphereResult& stage, const Packing* /*before*/) { return fields::test_of(stage); }
Numbers test_of(const StageResult& stage, const Packing* before) {
  return fields::test_of(fields::Test{stage, before});
}

/// Loads that were not reached, and energies that do not balance, each a line; empty where all is well.
std::string lines_of(const std::vector<std::string>& doubts) {
  std::string text;
  for (const std::string& doubt : doubts) text += fmt::format("  {:<32} WARNING: {}\n", "", doubt);
  return text;
}

std::string headlines(const Numbers& numbers) { return rows_of(numbers, figures::first_rows(numbers)); }

void add_notes(const Numbers& node, std::string& lines) {
  if (!node.is_tree()) return;
  for (const auto& [name, item] : node.items()) {
    if (name != "notes" || !item.is_list()) add_notes(item, lines);
    else
      for (const Numbers& note : item)
        if (const std::string line = fmt::format("  note: {}\n", note.get<std::string>());
            lines.find(line) == std::string::npos)
          lines += line;
  }
}

/// Whose numbers follow, where a result has several stages.
std::string heading(const ResultHead& last, std::size_t stages) {
  return fmt::format("\nNumbers{}, each +- its standard error\n", stages > 1 ? " of " + last.name : "");
}

/// All that a result notes, wherever it stands among its numbers, each once: what rows are chosen from says it, too.
std::string note_lines(const Numbers& numbers) {
  std::string lines;
  add_notes(numbers, lines);
  return lines;
}

}  // namespace

Summary::Summary(const std::filesystem::path& result) {
  for (const auto& file : io::stage_files(result)) {
    auto any = io::read_result(file);
    if (auto* film = std::get_if<FilmResult>(&any)) films_.push_back(std::move(*film));
    else if (const auto* field = std::get_if<FieldResult>(&any)) add(file, *field, field->numbers);
    else if (const auto* voxels = std::get_if<VoxelResult>(&any)) add(file, *voxels, voxels->numbers);
    else if (const auto* spheres = std::get_if<SphereResult>(&any)) add(file, *spheres);
    else add(file, std::get<StageResult>(any));
  }
}

Summary::Summary(const workflow::RunOutcome& outcome) {
  auto file = outcome.files.begin();
  for (const StageResult& stage : outcome.stages) add(*file++, stage);
  for (const SphereResult& stage : outcome.spheres) add(*file++, stage);
  for (const FieldResult& field : outcome.fields) add(*file++, field, field.numbers);
  for (const VoxelResult& sample : outcome.voxels) add(*file++, sample, sample.numbers);
}

template <int D> void Summary::add(const std::filesystem::path& file, const StageResultIn<D>& stage) {
  Stage told{file.filename().string(),
             stage,
             stage.snapshots.size(),
             last_texture(stage),
             {},
             {},
             loads_in_words(stage.texture),
             doubts_about(stage.texture),
             {}};
  told.test = test_of(stage, before_ ? &*before_ : nullptr);
  for (const auto& [name, numbers] : told.test.items()) told.texture.erase(name);
  if (!stage.snapshots.empty()) {
    told.last_state = state_of(stage.snapshots.back());
    told.state_text = state_text(stage);
    keep_before(stage.snapshots.back().packing);
  }
  stages_.push_back(std::move(told));
}

void Summary::keep_before(const PackingIn<3>& /*packing*/) {}
void Summary::keep_before(const Packing& packing) { before_ = packing; }

void Summary::add(const std::filesystem::path& file, const ResultHead& head, const Numbers& numbers) {
  fields_.push_back({file.filename().string(), head, numbers});
}

const ResultHead& Summary::last() const { return fields_.empty() ? stages_.back().head : fields_.back().head; }

Numbers Summary::numbers() const {
  if (!films_.empty()) return film_numbers(films_.back());
  const Numbers texture = stages_.empty() ? Numbers::tree() : stages_.back().texture;
  Numbers j = fields_.empty() ? texture : fields_.back().numbers;
  if (!fields_.empty() && !stages_.empty()) j["texture"] = texture;
  j["provenance"] = provenance(last().provenance);
  // Numbers of a test stand together: those of the last stage that is one.
  const auto test =
      std::ranges::find_if(stages_.rbegin(), stages_.rend(), [](const Stage& s) { return !s.test.empty(); });
  if (test != stages_.rend()) {
    j.update(test->test);
    if (test != stages_.rbegin()) j["test_of_stage"] = test->head.name;
  }
  for (const Stage& stage : stages_) {
    Numbers one = entry(stage.head, stage.file);
    one["states"] = described(stage.states, "", "Stored states");
    if (stage.states > 0) one["last_state"] = stage.last_state;
    one.update(stage.test);
    j["stages"].push_back(one);
  }
  for (const Field& field : fields_) {
    j["stages"].push_back(entry(field.head, field.file));
    j["stages"].back()["numbers"] = field.numbers;
  }
  return j;
}

std::string Summary::how_stages_ended() const {
  std::string text = made_by(last().provenance) + "\nStages\n";
  for (const Stage& stage : stages_) {
    text += fmt::format("  {:<32} {}{}\n", stage.head.name,
                        stage.head.converged ? "" : "NOT IN EQUILIBRIUM: ", stage.head.outcome);
    for (const std::string& load : stage.loads) text += fmt::format("  {:<32} {}\n", "", load);
    text += lines_of(stage.doubts);
    text += fmt::format("  {:<32} {} {} in {}\n", "", stage.states, stage.states == 1 ? "state" : "states", stage.file);
  }
  for (const Field& field : fields_)
    text += fmt::format("  {:<32} {}{}\n  {:<32} {}\n", field.head.name,
                        field.head.converged ? "" : "NOT SOLVED: ", field.head.outcome, "", field.file);
  return text;
}

std::string Summary::text() const {
  if (!films_.empty()) return all();
  const bool has_state = fields_.empty() && stages_.back().states > 0;
  if (fields_.empty() && !has_state) return how_stages_ended();
  const Numbers told = numbers();
  return how_stages_ended() + (has_state ? stages_.back().state_text : "") +
         heading(last(), stages_.size() + fields_.size()) + headlines(told) + note_lines(told) +
         "\n`arenite show RESULT --all` prints every number, `--json` the same for programs.\n";
}

std::string Summary::all() const {
  if (!films_.empty()) return made_by(films_.back().provenance) + film_text(films_.back());
  std::string text = how_stages_ended();
  if (fields_.empty() && stages_.back().states > 0) text += "\nLast state\n" + to_text(stages_.back().last_state);
  return text + heading(last(), stages_.size() + fields_.size()) + to_text(numbers(), {"provenance"});
}

std::string field_summary(const ResultHead& result, const Numbers& numbers) {
  return fmt::format(
      "{}{}: {}\n\nNumbers of the sample, each +- its standard error\n{}\n`--json` prints every number; of a result "
      "that is kept (`--out`) `arenite show RESULT --all` does.\n",
      result.name, result.converged ? "" : " NOT SOLVED", result.outcome, headlines(numbers) + note_lines(numbers));
}

Numbers field_numbers(const ResultHead& result, Numbers numbers) {
  numbers["provenance"] = provenance(result.provenance);
  numbers["converged"] = converged(result);
  numbers["outcome"] = result.outcome;
  return numbers;
}

}  // namespace arenite::report
