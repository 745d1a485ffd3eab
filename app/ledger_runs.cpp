#include "ledger_runs.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>

#include "campaign/virtual_film.hpp"
#include "print.hpp"
#include "progress.hpp"
#include "report/study/study_figures.hpp"
#include "study_parts.hpp"

namespace arenite::app {
namespace {

namespace fs = std::filesystem;
using LedgerClock = std::chrono::steady_clock;

/// Runs what is missing of a study, until the deadline if there is one. `attempted`: runs that this command has done
/// already, which it does not repeat again.
LedgerEnd complete(const campaign::Study& study, const campaign::StudyFolder& folder, const VerifyArguments& a,
                   Deadline deadline, std::set<std::string>& attempted) {
  campaign::StudyOptions options;
  options.jobs = a.jobs;
  options.keep_fields = a.keep == "all";
  const auto file_of = [&](const campaign::StudyRun& run) { return folder.run(run.name).string(); };
  options.repeats = [&](const campaign::StudyRun& run) { return a.retry && !attempted.contains(file_of(run)); };
  options.asked_to_stop = [deadline] { return deadline && LedgerClock::now() >= *deadline; };
  const bool interrupted = run_missing(study, folder, options, a.quiet).interrupted;
  for (const campaign::StudyRun& run : study.runs) attempted.insert(file_of(run));
  if (!interrupted) return LedgerEnd::complete;
  return stop_requested() ? LedgerEnd::stopped : LedgerEnd::budget_spent;
}

/// The films that the study's figures show; false if it was asked to stop.
bool make_ledger_films(const campaign::Study& study, const campaign::StudyFolder& folder,
                       const campaign::CollectedTable& table) {
  const auto filmed = report::filmed_runs(read_study_figures(study), table);
  workflow::RunOptions options;
  options.notice = [](const std::string& sentence) { print(stderr, "{}\n", sentence); };
  options.asked_to_stop = stop_requested;
  return std::ranges::all_of(study.runs, [&](const campaign::StudyRun& run) {
    return std::ranges::count(filmed, run.name) == 0 || campaign::make_film(study, folder, run, options);
  });
}

/// Whose claims are judged.
char letter_of(const std::string& source) { return source == "thesis" ? 'T' : 'P'; }

/// Does what is missing of a source's runs.
LedgerEnd run_studies(char letter, LedgerStudies& studies, const VerifyArguments& a, Deadline deadline) {
  for (const std::string& name : validation::studies_of(letter)) {
    const auto* study = studies.find(name);
    if (!study) continue;
    if (!a.quiet && !deadline) print(stderr, "{}: {} runs\n", name, study->planned().runs.size());
    const LedgerEnd end =
        complete(deadline ? study->planned() : study->whole(), *studies.folder(name), a, deadline, studies.attempted());
    if (end != LedgerEnd::complete) return end;
  }
  return LedgerEnd::complete;
}

/// Reads the runs of a source's studies, and makes their films and pages; false if it was asked to stop.
bool gather(char letter, LedgerStudies& studies, const VerifyArguments& a, bool finally, validation::Results& results) {
  for (const std::string& name : validation::studies_of(letter)) {
    const auto folder = studies.folder(name);
    if (!folder) continue;
    const auto* seeded = studies.find(name);
    if (!seeded) {
      validation::unpack(*validation::find_study(name), folder->out);
      results.add(name, {}, folder->out);
      continue;
    }
    const campaign::Study study = seeded->whole();
    results.add(name, campaign::collect(study, *folder), folder->out);
    if (!finally || !fs::exists(figures_of(study))) continue;
    const bool films = fs::exists(folder->out / "camera.toml") && (!a.small || name == campaign::filmed_study);
    if (!a.read_only && films && !make_ledger_films(study, *folder, results.table(name))) return false;
    write_study_figures(study, *folder);
  }
  return true;
}

std::vector<validation::SeedsWanted> wanted_of(const validation::Ledger& ledger, LedgerStudies& studies) {
  return validation::seeds_wanted(ledger, studies.plan(), [&](const std::string& name) { return studies.find(name); });
}

/// "T20, signed a_c of A-A contacts: about 80 further runs, 23 min of one core; next, 19 seeds of thesis-ch5".
std::string in_words(const validation::SeedsWanted& wanted) {
  std::string seeds;
  for (const auto& [draw, count] : wanted.next)
    seeds += fmt::format("{}{} seeds of {}", seeds.empty() ? "" : ", ", count, validation::in_words(draw));
  return fmt::format("{}, {}: about {:.0f} further runs, {:.0f} min of one core; next, {}", wanted.claim, wanted.what,
                     std::ceil(wanted.runs), std::ceil(wanted.seconds / 60), seeds);
}

}  // namespace

LedgerStudies::LedgerStudies(fs::path out, const VerifyArguments& arguments)
    : out_(std::move(out)),
      arguments_(arguments),
      plan_(validation::read_plan(out_ / "further-seeds.csv")) {}

void LedgerStudies::add_to_plan(const validation::SeedPlan& more) {
  plan_.insert(plan_.end(), more.begin(), more.end());
  validation::write_plan(out_ / "further-seeds.csv", plan_);
  for (const auto& extension : more) read_.erase(extension.draw.study);
}

std::optional<campaign::StudyFolder> LedgerStudies::folder(const std::string& name) const {
  const auto* source = validation::find_study(name);
  const auto& only = arguments_.only;
  if (!source || (!only.empty() && std::ranges::count(only, name) == 0)) return std::nullopt;
  if (arguments_.read_only && source->has_runs() && !fs::exists(out_ / name)) return std::nullopt;
  return campaign::StudyFolder(out_ / name, out_ / "store");  // what two studies make alike is made once
}

const validation::SeededStudy* LedgerStudies::find(const std::string& name) {
  const auto place = folder(name);
  const auto* source = validation::find_study(name);
  if (!place || !source->has_runs()) return nullptr;
  const auto at = read_.find(name);
  if (at != read_.end()) return &at->second;
  return &read_.try_emplace(name, *source, place->out, arguments_.small, arguments_.overrides, plan_).first->second;
}

LedgerEnd run_ledger(LedgerStudies& studies, const VerifyArguments& a, Deadline deadline) {
  for (const std::string& source : a.sources)
    if (const LedgerEnd end = run_studies(letter_of(source), studies, a, deadline); end != LedgerEnd::complete)
      return end;
  return LedgerEnd::complete;
}

std::optional<validation::Ledger> judge_ledger(LedgerStudies& studies, const VerifyArguments& a, bool finally) {
  validation::Ledger all;
  for (const std::string& source : a.sources) {
    validation::Results results;
    const char letter = letter_of(source);
    if (!gather(letter, studies, a, finally, results)) return std::nullopt;
    validation::Ledger one = validation::judge(letter, results);
    all.studies.insert(all.studies.end(), one.studies.begin(), one.studies.end());
    std::move(one.claims.begin(), one.claims.end(), std::back_inserter(all.claims));
  }
  return all;
}

LedgerEnd draw_further_seeds(LedgerStudies& studies, const VerifyArguments& a, double seconds) {
  const std::chrono::duration<double> budget(seconds);
  const auto deadline = LedgerClock::now() + std::chrono::duration_cast<LedgerClock::duration>(budget);
  while (true) {
    if (const LedgerEnd end = run_ledger(studies, a, deadline); end != LedgerEnd::complete) return end;
    const auto ledger = judge_ledger(studies, a, false);
    if (!ledger) return LedgerEnd::stopped;
    const auto wanted = wanted_of(*ledger, studies);
    if (wanted.empty()) return LedgerEnd::complete;
    if (LedgerClock::now() >= deadline) return LedgerEnd::budget_spent;
    if (!a.quiet) print(stderr, "further seeds for {}\n", in_words(wanted.front()));
    studies.add_to_plan(wanted.front().next);
  }
}

void tell_what_is_left(const validation::Ledger& ledger, LedgerStudies& studies) {
  std::set<std::string> planned;
  for (const auto& extension : studies.plan()) planned.insert(extension.draw.study);
  for (const std::string& name : planned) {
    const auto* study = studies.find(name);
    const std::size_t left = study ? study->planned().runs.size() - study->whole().runs.size() : 0;
    if (left > 0) print(stderr, "left of the further seeds of {}: {} runs\n", name, left);
  }
  for (const auto& wanted : wanted_of(ledger, studies)) print(stderr, "left to further seeds: {}\n", in_words(wanted));
}

}  // namespace arenite::app
