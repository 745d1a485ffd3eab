#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <csignal>
#include <filesystem>
#include <memory>

#include "commands.hpp"
#include "progress.hpp"
#include "report/page.hpp"
#include "study/run.hpp"
#include "texture/texture.hpp"

namespace arenite::app {

namespace {

namespace fs = std::filesystem;

struct Arguments {
  RecipeArguments recipe;
  std::string out, kernel;
  int threads = 1;
  bool quiet = false;
  double checkpoint_seconds = 30;
};

volatile std::sig_atomic_t stop_requested = 0;

void request_stop(int) { stop_requested = 1; }

/// "out/NAME": the recipe's folder if the file is called recipe.toml, its own name otherwise.
fs::path default_folder(const fs::path& recipe) {
  const auto absolute = fs::absolute(recipe);
  return fs::path("out") / (absolute.stem() == "recipe" ? absolute.parent_path().filename() : absolute.stem());
}

/// States whose texture is measured for the page: all of them in a small sample, the last of each stage in a large one.
bool shows_texture(const StageResult& stage, std::size_t frame) {
  constexpr std::size_t small = 10'000;
  return frame + 1 == stage.frames.size() || stage.frames[frame].packing.grains.size() <= small;
}

void write_page(const fs::path& path, const study::Recipe& recipe, const std::vector<StageResult>& stages) {
  report::PageData data;
  data.title = recipe.title;
  for (std::size_t s = 0; s < stages.size(); ++s) {
    data.stages.push_back(&stages[s]);
    for (std::size_t f = 0; f < stages[s].frames.size(); ++f)
      if (shows_texture(stages[s], f)) data.textures.push_back({s, f, texture::measure(stages[s].frames[f].packing, study::texture_options(recipe, s))});
  }
  report::write_page(path, data);
}

int execute(const Arguments& arguments) {
  auto overrides = arguments.recipe.overrides;
  if (!arguments.kernel.empty()) overrides.push_back("integration.kernel=" + arguments.kernel);
  auto recipe = study::read_recipe(arguments.recipe.file, overrides);
  recipe.integration.threads = arguments.threads;

  study::RunOptions options;
  options.out = arguments.out.empty() ? default_folder(arguments.recipe.file) : fs::path(arguments.out);
  options.checkpoint_seconds = arguments.checkpoint_seconds;
  options.asked_to_stop = [] { return stop_requested != 0; };
  std::signal(SIGTERM, request_stop);
  std::signal(SIGINT, request_stop);

  study::RunOutcome outcome;
  {
    ProgressLine line(arguments.quiet);
    options.progress = [&](const study::Progress& progress) { line.show(progress); };
    outcome = study::run(recipe, options);
  }
  if (outcome.interrupted) {
    fmt::print(stderr, "stopped; the same command goes on from the checkpoint in {}\n", options.out.string());
    return other_failure;
  }
  for (const auto& stage : outcome.stages) fmt::print("{:<12} {}\n", stage.name, stage.outcome);
  const auto page = options.out / "report.html";
  write_page(page, recipe, outcome.stages);
  fmt::print("\nresults: {0}\npage:    {1}   (open it in a browser)\nnumbers: arenite show {0}\n", options.out.string(), page.string());
  return outcome.converged ? done : not_converged;
}

}  // namespace

void add_run(CLI::App& command, int& status) {
  auto arguments = std::make_shared<Arguments>();
  add_recipe_arguments(command, arguments->recipe);
  command.add_option("--out", arguments->out, "Folder of the results (default: out/NAME)")->type_name("DIR");
  command.add_option("--threads", arguments->threads, "Threads; they change no bit of the results")->check(CLI::PositiveNumber)->type_name("N");
  command.add_option("--kernel", arguments->kernel, "Kernel of the contact loop: auto, portable, avx2, avx512")->type_name("NAME");
  command.add_option("--checkpoint-every", arguments->checkpoint_seconds, "Seconds between two checkpoints")->check(CLI::NonNegativeNumber)->type_name("S");
  command.add_flag("--quiet", arguments->quiet, "No progress");
  command.callback([arguments, &status] { status = execute(*arguments); });
}

}  // namespace arenite::app
