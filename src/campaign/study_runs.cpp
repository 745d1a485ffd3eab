#include <fmt/format.h>

#include <charconv>

#include "core/hash.hpp"
#include "core/version.hpp"
#include "io/atomic_file.hpp"
#include "io/read_file.hpp"
#include "io/table.hpp"
#include "campaign/study.hpp"

// runs.tsv: lines of cells with tabs between them. First what it was made from, then one line a run: name, swept values, and
// for each stage its hash, "field" or "stage", and its name.
namespace arenite::study {
namespace {

constexpr std::string_view first_line = "arenite runs 1";

std::vector<std::string_view> cells_of(std::string_view line) {
  std::vector<std::string_view> cells;
  for (std::size_t begin = 0; begin <= line.size();) {
    const std::size_t end = std::min(line.find('\t', begin), line.size());
    cells.push_back(line.substr(begin, end - begin));
    begin = end + 1;
  }
  return cells;
}

/// What the runs follow from besides the inputs.
std::string made_with(const Study& study) {
  HashBuilder hash;
  hash.add("version", version).add("keys", key_versions());
  for (const auto& assignment : study.overrides) hash.add("set", assignment);
  return hash.hex();
}

std::string line_of(const StudyRun& run) {
  std::string line = fmt::format("run\t{}\t{}", run.name, run.values.size());
  for (const auto& [key, value] : run.values) line += fmt::format("\t{}\t{}", key, value);
  for (const PlannedStage& stage : run.stages) line += fmt::format("\t{}\t{}\t{}", stage.hash, stage.field ? "field" : "stage", stage.name);
  return line + "\n";
}

StudyRun run_in(const std::vector<std::string_view>& cells) {
  StudyRun run;
  run.name = cells[1];
  std::size_t values = 0;
  std::from_chars(cells[2].data(), cells[2].data() + cells[2].size(), values);
  for (std::size_t v = 0; v < values; ++v) run.values.emplace_back(cells[3 + 2 * v], cells[4 + 2 * v]);
  for (std::size_t at = 3 + 2 * values; at + 2 < cells.size(); at += 3) {
    run.stages.push_back(planned_stage(static_cast<int>(run.stages.size()) + 1, std::string(cells[at + 2]), std::string(cells[at]),
                                       cells[at + 1] == "field"));
  }
  return run;
}

bool is_as_it_was(const std::string& file, std::string_view hash) {
  try {
    return content_hash(io::read_file(file)) == hash;
  } catch (const InputError&) {
    return false;
  }
}

}  // namespace

void write_runs(const std::filesystem::path& file, const Study& study) {
  std::string text = fmt::format("{}\nmade\t{}\n", first_line, made_with(study));
  for (const auto& [path, hash] : study.inputs) text += fmt::format("input\t{}\t{}\n", path, hash);
  text += fmt::format("title\t{}\n", toml_literal([&] { Node node; node.kind = Node::Kind::text; node.text = study.title; return node; }()));
  for (const auto& key : study.keys) text += fmt::format("key\t{}\n", key);
  for (const auto& run : study.runs) text += line_of(run);
  io::write_atomically(file, text + "end\n");
}

bool read_runs(const std::filesystem::path& file, Study& study) {
  std::error_code error;
  if (!std::filesystem::exists(file, error)) return false;
  const std::string text = io::read_file(file);
  Study read;
  read.file = study.file;
  read.overrides = study.overrides;
  io::Lines lines(text);
  std::string_view line;
  if (!text.ends_with("\nend\n") || !lines.next(line) || line != first_line) return false;
  bool has_recipe = false;
  while (lines.next(line)) {
    const auto cells = cells_of(line);
    if (cells[0] == "made" && cells[1] != made_with(study)) return false;
    if (cells[0] == "input") {
      if (!is_as_it_was(std::string(cells[1]), cells[2])) return false;
      has_recipe = has_recipe || cells[1] == study.file;
      read.inputs.emplace_back(cells[1], cells[2]);
    }
    if (cells[0] == "title") read.title = parse_value(std::string(cells[1])).text;
    if (cells[0] == "key") read.keys.emplace_back(cells[1]);
    if (cells[0] == "run") read.runs.push_back(run_in(cells));
  }
  if (!has_recipe) return false;
  study = std::move(read);
  return true;
}

}  // namespace arenite::study
