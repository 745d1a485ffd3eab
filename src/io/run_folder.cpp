#include "io/run_folder.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.hpp"

namespace arenite::io {
namespace fs = std::filesystem;

std::string stage_file_name(int place, std::string_view stage, std::string_view hash) {
  return full_stage_file_name(place, stage, hash.substr(0, 12));
}

std::string full_stage_file_name(int place, std::string_view stage, std::string_view hash) {
  std::string name(stage);
  for (char& c : name) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-' || c == '.';
    if (!plain) c = '-';
  }
  return fmt::format("{:02}-{}-{}.h5", place, name, hash);
}

std::vector<fs::path> stage_files(const fs::path& result) {
  std::error_code error;
  if (!fs::is_directory(result, error)) return {result};
  std::vector<fs::path> files;
  for (fs::directory_iterator entry(result, error), end; !error && entry != end; entry.increment(error))
    if (entry->path().extension() == ".h5" && entry->path().filename().string().front() != '.') files.push_back(entry->path());
  if (error) throw InputError(result.string(), 0, "cannot be listed: " + error.message() + "; check its permissions");
  if (files.empty()) throw InputError(result.string(), 0, "holds no stage file (.h5); give the folder that \"arenite run\" wrote");
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace arenite::io
