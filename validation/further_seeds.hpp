#pragma once
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "validation/judge.hpp"
#include "validation/studies.hpp"

/// Further seeds of a study's runs, for checks that its own seeds leave undecided. Which come next follows from what is
/// there, never from a clock: a budget only decides how far it goes.
namespace arenite::validation {

/// So many seeds in all, the study's own among them, of some of its runs.
struct Extension {
  Draw draw;
  std::size_t seeds = 0;
};
/// In the order in which they were planned.
using SeedPlan = std::vector<Extension>;

/// A plan as it is kept: a table "study,where,seeds". Nothing is planned where there is no file. Throws InputError for
/// another file.
SeedPlan read_plan(const std::filesystem::path& file);
void write_plan(const std::filesystem::path& file, const SeedPlan& plan);

/// A study with the further seeds that a plan has of it.
class SeededStudy {
 public:
  SeededStudy(const StudySource& source, const std::filesystem::path& folder, bool small,
              const std::vector<std::string>& overrides, const SeedPlan& plan);

  std::size_t own_seeds() const { return own_seeds_; }
  /// Its own runs, then those that are planned, seed by seed.
  const campaign::Study& planned() const { return planned_; }
  /// The same without seeds of which a planned run has not ended: half a seed does not count.
  campaign::Study whole() const;
  /// Its runs that have these values, one for each of their combinations.
  std::size_t runs_a_seed(const Where& where) const;
  double seconds_a_run() const { return seconds_a_run_; }

 private:
  struct Further {
    std::size_t run, seed;  ///< place among the planned runs
  };
  std::filesystem::path folder_;
  campaign::Study planned_;
  SeedPlan plan_;  ///< of this study
  std::vector<Further> further_;
  std::size_t own_runs_ = 0, own_seeds_ = 1;
  double seconds_a_run_ = 0;
};

/// What would decide a check: how far to go next, and how many further runs and seconds of one core it takes in all if
/// its value stays where it is.
struct SeedsWanted {
  std::string claim, what;  ///< "T20", "signed a_c of A-A contacts"
  SeedPlan next;
  double runs = 0, seconds = 0;
};
/// Of every check that is undecided and that seeds can decide, the cheapest first; equal ones in the order of the
/// ledger. Checks that even most_times_seeds would not decide are left out. `study` gives a study by its
/// name, or nullptr.
std::vector<SeedsWanted> seeds_wanted(const Ledger& ledger, const SeedPlan& plan,
                                      const std::function<const SeededStudy*(const std::string&)>& study);

/// "thesis-ch6 (contact.surface_energy = 1.060)".
std::string in_words(const Draw& draw);

}  // namespace arenite::validation
