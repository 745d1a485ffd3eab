#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "campaign/run_study.hpp"
#include "core/thread_count.hpp"
#include "report/figure_list.hpp"
#include "workflow/checkpoints.hpp"

namespace arenite::app {

/// What `arenite study` was given.
struct StudyArguments {
  std::string what, recipe, out, store, shard, keep = "all", time = "1:00:00";
  std::vector<std::string> overrides, by;
  std::size_t jobs = campaign::Jobs{}.at_once(), tasks = 4;
  int threads = Threads{}.threads;
  double checkpoint_seconds = workflow::Checkpoints{}.every;
  bool retry = false, quiet = false, slurm = false;
};

/// Runs, hashes, shared stages, time.
std::string plan_text(const campaign::Study& study, const campaign::StudyFolder& folder, std::size_t jobs);
/// How many runs stand where, what sharing saved, and why runs failed.
std::string status_text(const campaign::Study& study, const campaign::StudyFolder& folder);
/// A script for Slurm that runs the study as an array of tasks.
std::string slurm_script(const StudyArguments& arguments, const campaign::StudyFolder& folder);

/// Does the runs that are left, with `options` for what the user chose; shows progress unless `quiet`, tells notices,
/// and leaves at a signal, or where `options` asks to.
campaign::StudyOutcome run_missing(const campaign::Study& study, const campaign::StudyFolder& folder,
                                   campaign::StudyOptions options, bool quiet);

/// Where the figures of a study are declared: figures.toml beside its recipe.
std::filesystem::path figures_of(const campaign::Study& study);
std::vector<report::Figure> read_study_figures(const campaign::Study& study);
/// Draws them into study.html in the study's folder, and gives its place.
std::filesystem::path write_study_figures(const campaign::Study& study, const campaign::StudyFolder& folder);

}  // namespace arenite::app
