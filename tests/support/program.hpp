#pragma once
#include <sys/wait.h>

#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>

#include "support/temporary_folder.hpp"

namespace arenite::test {

/// What a command left behind.
struct Outcome {
  int status = -1;  ///< exit status; 128 + signal if it was killed
  std::string out, err;
};

inline std::string slurp(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

/// Runs a shell line, e.g. shell(program + " check x.toml").
inline Outcome shell(const std::string& line) {
  const TemporaryFolder folder;
  const auto out = folder / "out", err = folder / "err";
  const int raw = std::system(("( " + line + " ) >" + out.string() + " 2>" + err.string() + " </dev/null").c_str());
  const int status = WIFEXITED(raw) ? WEXITSTATUS(raw) : 128 + WTERMSIG(raw);
  return {status, slurp(out), slurp(err)};
}

/// Runs the program under test with these arguments.
inline Outcome arenite(const std::string& arguments) {
  return shell(std::string(ARENITE_BINARY " ").append(arguments));
}

inline bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// The stored stages of a result by their names, as bytes.
inline std::map<std::string, std::string> stage_files(const std::filesystem::path& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().extension() == ".h5") files[entry.path().filename().string()] = slurp(entry.path());
  return files;
}

/// All files of a study's runs by their paths in its folder, as bytes.
inline std::map<std::string, std::string> files_of_runs(const std::filesystem::path& study) {
  std::map<std::string, std::string> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(study / "runs"))
    if (entry.is_regular_file()) files[std::filesystem::relative(entry.path(), study).string()] = slurp(entry.path());
  return files;
}

/// How often runs of a study were begun, by its journal.
inline std::size_t runs_begun(const std::filesystem::path& study) {
  std::size_t n = 0;
  for (const auto& entry : std::filesystem::directory_iterator(study / "journal")) {
    std::ifstream journal(entry.path());
    for (std::string line; std::getline(journal, line);) n += contains(line, "running");
  }
  return n;
}

}  // namespace arenite::test
