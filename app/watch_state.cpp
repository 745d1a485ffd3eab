#include "watch_state.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstdlib>
#include <utility>
#include <variant>

#include "core/error.hpp"
#include "io/disk/file.hpp"
#include "io/results/results.hpp"
#include "recipe/recipe.hpp"
#include "report/figures/live_figures.hpp"
#include "report/page.hpp"
#include "report/study/study_page.hpp"
#include "workflow/state_of_now.hpp"

namespace arenite::app {
namespace {

namespace fs = std::filesystem;

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

std::string watch_page() { return report::html_of({{"title", "Arenite"}, {"live", true}}); }

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
      stages_[name] = std::visit([](const auto& result) { return Stage{result.name, result.outcome}; }, any);
      const auto* stage = std::get_if<StageResult>(&any);
      if (stage && !stage->snapshots.empty()) before_ = stage->snapshots.back().packing;
    } catch (const InputError&) {  // damaged, or moved aside meanwhile
    }
  }
}

void WatchState::read_now() {
  constexpr std::uintmax_t cheap = std::uintmax_t{64} << 20;
  std::error_code error;
  const fs::path file = folder_ / workflow::state_of_now;
  const auto written = fs::last_write_time(file, error);
  if (error || written == now_written_ || fs::file_size(file, error) > cheap) return;
  try {
    const auto now = io::read_result(file);
    if (const auto* spheres = std::get_if<SphereResult>(&now)) figures_ = report::figures::live_figures(*spheres);
    else figures_ = report::figures::live_figures(std::get<StageResult>(now), before_ ? &*before_ : nullptr);
    now_written_ = written;
    ++at_;
  } catch (const InputError&) {  // the run has just replaced it, or its stage has ended
  }
}

Numbers WatchState::numbers() {
  const auto status = read_run_status(folder_);
  read_stages();
  read_now();
  Numbers n = Numbers::tree({{"title", title_of(folder_)}, {"folder", folder_.string()}});
  n["life"] = status ? word_of(life_of(*status, folder_)) : stages_.empty() ? "waiting" : "ended";
  if (status) n["status"] = run_status_numbers(*status);
  n["stages"] = Numbers::list();
  for (const auto& [file, stage] : stages_)
    n["stages"].push_back(Numbers::tree({{"name", stage.name}, {"outcome", stage.outcome}}));
  n["figures"] = figures_;
  n["at"] = at_;
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
