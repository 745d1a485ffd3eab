#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <cstdio>

#include "report/summary.hpp"
#include "stop_signal.hpp"
#include "study_parts.hpp"

namespace arenite::app {
namespace {

double now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

/// One line on stderr about a study at work: rewritten on a terminal, one every ten seconds elsewhere.
class StudyLine {
 public:
  explicit StudyLine(bool quiet);
  ~StudyLine();
  void show(const study::StudyProgress& progress);

 private:
  bool quiet_, terminal_, open_ = false;
  std::string last_;
  double shown_at_ = -1e9;
};

StudyLine::StudyLine(bool quiet) : quiet_(quiet), terminal_(isatty(fileno(stderr)) != 0) {}

StudyLine::~StudyLine() {
  if (open_) std::fputc('\n', stderr);
}

void StudyLine::show(const study::StudyProgress& p) {
  if (quiet_) return;
  std::string line = fmt::format("{} of {} done", p.done, p.runs);
  if (p.not_done > 0) line += fmt::format(", {} failed", p.not_done);
  if (p.running > 0) line += fmt::format(", {} running", p.running);
  const bool ended = p.done + p.not_done == p.runs;
  if (!ended && !std::isnan(p.seconds_left)) line += fmt::format(", about {} left", duration_text(p.seconds_left));
  if (line == last_ || (!ended && now() - shown_at_ < (terminal_ ? 0.2 : 10.0))) return;
  last_ = line;
  shown_at_ = now();
  std::fprintf(stderr, terminal_ ? "\r\033[K%s" : "%s\n", line.c_str());
  open_ = terminal_;
  std::fflush(stderr);
}

}  // namespace

study::StudyOutcome run_missing(const study::Study& study, const study::StudyFolder& folder, study::StudyOptions options, bool quiet) {
  options.numbers = [](const study::RunOutcome& outcome) { return report::Summary(outcome).numbers(); };
  options.asked_to_stop = stop_requested;
  options.notice = [](const std::string& sentence) { fmt::print(stderr, "{}\n", sentence); };
  StudyLine line(quiet);
  options.progress = [&](const study::StudyProgress& progress) { line.show(progress); };
  return study::run_study(study, folder, options);
}

}  // namespace arenite::app
