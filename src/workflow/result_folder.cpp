#include "workflow/result_folder.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

#include "core/error.hpp"
#include "io/export_frame.hpp"

namespace arenite::study {

namespace fs = std::filesystem;

void make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw InputError(folder.string(), 0, fmt::format("this folder cannot be made ({}); choose another with --out", error.message()));
}

ResultFolder::ResultFolder(fs::path out, const std::vector<std::string>& names, const std::vector<std::string>& former) : out_(std::move(out)) {
  make_folder(out_);
  for (const auto& folder : {out_, out_ / "earlier"})
    for (std::size_t n = 0; n < former.size(); ++n)
      if (former[n] != names[n] && fs::exists(folder / former[n])) fs::rename(folder / former[n], folder / names[n]);
  const std::set<std::string> wanted(names.begin(), names.end());
  std::vector<fs::path> others;
  for (const auto& entry : fs::directory_iterator(out_))
    if (entry.path().extension() == ".h5" && !wanted.contains(entry.path().filename().string())) others.push_back(entry.path());
  std::sort(others.begin(), others.end());
  for (const auto& path : others) put_aside(path);
  for (const auto& name : names)
    if (fs::exists(out_ / "earlier" / name)) fs::rename(out_ / "earlier" / name, out_ / name);
}

void ResultFolder::put_aside(const fs::path& path) {
  make_folder(out_ / "earlier");
  fs::rename(path, out_ / "earlier" / path.filename());
  put_aside_.push_back(path.filename().string());
}

std::string ResultFolder::what_was_put_aside() const {
  if (put_aside_.empty()) return {};
  std::string stale;
  std::vector<std::string> exports{"figures"};
  for (const auto& format : io::export_formats()) exports.emplace_back(format.name);
  for (const auto& name : exports)
    if (std::error_code error; fs::is_directory(out_ / name, error)) stale += (stale.empty() ? "" : ", ") + (out_ / name).string();
  return fmt::format("{} of other settings moved to {} and kept there: {}{}", put_aside_.size() == 1 ? "a result" : "results",
                     (out_ / "earlier").string(), fmt::join(put_aside_, ", "),
                     stale.empty() ? "" : fmt::format("; still of those settings, so write anew: {}", stale));
}

}  // namespace arenite::study
