#include "study/result_folder.hpp"

#include <fmt/format.h>

#include <set>

#include "core/error.hpp"

namespace arenite::study {

namespace fs = std::filesystem;

void make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw InputError(folder.string(), 0, fmt::format("this folder cannot be made ({}); choose another with --out", error.message()));
}

ResultFolder::ResultFolder(fs::path out, const std::vector<std::string>& names) : out_(std::move(out)) {
  make_folder(out_);
  const std::set<std::string> wanted(names.begin(), names.end());
  std::vector<fs::path> others;
  for (const auto& entry : fs::directory_iterator(out_))
    if (entry.path().extension() == ".h5" && !wanted.contains(entry.path().filename().string())) others.push_back(entry.path());
  for (const auto& path : others) put_aside(path);
  for (const auto& name : names)
    if (fs::exists(out_ / "earlier" / name)) fs::rename(out_ / "earlier" / name, out_ / name);
}

void ResultFolder::put_aside(const fs::path& path) const {
  make_folder(out_ / "earlier");
  fs::rename(path, out_ / "earlier" / path.filename());
}

}  // namespace arenite::study
