#include "workflow/result_folder.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <set>
#include <string>
#include <utility>

#include "core/error.hpp"
#include "core/option.hpp"
#include "core/problems.hpp"
#include "core/text.hpp"
#include "grains/fields/stage_numbers.hpp"
#include "io/disk/byte_source.hpp"
#include "io/disk/store_file.hpp"
#include "io/export/export.hpp"
#include "io/results/results.hpp"
#include "recipe/recipe.hpp"
#include "workflow/apply_load.hpp"
#include "workflow/cemented_sample.hpp"
#include "workflow/run.hpp"

namespace arenite::workflow {

namespace fs = std::filesystem;

void make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error)
    refuse(folder.string(), "this folder cannot be made ({}); choose another with {}", error.message(), option("out"));
}

namespace {

/// A film or any other HDF5 file that lies there is not ours to move.
bool is_foreign(const fs::path& file) {
  std::error_code error;
  if (!fs::is_regular_file(file, error)) return true;
  return io::is_hdf5(io::open_bytes(file)->text(0, 8));
}

}  // namespace

std::vector<fs::path> other_results(const fs::path& folder, const std::vector<std::string>& names) {
  std::vector<fs::path> others;
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.path().extension() == ".h5" && std::ranges::count(names, entry.path().filename().string()) == 0 &&
        !is_foreign(entry.path()))
      others.push_back(entry.path());
  std::ranges::sort(others);
  return others;
}

namespace {

io::FileLock lock_in(const fs::path& folder) {
  make_folder(folder);
  if (auto lock = io::FileLock::try_take(folder / ".lock")) return std::move(*lock);
  refuse(folder.string(),
         "another run writes into this folder; wait for its end, stop it, or choose another folder with {}",
         option("out"));
}

}  // namespace

ResultFolder::ResultFolder(fs::path out, const std::vector<std::string>& names, std::string_view only)
    : out_(std::move(out)),
      was_there_(fs::exists(out_)),
      lock_(lock_in(out_)) {
  for (const auto& path : other_results(out_, names))
    if (only.empty() || io::stored_kind(path) == only) put_aside(path);
  for (const auto& name : names)
    if (fs::exists(out_ / "earlier" / name)) fs::rename(out_ / "earlier" / name, out_ / name);
}

ResultFolder::~ResultFolder() {
  lock_.reset();
  std::error_code ignored;
  if (!was_there_) fs::remove(out_, ignored);  // only if nothing is in it
}

void ResultFolder::put_aside(const fs::path& path) {
  make_folder(out_ / "earlier");
  fs::rename(path, out_ / "earlier" / path.filename());
  put_aside_.push_back(path.filename().string());
}

std::string ResultFolder::what_was_put_aside() const {
  if (put_aside_.empty()) return {};
  std::string stale;
  auto exports = io::words_of(io::exports::all, &io::ExportFormat::name);
  exports.emplace_back("figures");
  for (const auto& name : exports)
    if (std::error_code error; fs::is_directory(out_ / name, error))
      stale += (stale.empty() ? "" : ", ") + (out_ / name).string();
  return fmt::format("{} of other settings moved to {} and kept there: {}{}",
                     put_aside_.size() == 1 ? "a result" : "results", (out_ / "earlier").string(), list_of(put_aside_),
                     stale.empty() ? "" : fmt::format("; still from those settings, so write again: {}", stale));
}

namespace {

/// The files of a result that are of this kind, "result" or "field".
std::vector<fs::path> files_of(const fs::path& result, std::string_view kind) {
  auto files = io::stage_files(result);
  std::erase_if(files, [&](const fs::path& file) { return io::stored_kind(file) != kind; });
  return files;
}

/// The stage of loading of this name, or, where it is empty, the last; nothing if there is none.
std::optional<StageResult> stage_named(const fs::path& result, const std::string& name) {
  const auto files = files_of(result, "result");
  if (name.empty()) return files.empty() ? std::nullopt : std::optional(io::read_stage(files.back()));
  for (const auto& file : files)
    if (auto read = io::read_stage(file); read.name == name) return read;
  return std::nullopt;
}

const recipe::Load& load_of(const recipe::Recipe& recipe, const fs::path& run, const std::string& name) {
  const auto at = std::find_if(recipe.loads.begin(), recipe.loads.end(),
                               [&](const recipe::Load& load) { return name == "*" || load.name == name; });
  if (at == recipe.loads.end())
    refuse(run.string(), "there is no load \"{}\" of this run; name one of its recipe", name);
  return *at;
}

}  // namespace

std::optional<Packing> last_state(const fs::path& result, const std::string& stage) {
  auto read = stage_named(result, stage);
  return read && !read->snapshots.empty() ? std::optional(std::move(read->snapshots.back().packing)) : std::nullopt;
}

std::optional<FieldResult> load_named(const fs::path& result, const std::string& name) {
  for (const auto& file : files_of(result, "field"))
    if (auto field = io::read_field(file); field.name == name) return field;
  return std::nullopt;
}

void refuse_stage(const fs::path& result, const std::string& name) {
  std::set<std::string> names;
  for (const auto& file : files_of(result, "result"))
    if (const auto stage = io::read_stage(file); !stage.snapshots.empty()) names.insert(stage.name);
  if (names.empty()) refuse(result.string(), "holds no simulated states; give the folder of an `arenite run`");
  refuse(result.string(), "has no stage \"{}\"; those there are: {}", name, list_of(names));
}

FinalState final_state(const fs::path& run, const StateOptions& wanted) {
  auto result = stage_named(run, wanted.stage);
  if (!result && wanted.stage.empty())
    refuse(run.string(), "there are no stage files of this run; remove its folder and run the study again");
  if (!result)
    refuse(run.string(), "there is no stage \"{}\" of this run; name one of its recipe, or run the study again",
           wanted.stage);
  if (result->snapshots.empty())
    refuse(run.string(), "stage {} holds no state; remove its file and run the study again", result->name);
  texture::Options options = fields::texture_options(*result);
  if (!wanted.rev) options.rev.sizes = 0;
  options.sectors = wanted.sectors;
  options.border = wanted.border.value_or(options.border);
  Packing& packing = result->snapshots.back().packing;
  texture::Texture texture = texture::measure(packing, options);
  return {std::move(packing), std::move(texture)};
}

Numbers numbers(FinalState state, bool curves) {
  state.texture.per_grain = {};
  return texture::numbers(state.texture, curves);
}

FieldResult field_of(const fs::path& run, const std::string& load) {
  const recipe::Recipe recipe = recipe::read_recipe((run / "recipe.toml").string());
  const recipe::Load* wanted = load.empty() ? nullptr : &load_of(recipe, run, load);
  if (auto field = load_named(run, wanted ? wanted->name : "cement")) return std::move(*field);
  FieldResult sample = make_cemented_sample(recipe, final_state(run).packing);
  if (!wanted) return sample;
  return apply_load(*wanted, sample, [](const auto&) { return true; }).value();
}

}  // namespace arenite::workflow
