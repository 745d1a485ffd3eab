#include "progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>

#include "stop_signal.hpp"

namespace arenite::app {

namespace {

std::string duration(double seconds) {
  if (seconds < 90) return fmt::format("{:.0f} s", seconds);
  if (seconds < 5400) return fmt::format("{:.0f} min", seconds / 60);
  return fmt::format("{:.1f} h", seconds / 3600);
}

std::string bar(double share) {
  constexpr int width = 24;
  const int full = std::clamp(static_cast<int>(share * width), 0, width);
  return "[" + std::string(full, '#') + std::string(width - full, '.') + "]";
}

}  // namespace

ProgressLine::ProgressLine(bool quiet) : quiet_(quiet), terminal_(isatty(fileno(stderr)) != 0) {}

ProgressLine::~ProgressLine() {
  if (open_) std::fputc('\n', stderr);
}

void ProgressLine::begin_stage(const study::Progress& progress) {
  if (open_) std::fputc('\n', stderr);
  open_ = false;
  stage_ = progress.stage;
  share_at_start_ = progress.share;
  stage_began_ = Clock::now();
  last_shown_ = stage_began_ - std::chrono::hours(1);
}

std::string ProgressLine::text(const study::Progress& progress) const {
  std::string line = progress.stages > 1 ? fmt::format("{}/{} ", progress.stage, progress.stages - 1) : "";
  line += fmt::format("{:<12}", progress.name);
  if (progress.reused) return line + " was there already";
  line += fmt::format(" {} {:3.0f} %", bar(progress.share), 100 * progress.share);
  if (progress.step > 0)
    line += fmt::format("  {} {}  {} {:.1e}", progress.field ? "iteration" : "step", progress.step, progress.field ? "residual" : "unbalanced",
                        progress.unbalanced_ratio);
  const double elapsed = std::chrono::duration<double>(Clock::now() - stage_began_).count();
  const double gained = progress.share - share_at_start_;
  if (progress.share >= 1) return line + fmt::format("  {} in all", duration(elapsed));
  if (gained > 0.02 && elapsed > 1) line += fmt::format("  about {} left", duration(elapsed * (1 - progress.share) / gained));
  return line;
}

void ProgressLine::show(const study::Progress& progress) {
  if (quiet_) return;
  if (progress.stage != stage_) begin_stage(progress);
  const auto now = Clock::now();
  const bool ended = progress.share >= 1;
  const auto pause = terminal_ ? std::chrono::milliseconds(100) : std::chrono::milliseconds(10'000);
  if (!ended && now - last_shown_ < pause) return;
  last_shown_ = now;
  if (terminal_) {
    std::fprintf(stderr, "\r\033[K%s", text(progress).c_str());
    open_ = true;
  } else {
    std::fprintf(stderr, "%s\n", text(progress).c_str());
  }
  std::fflush(stderr);
}

void ProgressLine::notice(const std::string& sentence) {
  std::fprintf(stderr, "%s%s\n", open_ ? "\n" : "", sentence.c_str());
  open_ = false;
}

std::function<bool(double share)> frames_progress(ProgressLine& line) {
  return [&line](double share) {
    study::Progress progress;
    progress.stages = 1;
    progress.name = "frames";
    progress.share = share;
    line.show(progress);
    return !stop_requested();
  };
}

}  // namespace arenite::app
