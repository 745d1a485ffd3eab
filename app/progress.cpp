#include "progress.hpp"
#include "print.hpp"

#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <limits>

namespace arenite::app {
namespace {

/// Set by a signal or by the thread that answers a watch, read by the one that computes.
std::atomic<bool> requested{false};
static_assert(std::atomic<bool>::is_always_lock_free, "or a signal could not set it");

void stop_by_signal(int) { requested = true; }

/// As duration_text, without tenths.
std::string whole_seconds(double seconds) {
  return seconds < 10 ? fmt::format("{:.0f} s", seconds) : duration_text(seconds);
}

std::string bar(double share) {
  constexpr int width = 24;
  const int full = std::clamp(static_cast<int>(share * width), 0, width);
  return "[" + std::string(full, '#') + std::string(width - full, '.') + "]";
}

}  // namespace

void watch_for_signals() {
  std::signal(SIGTERM, stop_by_signal);
  std::signal(SIGINT, stop_by_signal);
}

void request_stop() { requested = true; }

bool stop_requested() { return requested; }

std::string duration_text(double seconds) {
  if (seconds < 10) return fmt::format("{:.1f} s", seconds);
  if (seconds < 90) return fmt::format("{:.0f} s", seconds);
  if (seconds < 5400) return fmt::format("{:.0f} min", seconds / 60);
  return fmt::format("{:.1f} h", seconds / 3600);
}

StatusLine::StatusLine(bool quiet)
    : quiet_(quiet),
      terminal_(isatty(fileno(stderr)) != 0),
      last_shown_(Clock::now() - std::chrono::hours(1)) {}

void StatusLine::end() {
  if (open_) std::fputc('\n', stderr);
  open_ = false;
}

bool StatusLine::is_time(std::chrono::milliseconds pause) const {
  return Clock::now() - last_shown_ >= (terminal_ ? pause : std::chrono::milliseconds(10'000));
}

void StatusLine::write(const std::string& line) {
  last_shown_ = Clock::now();
  if (terminal_) std::fputs("\r\033[K", stderr);
  put(stderr, terminal_ ? line : line + "\n");
  open_ = terminal_;
  std::fflush(stderr);
}

void StatusLine::notice(const std::string& sentence) {
  end();
  print(stderr, "{}\n", sentence);
}

bool StageClock::see(const workflow::Progress& progress) {
  if (progress.stage == stage_) return false;
  stage_ = progress.stage;
  share_at_start_ = progress.share;
  began_ = std::chrono::steady_clock::now();
  return true;
}

double StageClock::seconds() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - began_).count();
}

double StageClock::seconds_left(double share) const {
  const double gained = share - share_at_start_, elapsed = seconds();
  return gained > 0.02 && elapsed > 1 ? elapsed * (1 - share) / gained : std::numeric_limits<double>::quiet_NaN();
}

std::string ProgressLine::text(const workflow::Progress& progress) const {
  std::string line = progress.stages > 1 ? fmt::format("{}/{} ", progress.stage, progress.stages - 1) : "";
  line += fmt::format("{:<12}", progress.name);
  if (progress.reused) return line + " taken from an earlier run";
  line += progress.settles ? fmt::format(" {} {:3.0f} %", bar(progress.share), 100 * progress.share)
                           : std::string(" does not settle");
  if (progress.step > 0)
    line += fmt::format("  {} {}  {} {:.1e}", progress.field ? "iteration" : "step", progress.step,
                        progress.field ? "residual" : "unbalanced",
                        progress.field ? progress.residual : progress.unbalanced_ratio);
  if (progress.share >= 1) return line + fmt::format("  {} total", whole_seconds(clock_.seconds()));
  const double left = clock_.seconds_left(progress.share);
  return std::isnan(left) || !progress.settles ? line : line + fmt::format("  about {} left", whole_seconds(left));
}

void ProgressLine::show(const workflow::Progress& progress) {
  if (quiet_) return;
  const bool begins = clock_.see(progress);
  if (begins) end();
  if (begins || progress.share >= 1 || is_time(std::chrono::milliseconds(100))) write(text(progress));
}

void StudyLine::show(const campaign::StudyProgress& p) {
  if (quiet_) return;
  std::string line = fmt::format("{} of {} done", p.done, p.runs);
  if (p.not_done > 0) line += fmt::format(", {} failed", p.not_done);
  if (p.running > 0) line += fmt::format(", {} running", p.running);
  const bool ended = p.done + p.not_done == p.runs;
  if (!ended && !std::isnan(p.seconds_left)) line += fmt::format(", about {} left", duration_text(p.seconds_left));
  if (line == last_ || (!ended && !is_time(std::chrono::milliseconds(200)))) return;
  last_ = line;
  write(line);
}

std::function<bool(double share)> frames_progress(ProgressLine& line) {
  return [&line](double share) {
    workflow::Progress progress;
    progress.stages = 1;
    progress.name = "frames";
    progress.share = share;
    line.show(progress);
    return !stop_requested();
  };
}

}  // namespace arenite::app
