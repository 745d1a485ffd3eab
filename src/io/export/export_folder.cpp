#include "io/export/export_folder.hpp"

#include <algorithm>
#include <system_error>
#include <utility>

#include "core/error.hpp"
#include "core/option.hpp"
#include "io/disk/file.hpp"

namespace arenite::io {
namespace fs = std::filesystem;

ExportFolder::ExportFolder(fs::path folder) : folder_(std::move(folder)) {
  std::error_code error;
  made_ = fs::create_directories(folder_, error);
  if (error)
    throw InputError(folder_.string(), 0, "cannot be created: " + error.message() + "; give another " + option("out"));
}

ExportFolder::~ExportFolder() {
  if (finished_) return;
  std::error_code ignored;
  for (const auto& path : written_) fs::remove(path, ignored);
  if (made_) fs::remove(folder_, ignored);
}

void ExportFolder::add(std::vector<NamedBytes> files) {
  for (auto& old : growing_) {
    const auto next = std::ranges::find(files, old.name, &NamedBytes::name);
    if (next == files.end()) {
      write(old);
    } else {
      old.bytes += next->bytes;
      next->bytes = std::move(old.bytes);
    }
  }
  growing_ = std::move(files);
}

void ExportFolder::write(const NamedBytes& file) {
  write_atomically(folder_ / file.name, file.bytes);
  written_.push_back(folder_ / file.name);
}

std::vector<fs::path> ExportFolder::finish() {
  for (const auto& file : growing_) write(file);
  finished_ = true;
  return std::move(written_);
}

}  // namespace arenite::io
