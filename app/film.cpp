#include <fmt/core.h>

#include <filesystem>
#include <memory>
#include <utility>

#include "commands.hpp"
#include "core/thread_count.hpp"
#include "film_reading.hpp"
#include "print.hpp"
#include "progress.hpp"
#include "report/film_text.hpp"
#include "report/page.hpp"
#include "workflow/film/run_film.hpp"

namespace arenite::app {
namespace {

namespace fs = std::filesystem;

struct FilmArguments {
  std::string film, recipe, out;
  std::vector<std::string> overrides;
  FilmReading reading;
  int threads = Threads{}.threads;
  bool json = false, quiet = false;
};

int execute(const FilmArguments& a) {
  std::vector<std::string> overrides = a.overrides;
  for (auto& given : a.reading.overrides()) overrides.push_back(std::move(given));
  const auto recipe = recipe::read_film_recipe(a.recipe, overrides);
  const fs::path film = a.film.empty() ? recipe.film_named() : fs::path(a.film),
                 folder = a.out.empty() ? fs::path("out") / film.stem() : fs::path(a.out);
  watch_for_signals();
  workflow::FilmOutcome outcome;
  {
    ProgressLine line(a.quiet);
    workflow::FilmRunOptions options;
    options.out = folder;
    options.threads = a.threads;
    options.asked_to_stop = stop_requested;
    options.progress = [&](const workflow::Progress& progress) { line.show(progress); };
    options.notice = [&](const std::string& sentence) { line.notice(sentence); };
    outcome = workflow::run_film(film, recipe, options);
  }
  if (outcome.interrupted) {
    print(stderr, "stopped; the simulation so far is kept in {}\n", folder.string());
    return other_failure;
  }
  const fs::path page = folder / "report.html";
  report::write_page(
      page,
      {.stages = outcome.simulation.stages, .films = {&outcome.result, 1}, .measured = &outcome.simulation.measured});
  print("{}", a.json ? to_json(report::film_numbers(outcome.result), 2) + "\n" : report::film_text(outcome.result));
  if (!a.json) print("\nresult: {}\npage:   {}   (open it in a browser)\n", outcome.file.string(), page.string());
  return outcome.result.converged ? done : not_converged;
}

}  // namespace

void add_film(Options& command, int& status) {
  const auto a = std::make_shared<FilmArguments>();
  command.add("film", a->film, "Film of a cyclically loaded packing, unless the recipe names it: " + io::film_formats())
      .type("FILM");
  command.add("--recipe", a->recipe, "Recipe of the film (TOML); `arenite init film` writes one")
      .required()
      .type("RECIPE.toml");
  add_overrides(command, a->overrides);
  a->reading.add_to(command);
  command.add("--out", a->out, "Folder of the result, the simulation and the page (default: out/NAME)").type("DIR");
  add_threads(command, a->threads);
  add_json(command, a->json);
  add_quiet(command, a->quiet);
  command.work = [a, &status] { status = execute(*a); };
}

}  // namespace arenite::app
