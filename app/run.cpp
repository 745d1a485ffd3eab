#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>

#include "commands.hpp"
#include "core/thread_count.hpp"
#include "io/disk/file.hpp"
#include "print.hpp"
#include "progress.hpp"
#include "recipe/film_recipe.hpp"
#include "report/page.hpp"
#include "run_status.hpp"
#include "watch_server.hpp"
#include "workflow/checkpoints.hpp"
#include "workflow/lammps/engine_options.hpp"
#include "workflow/run.hpp"

namespace arenite::app {

namespace {

namespace fs = std::filesystem;

struct RunArguments {
  std::vector<std::string> recipes, overrides;
  KeyOptions keys{recipe::recipe_keys()}, engine_keys{recipe::every_key<workflow::EngineOptions>()};
  workflow::EngineOptions engine;
  std::string out;
  int threads = Threads{}.threads;
  bool quiet = false, watch = false;
  double checkpoint_seconds = workflow::Checkpoints{}.every;
};

/// A recipe's folder if its file is called recipe.toml, the file's own name otherwise.
fs::path name_of(const fs::path& recipe) {
  const auto absolute = fs::absolute(recipe);
  return absolute.stem() == "recipe" ? absolute.parent_path().filename() : absolute.stem();
}

/// --out itself for one recipe, a folder each below it for several; out/NAME if it is not given.
fs::path folder_for(const std::string& recipe, const RunArguments& arguments) {
  if (arguments.out.empty()) return fs::path("out") / name_of(recipe);
  return arguments.recipes.size() == 1 ? fs::path(arguments.out) : fs::path(arguments.out) / name_of(recipe);
}

/// What only the run finds wrong with a key that --set gave is no slip of the recipe.
InputError blame_overrides(const InputError& error, const std::string& recipe,
                           const std::vector<std::string>& overrides) {
  auto problems = error.problems();
  for (auto& problem : problems)
    for (const auto& assignment : overrides)
      if (problem.file == recipe && problem.message.starts_with(assignment.substr(0, assignment.find('=')) + " "))
        problem.file = "--set " + assignment;
  return InputError(std::move(problems));
}

/// The run itself, with its line and its status file.
workflow::RunOutcome carry_out(const recipe::Recipe& recipe, const fs::path& folder, const RunArguments& arguments,
                               StatusFile& status) {
  workflow::RunOptions options;
  options.out = folder;
  options.checkpoint_seconds = arguments.checkpoint_seconds;
  options.asked_to_stop = stop_requested;
  options.page_follows = true;
  options.engine = arguments.engine.is_lammps() ? &arguments.engine : nullptr;
  ProgressLine line(arguments.quiet);
  options.progress = [&](const workflow::Progress& progress) {
    line.show(progress);
    status.show(progress);
  };
  options.notice = [&](const std::string& sentence) { line.notice(sentence); };
  const bool was_there = fs::exists(folder);
  try {
    return workflow::run(recipe, options);
  } catch (const InputError& error) {
    status.finish();
    std::error_code ignored;
    if (!was_there) fs::remove(folder, ignored);  // only if nothing is in it
    throw blame_overrides(error, recipe.source_file, arguments.overrides);
  } catch (...) {
    status.finish();
    throw;
  }
}

Status run_one(const recipe::Recipe& recipe, const fs::path& folder, const RunArguments& arguments) {
  const std::optional<Watcher> watcher = arguments.watch ? std::optional<Watcher>(std::in_place, folder) : std::nullopt;
  StatusFile status(folder, request_stop);
  const workflow::RunOutcome outcome = carry_out(recipe, folder, arguments, status);
  if (outcome.interrupted) {
    print(stderr, "stopped; the same command continues from the checkpoint in {}\n", folder.string());
    return other_failure;
  }
  for (const auto& stage : outcome.stages) print("{:<12} {}\n", stage.name, stage.outcome);
  for (const auto& stage : outcome.spheres) print("{:<12} {}\n", stage.name, stage.outcome);
  for (const auto& field : outcome.fields) print("{:<12} {}\n", field.name, field.outcome);
  for (const auto& sample : outcome.voxels) print("{:<12} {}\n", sample.name, sample.outcome);
  const auto page = folder / "report.html";
  report::write_page(page, {.stages = outcome.stages,
                            .fields = outcome.fields,
                            .voxels = outcome.voxels,
                            .spheres = outcome.spheres,
                            .measured = &outcome.measured});
  status.finish();
  print("\nresults: {0}\npage:    {1}   (open it in a browser)\nnumbers: arenite show {0}\n", folder.string(),
        page.string());
  return outcome.converged ? done : not_converged;
}

recipe::Recipe read(const std::string& file, const std::vector<std::string>& overrides) {
  if (recipe::describes_film(io::read_file(file)))
    throw InputError(file, 0,
                     fmt::format("is the recipe of a film (`arenite film FILM --recipe {}`), not of a simulation; "
                                 "`arenite init composite r.toml` writes one of a simulation",
                                 file));
  return recipe::read_recipe(file, overrides);
}

/// All recipes are read before the first is run, so that a slip in the last shows at once.
int execute(RunArguments& arguments) {
  read_options(arguments.engine, arguments.engine_keys.given());
  auto overrides = arguments.overrides;
  for (std::string& key : arguments.keys.overrides()) overrides.push_back(std::move(key));
  std::vector<recipe::Recipe> recipes;
  for (const auto& file : arguments.recipes) {
    recipes.push_back(read(file, overrides));
    recipes.back().integration.threads = arguments.threads;
  }
  watch_for_signals();
  int status = done;
  for (std::size_t r = 0; r < recipes.size() && !stop_requested(); ++r) {
    if (recipes.size() > 1) print("{}{}\n", r == 0 ? "" : "\n", recipes[r].title);
    status = std::max<int>(status, run_one(recipes[r], folder_for(arguments.recipes[r], arguments), arguments));
  }
  return status;
}

}  // namespace

void add_run(Options& command, int& status) {
  auto arguments = std::make_shared<RunArguments>();
  command.add("recipe", arguments->recipes, "Recipe to run (TOML); several are run one after the other")
      .required()
      .type("RECIPE.toml");
  add_overrides(command, arguments->overrides);
  command.add("--out", arguments->out, "Output folder; with several recipes, one subfolder each (default: out/NAME)")
      .type("DIR");
  add_threads(command, arguments->threads);
  arguments->keys.add(command, "--kernel", "integration.kernel").type("NAME");
  add_checkpoints(command, arguments->checkpoint_seconds);
  arguments->engine_keys.add(command, "--engine", "engine").type("NAME");
  arguments->engine_keys.add(command, "--lammps-stages", "lammps_stages").type("[NAME,..]");
  arguments->engine_keys.add(command, "--ranks", "ranks").type("N");
  arguments->engine_keys.add(command, "--lammps-command", "lammps_command").type("COMMAND");
  arguments->engine_keys.add(command, "--restart-every", "restart_every").type("STEPS");
  arguments->engine_keys.add(command, "--prepare", "prepare");
  command.add("--watch", arguments->watch,
              "Serve a live page of the run to browsers on this machine, and print its address");
  add_quiet(command, arguments->quiet);
  command.work = [arguments, &status] { status = execute(*arguments); };
}

}  // namespace arenite::app
