#include "run_status.hpp"

#include <fcntl.h>
#include <fmt/chrono.h>
#include <fmt/core.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cmath>
#include <ctime>
#include <limits>
#include <map>
#include <stdexcept>

#include "io/disk/file.hpp"
#include "io/table/table.hpp"

namespace arenite::app {
namespace {

namespace fs = std::filesystem;

constexpr const char* file_name = "status.csv";
constexpr std::chrono::milliseconds pause(500);

double now() { return std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count(); }

std::string host_name() {
  char name[256] = {};
  ::gethostname(name, sizeof name - 1);
  return name;
}

fs::path lock_of(const fs::path& folder) { return folder / ".status.lock"; }
fs::path request_in(const fs::path& folder) { return folder / ".stop"; }

Numbers walls_of(const workflow::Progress& p) {
  Numbers walls = Numbers::tree();
  for (std::size_t side = 0; side < p.side.size(); ++side)
    if (const workflow::SideNow& now = p.side[side]; now.present)
      walls[any_side_names[side]] = Numbers::tree({{"position_m", now.position}, {"force_N", now.force}});
  return walls;
}

/// A row "name,value" for each of the numbers.
void add_rows(std::string& text, const std::string& name, const Numbers& n) {
  if (n.is_tree())
    for (const auto& [own, item] : n.items()) add_rows(text, name.empty() ? own : name + "." + own, item);
  else
    text += fmt::format("{},{}\n", name,
                        n.is_text()    ? io::quoted_cell(n.get<std::string>())
                        : n.is_known() ? to_json(n)
                                       : "unknown");
}

/// Throws std::out_of_range for the file of another program.
RunStatus status_from(const std::string& text) {
  Problems problems;
  std::map<std::string, std::string> cells;
  for (const auto& row : io::read_table(text, "", problems).rows)
    if (row.cells.size() == 2) cells.emplace(row.cells[0], row.cells[1]);
  const auto number = [&](const std::string& name) {
    return io::to_number(cells.at(name)).value_or(std::numeric_limits<double>::quiet_NaN());
  };
  const auto whole = [&](const std::string& name) { return io::to_integer(cells.at(name)).value_or(0); };
  RunStatus s;
  workflow::Progress& p = s.progress;
  p.stage = static_cast<std::size_t>(whole("stage"));
  p.stages = static_cast<std::size_t>(whole("stages"));
  p.name = cells.at("name");
  p.share = number("share");
  p.settles = !cells.contains("settles") || cells.at("settles") == "true";
  p.step = whole("step");
  p.unbalanced_ratio = number("unbalanced_ratio");
  if (cells.contains("residual")) p.residual = number("residual");
  p.field = cells.at("field") == "true";
  p.key = cells.at("key");
  p.increment = whole("increment");
  p.increments = whole("increments");
  p.time = number("time_s");
  for (std::size_t side = 0; side < p.side.size(); ++side) {
    const std::string wall = std::string("walls.") + any_side_names[side];
    if (cells.contains(wall + ".position_m"))
      p.side[side] = {true, number(wall + ".position_m"), number(wall + ".force_N")};
  }
  s.stopped = cells.at("stopped") == "true";
  s.process = whole("process");
  s.host = cells.at("host");
  s.began = number("began");
  s.stage_began = number("stage_began");
  s.heard = number("heard");
  s.seconds_left = number("seconds_left");
  return s;
}

std::string clock_text(double seconds) {
  return fmt::format("{:%Y-%m-%d %H:%M:%S}", fmt::localtime(static_cast<std::time_t>(seconds)));
}

std::string where(const workflow::Progress& p) {
  std::string text = fmt::format("stage {} of {}, {}", p.stage + 1, p.stages, p.name);
  if (p.increments > 1) text += fmt::format(", increment {} of {}", p.increment, p.increments);
  text += p.settles ? fmt::format(", {:.0f} %", 100 * p.share) : std::string(", does not settle");
  return p.step > 0 ? text + fmt::format(", {} {}", p.field ? "iteration" : "step", p.step) : text;
}

}  // namespace

std::optional<RunStatus> read_run_status(const fs::path& folder) {
  try {
    if (!fs::exists(folder / file_name)) return std::nullopt;
    return status_from(io::read_file(folder / file_name));
  } catch (const InputError&) {  // removed meanwhile
    return std::nullopt;
  } catch (const std::out_of_range&) {  // of another program
    return std::nullopt;
  }
}

Life life_of(const RunStatus& status, const fs::path& folder) {
  if (status.stopped) return Life::stopped;
  if (io::FileLock::is_held(lock_of(folder))) return Life::running;
  if (status.host == host_name()) return Life::died;
  constexpr double silence = 60;
  return now() - status.heard < silence ? Life::running : Life::unknown;
}

bool ask_to_stop(const fs::path& folder) {
  if (!io::FileLock::is_held(lock_of(folder))) return false;
  // A link of this name is not followed.
  const int request = ::open(request_in(folder).c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (request < 0) return errno == EEXIST;
  ::close(request);
  return true;
}

Numbers run_status_numbers(const RunStatus& s) {
  const workflow::Progress& p = s.progress;
  return Numbers::tree({{"stage", p.stage},
                        {"stages", p.stages},
                        {"name", p.name},
                        {"share", p.share},
                        {"settles", p.settles},
                        {"increment", p.increment},
                        {"increments", p.increments},
                        {"step", p.step},
                        {"time_s", p.time},
                        {"unbalanced_ratio", p.unbalanced_ratio},
                        {"residual", p.residual},
                        {"field", p.field},
                        {"walls", walls_of(p)},
                        {"seconds_left", s.seconds_left},
                        {"began", s.began},
                        {"stage_began", s.stage_began},
                        {"heard", s.heard},
                        {"stopped", s.stopped},
                        {"process", s.process},
                        {"host", s.host},
                        {"key", p.key}});
}

std::string run_status_text(const fs::path& folder) {
  const auto status = read_run_status(folder);
  if (!status) return "";
  const std::string process = fmt::format("process {} on {}", status->process, status->host),
                    at = where(status->progress);
  const std::string heard = fmt::format("last update {}", clock_text(status->heard));
  switch (life_of(*status, folder)) {
    case Life::running: {
      const std::string left = std::isnan(status->seconds_left)
                                   ? ""
                                   : fmt::format(", about {} left of the stage", duration_text(status->seconds_left));
      return fmt::format("Running: {}{}\n  since {}, this stage since {}; {}\n", at, left, clock_text(status->began),
                         clock_text(status->stage_began), process);
    }
    case Life::stopped:
      return fmt::format("Stopped: {}\n  {}; the same command continues from the checkpoint\n", at, heard);
    case Life::died:
      return fmt::format("Died: {}\n  {} is gone, {}; the same command continues from the last checkpoint\n", at,
                         process, heard);
    case Life::unknown: return fmt::format("Unknown whether it is still running: {}\n  {}, {}\n", at, process, heard);
  }
  return "";
}

StatusFile::StatusFile(fs::path folder, std::function<void()> stop)
    : folder_(std::move(folder)),
      stop_(std::move(stop)) {
  status_.process = ::getpid();
  status_.host = host_name();
  status_.began = status_.stage_began = now();
  status_.progress.name = "packing";
  status_.progress.stages = 1;
  writer_ = std::thread([this] { keep(); });
}

StatusFile::~StatusFile() {
  if (!writer_.joinable()) return;
  {
    const std::lock_guard lock(mutex_);
    over_ = status_.stopped = true;
  }
  wake_.notify_all();
  writer_.join();
  write();
}

void StatusFile::finish() {
  {
    const std::lock_guard lock(mutex_);
    over_ = true;
  }
  wake_.notify_all();
  writer_.join();
  std::error_code ignored;
  if (lock_) fs::remove(folder_ / file_name, ignored);  // without it, the file is another run's
  lock_.reset();
}

void StatusFile::show(const workflow::Progress& progress) {
  const std::lock_guard lock(mutex_);
  if (clock_.see(progress)) status_.stage_began = now();
  status_.progress = progress;
  changed_ = true;
}

bool StatusFile::has_lock() {
  std::error_code ignored;
  if (lock_ || !fs::is_directory(folder_, ignored)) return lock_.has_value();
  try {
    lock_ = io::FileLock::try_take(lock_of(folder_));
  } catch (const InputError&) {  // the folder is not for writing, of which the run itself will speak
  }
  if (lock_) fs::remove(request_in(folder_), ignored);  // meant for a run before this one
  return lock_.has_value();
}

void StatusFile::see_whether_to_stop() {
  std::error_code ignored;
  if (lock_ && fs::remove(request_in(folder_), ignored)) stop_();
}

void StatusFile::keep() {
  std::unique_lock lock(mutex_);
  while (!over_) {
    see_whether_to_stop();
    if (changed_) {
      changed_ = false;
      lock.unlock();
      const bool written = write();
      lock.lock();
      changed_ = changed_ || !written;
    }
    wake_.wait_for(lock, pause, [this] { return over_; });
  }
}

bool StatusFile::write() {
  RunStatus status;
  {
    const std::lock_guard lock(mutex_);
    status = status_;
    status.seconds_left =
        status.progress.settles ? clock_.seconds_left(status.progress.share) : std::numeric_limits<double>::quiet_NaN();
  }
  status.heard = now();
  if (!has_lock()) return false;
  try {
    std::string text = "name,value\n";
    add_rows(text, "", run_status_numbers(status));
    io::write_atomically(folder_ / file_name, text);
  } catch (const std::exception&) {  // a full disk ends the run by itself
    return false;
  }
  return true;
}

}  // namespace arenite::app
