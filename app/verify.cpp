#include <fmt/core.h>

#include <algorithm>
#include <ctime>
#include <fstream>
#include <memory>
#include <thread>

#include "commands.hpp"
#include "core/units.hpp"
#include "core/version.hpp"
#include "io/disk/file.hpp"
#include "ledger_runs.hpp"
#include "print.hpp"
#include "progress.hpp"
#include "validation/report.hpp"
#include "validation/report_dots.hpp"
#include "workflow/result_folder.hpp"

namespace arenite::app {
namespace {

namespace fs = std::filesystem;

constexpr const char *usual_out = "out/ledger", *usual_out_of_small = "out/ledger-small";

int stopped() {
  print(stderr, "stopped; the same command continues where it stopped\n");
  return other_failure;
}

/// The processor's name as Linux has it.
std::string processor_name() {
  std::ifstream in("/proc/cpuinfo");
  for (std::string line; std::getline(in, line);)
    if (line.starts_with("model name")) return line.substr(std::min(line.size(), line.find(':') + 2));
  return "unknown processor";
}

/// Date, version and machine, and how to read the page.
std::string heading(const VerifyArguments& a) {
  char date[16] = "";
  const std::time_t now = std::time(nullptr);
  std::strftime(date, sizeof date, "%Y-%m-%d", std::gmtime(&now));
  return fmt::format(
      "# The ledger of claims{}\n\n{}Written by `arenite verify`, version {}, on {}, {} cores of {}.\n\n"
      "Errors (±) are standard errors over runs with different seeds. A check holds where the 95 % interval (Student's "
      "t) lies within the claimed range, fails where it lies outside, and is undecided where it contains a bound. Many "
      "numbers of one kind, such as those of all pairs, form one check: it holds if each of them holds, and fails if "
      "one lies outside after Holm's correction; the value shown is the worst case. Independence of a parameter means "
      "that the change lies within a margin. *Decided by* names what a verdict depends on: more seeds, the grid, the "
      "protocol (friction, damping, equilibrium, load), the reading of a sentence or a rule of the source, the "
      "source's own tables, or data that it did not keep. Law S has a tangential spring; law R is the thesis's "
      "regularised friction, which has no static friction. {}\n\n",
      a.sources.size() == 1 ? ": the " + a.sources[0] : "",
      a.small ? "**From the small studies: this is not the ledger.**\n\n" : "", version, date,
      std::thread::hardware_concurrency(), processor_name(),
      a.csv.empty()
          ? "`--csv FILE` writes all checks and all choices."
          : fmt::format("All checks, and all choices, are in [{0}]({0}).", fs::path(a.csv).filename().string()));
}

bool fails(const validation::Ledger& ledger) {
  return std::any_of(ledger.claims.begin(), ledger.claims.end(), [](const auto& judged) {
    return judged.judgement.verdict() == validation::Verdict::not_reproduced;
  });
}

/// The page, and its pictures in a folder of its name beside it; those of claims that have none any more go.
void write_page(const validation::Ledger& ledger, const VerifyArguments& a) {
  const fs::path file = a.markdown;
  fs::path folder = file;
  folder.replace_extension();
  if (folder == file) folder += ".pictures";
  for (const auto& [claim, judgement] : ledger.claims) {
    const fs::path picture = folder / (std::string(claim->id) + ".svg");
    if (judgement.verdict() != validation::Verdict::reproduced && validation::has_dots(judgement)) {
      workflow::make_folder(folder);
      io::write_atomically(picture, validation::ledger_dots(judgement));
    } else {
      fs::remove(picture);
    }
  }
  io::write_atomically(file, heading(a) + validation::ledger_page(ledger, folder.filename().string()));
}

int execute(const VerifyArguments& a) {
  const fs::path out = !a.out.empty() ? a.out : a.small ? usual_out_of_small : usual_out;
  const bool draws = !a.budget.empty();
  const double budget =
      draws ? option_value("--budget", [&] { return parse_si(a.budget, dimension::time, "min"); }) : 0;
  watch_for_signals();
  LedgerStudies studies(out, a);
  // All runs come before the pages: a process that has solved for a field or for forces can start no other that solves,
  // since the threads of the sparse solver do not outlive a fork.
  if (!a.read_only && run_ledger(studies, a) != LedgerEnd::complete) return stopped();
  if (draws && draw_further_seeds(studies, a, budget) == LedgerEnd::stopped) return stopped();
  const auto judged = judge_ledger(studies, a, true);
  if (!judged) return stopped();
  const validation::Ledger& all = *judged;
  if (draws) tell_what_is_left(all, studies);
  print("{}", a.json ? validation::ledger_json(all) : validation::ledger_text(all));
  if (!a.markdown.empty()) write_page(all, a);
  if (!a.csv.empty()) io::write_atomically(a.csv, validation::ledger_csv(all));
  if (!a.verdicts.empty()) io::write_atomically(a.verdicts, validation::ledger_verdicts(all, a.small));
  if (a.expected.empty()) return fails(all) ? not_converged : done;
  const auto changes = validation::changed_verdicts(all, io::read_file(a.expected), a.expected, a.small);
  for (const auto& change : changes) print(stderr, "{}\n", change);
  return changes.empty() ? done : not_converged;
}

}  // namespace

void add_verify(Options& command, int& status) {
  auto a = std::make_shared<VerifyArguments>();
  command.add("source", a->sources, "Source of the claims: the thesis, the paper, or both")
      .required()
      .type("SOURCE")
      .among({"thesis", "paper"});
  command.add("--small", a->small, "Smaller samples and fewer seeds: minutes instead of hours");
  command.add("--json", a->json, "Print the ledger as JSON");
  command
      .add("--markdown", a->markdown,
           "Also write the ledger as a Markdown page, with its pictures in a folder of the same name")
      .type("FILE");
  command.add("--csv", a->csv, "Also write all checks and all choices as a table").type("FILE");
  command.add("--verdicts", a->verdicts, "Write only the verdicts, to compare later ones with").type("FILE");
  command
      .add("--expect", a->expected,
           "Exit with status 3 when a verdict differs from this file, not when a claim is not reproduced")
      .type("FILE");
  command
      .add("--out", a->out,
           fmt::format("Folder of the studies (default: {}, or {} of small ones)", usual_out, usual_out_of_small))
      .type("DIR");
  add_jobs(command, a->jobs);
  command.add("--only", a->only, "Run and read only this study; may be repeated").each().type("STUDY");
  command.add("--read", a->read_only, "Run nothing: judge the existing runs");
  add_retry(command, a->retry).not_with("--read");
  command
      .add("--budget", a->budget,
           "Then draw further seeds for checks that they can decide, until these are decided or this time on the clock "
           "is over; the same command continues")
      .type("TIME")
      .not_with("--read");
  add_keep(command, a->keep);
  add_quiet(command, a->quiet);
  add_overrides(command, a->overrides);
  command.work = [a, &status] { status = execute(*a); };
}

}  // namespace arenite::app
