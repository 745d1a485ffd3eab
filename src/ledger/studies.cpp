#include "ledger/studies.hpp"

#include <fstream>
#include <iterator>
#include <sstream>

#include "io/atomic_file.hpp"
#include "study/result_folder.hpp"

namespace arenite::ledger {
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

std::vector<StudySource> read_embedded() {
  std::vector<StudySource> all;
  for (const EmbeddedFile& file : embedded_files()) {
    if (all.empty() || all.back().name != file.study) all.push_back({file.study, {}, {}});
    if (std::string(file.file) == "small.txt") all.back().small = lines_of(file.text);
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

study::Study unpack_study(const StudySource& source, const fs::path& folder, bool small, const std::vector<std::string>& overrides) {
  study::make_folder(folder);
  for (const auto& [name, text] : source.files)
    if (!holds_already(folder / name, text)) io::write_atomically(folder / name, text);
  std::vector<std::string> all = small ? source.small : std::vector<std::string>{};
  all.insert(all.end(), overrides.begin(), overrides.end());
  return study::read_study((folder / "recipe.toml").string(), all, folder);
}

}  // namespace arenite::ledger
