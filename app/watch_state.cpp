#include "watch_state.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <utility>
#include <variant>

#include "core/error.hpp"
#include "io/disk/file.hpp"
#include "io/results/results.hpp"
#include "recipe/recipe.hpp"
#include "report/page.hpp"

namespace arenite::app {
namespace {

namespace fs = std::filesystem;

constexpr std::array<const char*, 8> curve_names{"left_position", "right_position", "bottom_position", "top_position",
                                                 "left_force",    "right_force",    "bottom_force",    "top_force"};
constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

const char* word_of(Life life) {
  switch (life) {
    case Life::running: return "running";
    case Life::stopped: return "stopped";
    case Life::died: return "died";
    case Life::unknown: return "unknown";
  }
  return "";
}

std::string title_of(const fs::path& folder) {
  try {
    return recipe::title_in(io::read_file(folder / "recipe.toml"));
  } catch (const InputError&) { return ""; }
}

/// A folder of its own that only this user can read, and that goes with this.
class PrivateFolder {
 public:
  PrivateFolder() {
    std::string pattern = (fs::temp_directory_path() / "arenite-watch-XXXXXX").string();
    if (!::mkdtemp(pattern.data())) throw InputError(pattern, 0, "cannot be created; set TMPDIR to a writable folder");
    path_ = pattern;
  }
  ~PrivateFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  PrivateFolder(const PrivateFolder&) = delete;
  PrivateFolder& operator=(const PrivateFolder&) = delete;
  fs::path operator/(const char* name) const { return path_ / name; }

 private:
  fs::path path_;
};

std::string page_of(const std::vector<fs::path>& files, const std::string& title) {
  const PrivateFolder folder;
  report::write_page(folder / "page.html", files, title);
  return io::read_file(folder / "page.html");
}

}  // namespace

std::vector<WatchState::Row> WatchState::rows_of(const History& history) {
  const auto column = [&](std::string_view name) -> const std::vector<double>* {
    const auto at =
        std::find_if(history.columns.begin(), history.columns.end(), [&](const auto& c) { return c.name == name; });
    return at == history.columns.end() ? nullptr : &at->values;
  };
  const auto* time = column("time");
  if (!time) return {};
  constexpr std::size_t most = 200;  // more than the page's charts have room for
  const std::size_t stride = time->size() / most + 1;
  std::vector<Row> rows;
  for (std::size_t k = 0; k < time->size(); k += stride) {
    Row row{(*time)[k], {}};
    for (const char* name : curve_names) {
      const auto* values = column(name);
      row.values.push_back(values && k < values->size() ? (*values)[k] : unknown);
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

std::vector<fs::path> WatchState::files() const {
  std::error_code error;
  std::vector<fs::path> found;
  for (fs::directory_iterator entry(folder_, error), end; !error && entry != end; entry.increment(error))
    if (entry->path().extension() == ".h5" && !entry->path().filename().string().starts_with('.'))
      found.push_back(entry->path());
  std::sort(found.begin(), found.end());
  return found;
}

void WatchState::read_stages() {
  const auto there = files();
  std::erase_if(stages_, [&](const auto& known) {
    return std::find(there.begin(), there.end(), folder_ / known.first) == there.end();
  });
  for (const fs::path& file : there) {
    const std::string name = file.filename().string();
    if (stages_.contains(name)) continue;
    try {
      const auto any = io::read_result(file);
      stages_[name] = {name, "", {}};
      if (const auto* stage = std::get_if<StageResult>(&any))
        stages_[name] = {stage->name, stage->outcome, rows_of(stage->history)};
      if (const auto* field = std::get_if<FieldResult>(&any)) stages_[name] = {field->name, field->outcome, {}};
    } catch (const InputError&) {  // damaged, or moved aside meanwhile
    }
  }
}

void WatchState::read_checkpoint(const RunStatus& status) {
  constexpr std::uintmax_t cheap = std::uintmax_t{64} << 20;
  std::error_code error;
  const fs::path file = folder_ / "run.checkpoint";
  const auto written = fs::last_write_time(file, error);
  if (error || written == checkpoint_time_ || fs::file_size(file, error) > cheap) return;
  checkpoint_time_ = written;
  try {
    const auto checkpoint = io::read_checkpoint(file, status.progress.key);
    if (!checkpoint) return;
    checkpoint_ = rows_of(checkpoint->partial.history);
    if (!checkpoint_.empty()) std::erase_if(now_, [&](const Row& row) { return row.time <= checkpoint_.back().time; });
  } catch (const InputError&) {  // the run has just replaced it
  }
}

void WatchState::add_now(const RunStatus& status) {
  const workflow::Progress& p = status.progress;
  if (p.field || !(p.time > 0)) return;
  if ((!now_.empty() && p.time <= now_.back().time) || (!checkpoint_.empty() && p.time <= checkpoint_.back().time))
    return;
  Row row{p.time, std::vector<double>(curve_names.size(), unknown)};
  for (std::size_t side = 0; side < 4; ++side) {
    if (!p.wall[side].present) continue;
    row.values[side] = p.wall[side].position;
    row.values[side + 4] = p.wall[side].force;
  }
  now_.push_back(std::move(row));
  if (now_.size() > 2000) now_.erase(now_.begin(), now_.begin() + 1000);
}

Numbers WatchState::curves() const {
  std::vector<double> time;
  std::vector<std::vector<double>> values(curve_names.size());
  const auto add = [&](const std::vector<Row>& rows) {
    for (const Row& row : rows) {
      if (!time.empty() && row.time <= time.back()) continue;
      time.push_back(row.time);
      for (std::size_t c = 0; c < values.size(); ++c) values[c].push_back(row.values[c]);
    }
  };
  for (const auto& [file, stage] : stages_) add(stage.rows);
  add(checkpoint_);
  add(now_);
  Numbers curves = Numbers::tree({{"time", time}});
  for (std::size_t c = 0; c < values.size(); ++c)
    if (std::any_of(values[c].begin(), values[c].end(), [](double v) { return std::isfinite(v); }))
      curves[curve_names[c]] = values[c];
  return curves;
}

Numbers WatchState::numbers() {
  const auto status = read_run_status(folder_);
  read_stages();
  if (status && status->progress.key != key_) {
    key_ = status->progress.key;
    checkpoint_.clear();
    now_.clear();
    checkpoint_time_ = {};
  }
  if (status) {
    read_checkpoint(*status);
    add_now(*status);
  }
  Numbers n = Numbers::tree({{"title", title_of(folder_)}, {"folder", folder_.string()}});
  n["life"] = status ? word_of(life_of(*status, folder_)) : stages_.empty() ? "waiting" : "ended";
  if (status) n["status"] = run_status_numbers(*status);
  n["stages"] = Numbers::list();
  for (const auto& [file, stage] : stages_)
    n["stages"].push_back(Numbers::tree({{"name", stage.name}, {"outcome", stage.outcome}}));
  n["curves"] = curves();
  return n;
}

std::string WatchState::page() {
  constexpr std::chrono::seconds pause(5);
  const auto there = files();
  const auto now = std::chrono::steady_clock::now();
  if (there.empty() || there == page_files_ || (!page_.empty() && now - page_made_ < pause)) return page_;
  page_ = page_of(there, title_of(folder_));
  page_files_ = there;
  page_made_ = std::chrono::steady_clock::now();
  return page_;
}

bool WatchState::stop() const { return ask_to_stop(folder_); }

}  // namespace arenite::app
