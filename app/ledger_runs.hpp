#pragma once
#include <chrono>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "campaign/run_study.hpp"
#include "validation/further_seeds.hpp"

namespace arenite::app {

/// What `arenite verify` was given.
struct VerifyArguments {
  std::vector<std::string> sources, overrides, only;
  std::string out, markdown, csv, verdicts, expected, keep = "numbers", budget;
  std::size_t jobs = campaign::Jobs{}.at_once();
  bool small = false, json = false, read_only = false, retry = false, quiet = false;
};

/// How a part of the work of a ledger ended.
enum class LedgerEnd { complete, budget_spent, stopped };

/// The studies of the ledger, with the further seeds that are planned of them (further-seeds.csv beside their folders).
class LedgerStudies {
 public:
  LedgerStudies(std::filesystem::path out, const VerifyArguments& arguments);

  const validation::SeedPlan& plan() const { return plan_; }
  void add_to_plan(const validation::SeedPlan& more);
  /// Where the runs of one of them lie; nothing where none are wanted.
  std::optional<campaign::StudyFolder> folder(const std::string& name) const;
  /// nullptr where it has no runs, or none are wanted.
  const validation::SeededStudy* find(const std::string& name);
  /// Folders of runs that this command has been through.
  std::set<std::string>& attempted() { return attempted_; }

 private:
  std::filesystem::path out_;
  const VerifyArguments& arguments_;
  validation::SeedPlan plan_;
  std::map<std::string, validation::SeededStudy> read_;
  std::set<std::string> attempted_;
};

using Deadline = std::optional<std::chrono::steady_clock::time_point>;
/// Does what is missing of the studies' own runs, or, until a deadline, of these and of all further seeds that are
/// planned.
LedgerEnd run_ledger(LedgerStudies& studies, const VerifyArguments& arguments, Deadline deadline = {});
/// Draws further seeds for what they can decide, until it is decided or so many seconds are over.
LedgerEnd draw_further_seeds(LedgerStudies& studies, const VerifyArguments& arguments, double seconds);
/// What the runs say; nothing if it was asked to stop. `finally`: with the films that are missing, unless it is to read
/// only, and with the pages of the studies.
std::optional<validation::Ledger> judge_ledger(LedgerStudies& studies, const VerifyArguments& arguments, bool finally);
/// Says what seeds could decide and have not.
void tell_what_is_left(const validation::Ledger& ledger, LedgerStudies& studies);

}  // namespace arenite::app
