#include "study/export_result.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "core/error.hpp"
#include "io/atomic_file.hpp"
#include "io/field_file.hpp"
#include "io/film_result_file.hpp"
#include "io/run_folder.hpp"
#include "io/sealed_file.hpp"
#include "io/stage_file.hpp"
#include "study/derived_fields.hpp"
#include "study/film_road.hpp"

namespace arenite::study {
namespace fs = std::filesystem;
namespace {

/// Collects files and writes each when it cannot grow any more. Unless it gets to its end, what it wrote goes again: half
/// of a loading looks like a whole one.
class ExportFolder {
 public:
  explicit ExportFolder(fs::path folder) : folder_(std::move(folder)) {
    std::error_code error;
    made_ = fs::create_directories(folder_, error);
    if (error) throw InputError(folder_.string(), 0, "cannot be made: " + error.message() + "; give another --out");
  }

  ExportFolder(const ExportFolder&) = delete;
  ExportFolder& operator=(const ExportFolder&) = delete;
  ~ExportFolder() {
    if (finished_) return;
    std::error_code ignored;
    for (const auto& path : written_) fs::remove(path, ignored);
    if (made_) fs::remove(folder_, ignored);
  }

  /// Files of one frame: those of the frame before that are not among them are complete.
  void add(std::vector<io::NamedBytes> files) {
    const auto named = [](auto& list, const std::string& name) {
      return std::find_if(list.begin(), list.end(), [&](const auto& f) { return f.name == name; });
    };
    for (auto& old : growing_) {
      const auto next = named(files, old.name);
      if (next == files.end()) {
        write(old);
      } else {
        old.bytes += next->bytes;
        next->bytes = std::move(old.bytes);
      }
    }
    growing_ = std::move(files);
  }

  /// Files that do not grow.
  void write_now(const std::vector<io::NamedBytes>& files) {
    for (const auto& file : files) write(file);
  }

  std::vector<fs::path> finish() {
    for (const auto& file : growing_) write(file);
    finished_ = true;
    return std::move(written_);
  }

 private:
  void write(const io::NamedBytes& file) {
    io::write_atomically(folder_ / file.name, file.bytes);
    written_.push_back(folder_ / file.name);
  }

  fs::path folder_;
  bool made_ = false, finished_ = false;
  std::vector<io::NamedBytes> growing_;
  std::vector<fs::path> written_;
};

}  // namespace

std::vector<fs::path> export_result(const fs::path& result, const io::ExportFormat& format, const fs::path& folder, bool last_only) {
  auto files = io::stage_files(result);
  if (last_only) files.erase(files.begin(), files.end() - 1);
  std::optional<ExportFolder> out;
  std::vector<double> times;
  bool has_field = false;
  for (const auto& file : files) {
    if (io::sealed_kind(file) == "field") {
      if (!format.of_field) {
        if (files.size() == 1)
          throw InputError(file.string(), 0, fmt::format("holds a field on nodes, and {} holds grains only; choose vtk or csv", format.name));
        continue;
      }
      const FieldResult field = io::read_field(file);
      if (!out) out.emplace(folder);
      has_field = true;
      out->write_now(format.of_field({&field, derived_fields(field)}));
      continue;
    }
    if (io::sealed_kind(file) == "film") {
      const FilmResult film = io::read_film_result(file);
      const Frame frame = std::move(measured_stage(film).frames.front());
      if (!out) out.emplace(folder);
      out->add(format.of_frame({static_cast<int>(times.size()), film.name, &frame, derived_fields(film), fields_of_contacts(film)}));
      times.push_back(frame.time);
      continue;
    }
    StageResult stage = io::read_stage(file);
    if (!out) out.emplace(folder);  // after the first readable file, so that a bad one leaves no empty folder
    if (last_only && stage.frames.size() > 1) stage.frames.erase(stage.frames.begin(), stage.frames.end() - 1);
    for (const Frame& frame : stage.frames) {
      if (!times.empty() && frame.time == times.back()) continue;
      out->add(format.of_frame({static_cast<int>(times.size()), stage.name, &frame, derived_fields(frame.packing), {}}));
      times.push_back(frame.time);
    }
  }
  if (times.empty() && !has_field) throw InputError(result.string(), 0, "holds no state to export; run the recipe to its end first");
  if (format.index && !times.empty()) out->add(format.index(times));
  return out->finish();
}

}  // namespace arenite::study
