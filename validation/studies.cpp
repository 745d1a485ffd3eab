#include "validation/studies.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <sstream>

#include "io/disk/file.hpp"
#include "io/table/table.hpp"
#include "recipe/document.hpp"
#include "workflow/result_folder.hpp"

namespace arenite::validation {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);)
    if (!line.empty() && line.front() != '#') lines.push_back(line);
  return lines;
}

bool holds_already(const fs::path& file, const std::string& text) {
  std::ifstream in(file, std::ios::binary);
  return in && std::string(std::istreambuf_iterator<char>(in), {}) == text;
}

void put(const fs::path& file, const std::string& text) {
  if (!holds_already(file, text)) io::write_atomically(file, text);
}

/// The recipe that another is laid over, "../NAME/recipe.toml" from where that lies.
void unpack_base(const std::string& recipe, const fs::path& folder) {
  const recipe::Node root = recipe::read_document(recipe, "recipe.toml");
  const recipe::Entry* base = root.find("base");
  if (!base) return;
  const fs::path file = (folder / base->value.text).lexically_normal();
  const std::string text = embedded_text(file.parent_path().filename().string(), file.filename().string());
  if (text.empty()) return;
  workflow::make_folder(file.parent_path());
  put(file, text);
  unpack_base(text, file.parent_path());
}

std::vector<StudySource> read_embedded() {
  std::vector<StudySource> all;
  for (const EmbeddedFile& file : embedded_files()) {
    if (all.empty() || all.back().name != file.study) all.push_back({file.study, {}, {}});
    if (std::string(file.file) == "small.txt") all.back().small = lines_of(file.text);
    else if (std::string(file.file) == "cost.txt")
      all.back().seconds_a_run = io::to_number(lines_of(file.text).front()).value_or(all.back().seconds_a_run);
    else all.back().files.emplace_back(file.file, file.text);
  }
  return all;
}

}  // namespace

const std::vector<StudySource>& studies() {
  static const std::vector<StudySource> all = read_embedded();
  return all;
}

const StudySource* find_study(const std::string& name) {
  for (const StudySource& source : studies())
    if (source.name == name) return &source;
  return nullptr;
}

std::string embedded_text(const std::string& study, const std::string& file) {
  for (const EmbeddedFile& one : embedded_files())
    if (study == one.study && file == one.file) return one.text;
  return {};
}

bool StudySource::has_runs() const {
  return std::any_of(files.begin(), files.end(), [](const auto& file) { return file.first == "recipe.toml"; });
}

void unpack(const StudySource& source, const fs::path& folder) {
  workflow::make_folder(folder);
  for (const auto& [name, text] : source.files) {
    put(folder / name, text);
    if (name == "recipe.toml") unpack_base(text, folder);
  }
}

campaign::Study unpack_study(const StudySource& source, const fs::path& folder, bool small,
                             const std::vector<std::string>& overrides) {
  unpack(source, folder);
  std::vector<std::string> all = small ? source.small : std::vector<std::string>{};
  all.insert(all.end(), overrides.begin(), overrides.end());
  return campaign::read_study((folder / "recipe.toml").string(), all, folder);
}

}  // namespace arenite::validation
