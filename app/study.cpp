#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <memory>

#include "campaign/collect.hpp"
#include "commands.hpp"
#include "core/text.hpp"
#include "io/disk/file.hpp"
#include "print.hpp"
#include "progress.hpp"
#include "study_parts.hpp"
#include "workflow/result_folder.hpp"

namespace arenite::app {
namespace {

namespace fs = std::filesystem;

campaign::StudyFolder folder_of(const StudyArguments& arguments) {
  const auto recipe = fs::absolute(arguments.recipe);
  const fs::path name = recipe.stem() == "recipe" ? recipe.parent_path().filename() : recipe.stem();
  return campaign::StudyFolder(arguments.out.empty() ? fs::path("out") / name : fs::path(arguments.out),
                               arguments.store);
}

/// "2/4": the second of four.
void read_shard(const std::string& text, campaign::StudyOptions& options) {
  if (text.empty()) return;
  const auto slash = text.find('/');
  std::size_t part = 0;
  const auto whole = [](std::string_view digits, std::size_t& value) {
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    return error == std::errc{} && end == digits.data() + digits.size();
  };
  const std::string_view view(text);
  if (slash == std::string::npos || !whole(view.substr(0, slash), part) ||
      !whole(view.substr(slash + 1), options.shards) || part < 1 || part > options.shards)
    throw InputError(
        fmt::format("--shard {}: write the part and the number of parts, counted from 1, for example 2/4", text));
  options.shard = part - 1;
}

int run_command(const StudyArguments& arguments, const campaign::Study& study, const campaign::StudyFolder& folder) {
  campaign::StudyOptions options;
  options.jobs = arguments.jobs;
  options.threads = arguments.threads;
  read_shard(arguments.shard, options);
  options.repeats = [&](const campaign::StudyRun&) { return arguments.retry; };
  options.keep_fields = arguments.keep == "all";
  options.checkpoint_seconds = arguments.checkpoint_seconds;
  watch_for_signals();
  const campaign::StudyOutcome outcome = run_missing(study, folder, options, arguments.quiet);
  print("{}", status_text(study, folder));
  if (outcome.interrupted) {
    print(stderr, "stopped; the same command continues with the {} remaining runs\n", outcome.left);
    return other_failure;
  }
  print("\nresults: {0}\nnumbers: arenite study collect {1} --out {0}\n", folder.out.string(), arguments.recipe);
  print("page:    {}\n", write_study_figures(study, folder).string());
  return outcome.not_done > 0 ? not_converged : done;
}

int collect_command(const StudyArguments& arguments, const campaign::Study& study,
                    const campaign::StudyFolder& folder) {
  auto table = campaign::collect(study, folder);
  std::string name = "numbers";
  if (!arguments.by.empty()) {
    table = campaign::averaged(table, arguments.by);
    for (const auto& key : arguments.by) name += "-by-" + key;
  }
  for (const auto& [ending, text] : {std::pair(".csv", table.csv()), std::pair(".json", table.json())}) {
    const fs::path file = folder.out / (name + ending);
    io::write_atomically(file, text);
    print("{}\n", file.string());
  }
  return done;
}

int execute(const StudyArguments& arguments) {
  const campaign::StudyFolder folder = folder_of(arguments);
  if (arguments.what == "plan") {
    print("{}", plan_text(campaign::read_study(arguments.recipe, arguments.overrides), folder, arguments.jobs));
    return done;
  }
  if (arguments.what == "script") {
    if (!arguments.slurm) throw InputError("script: name the scheduler; only --slurm is supported");
    if (!arguments.shard.empty() || arguments.retry)
      throw InputError(
          fmt::format("{} is an option of run; each task of the script does one of the --tasks parts, and failed runs "
                      "are repeated by `arenite study run --retry`",
                      arguments.shard.empty() ? "--retry" : "--shard"));
    const auto study = campaign::read_study(arguments.recipe, arguments.overrides);  // so that slips show here
    workflow::make_folder(folder.out);
    print("{}", slurm_script(arguments, folder));
    return done;
  }
  if (arguments.what != "run" && !fs::exists(folder.out))
    throw InputError(
        folder.out.string(), 0,
        fmt::format("there is no such study; `arenite study run {}` creates it, or give its folder with --out",
                    arguments.recipe));
  // Slips of the recipe leave no folder.
  if (!fs::exists(folder.out)) static_cast<void>(campaign::read_study(arguments.recipe, arguments.overrides));
  workflow::make_folder(folder.out);
  const campaign::Study study = campaign::read_study(arguments.recipe, arguments.overrides, folder.out);
  if (arguments.what == "run") return run_command(arguments, study, folder);
  if (arguments.what == "collect") return collect_command(arguments, study, folder);
  if (arguments.what == "page") {
    print("{}\n", write_study_figures(study, folder).string());
    return done;
  }
  print("{}", status_text(study, folder));
  return done;
}

/// Says that an option, which other commands have too, is of this action alone.
void of_action(std::string_view action, Option& option) {
  option.sentence = fmt::format("{}: {}{}", action, lower_case(option.sentence.front()), option.sentence.substr(1));
}

}  // namespace

void add_study(Options& command, int& status) {
  auto a = std::make_shared<StudyArguments>();
  command
      .add("what", a->what,
           "Action: list the runs, run them, report progress, collect their numbers, draw the figures, write a script "
           "for a cluster")
      .required()
      .type("WHAT")
      .among({"plan", "run", "status", "collect", "page", "script"});
  command.add("recipe", a->recipe, "Recipe with a section [sweep] (TOML)").required().type("RECIPE.toml");
  add_overrides(command, a->overrides);
  command.add("--out", a->out, "Folder of the study (default: out/NAME)").type("DIR");
  command.add("--store", a->store, "Folder of stages shared by runs (default: store in the study's folder)")
      .type("DIR");
  add_jobs(command, a->jobs);
  add_threads(command, a->threads);
  command.add("--shard", a->shard, "run: do only one part of the runs, e.g. 2/4").type("I/N");
  of_action("run", add_retry(command, a->retry));
  of_action("run", add_keep(command, a->keep));
  add_checkpoints(command, a->checkpoint_seconds);
  of_action("run, script", add_quiet(command, a->quiet));
  command.add("--by", a->by, "collect: average over runs with equal values of this swept key; may be repeated")
      .each()
      .type("KEY");
  command.add("--slurm", a->slurm, "script: for Slurm");
  command.add("--tasks", a->tasks, "script: number of tasks of the array, each of which does its part of the runs")
      .between(1, 100000)
      .type("N");
  command.add("--time", a->time, "script: wall time of a task").type("H:MM:SS");
  command.work = [a, &status] { status = execute(*a); };
}

}  // namespace arenite::app
