#include <fmt/core.h>

#include <memory>

#include "commands.hpp"
#include "io/film/written_format.hpp"
#include "print.hpp"
#include "progress.hpp"
#include "workflow/film/render_film.hpp"

namespace arenite::app {
namespace {

struct CameraArguments {
  std::string result, recipe, out = "out/film";
  KeyOptions written{recipe::every_key<io::WrittenFilms>()};
  std::vector<std::string> overrides;
  bool quiet = false, blind = false;
};

int execute(const CameraArguments& a) {
  const auto recipe = recipe::read_film_recipe(a.recipe, a.overrides);
  io::WrittenFilms written;
  read_options(written, a.written.given());
  watch_for_signals();
  std::vector<std::filesystem::path> files;
  {
    ProgressLine line(a.quiet);
    workflow::RenderOptions options;
    options.out = a.out;
    options.format = written.format;
    options.blind = a.blind;
    options.progress = [&](double share) {
      line.show({1, 2, "film", share, 0, 0, false, false});
      return !stop_requested();
    };
    files = workflow::render_film(recipe, a.result, options);
  }
  if (files.empty()) {
    print(stderr, "stopped; the film is not written\n");
    return other_failure;
  }
  for (const auto& file : files) print("{}\n", file.string());
  print("\nnow `arenite film {} --recipe {}`\n", files.front().string(), files.back().string());
  return done;
}

}  // namespace

void add_camera(Options& command, int& status) {
  const auto a = std::make_shared<CameraArguments>();
  command.add("result", a->result, "Folder of a run, or a stage file (.h5), whose states are filmed")
      .required()
      .type("RESULT");
  command.add("--recipe", a->recipe, "Recipe of the film, with a section [camera] (TOML)")
      .required()
      .type("RECIPE.toml");
  add_overrides(command, a->overrides);
  command.add("--out", a->out, fmt::format("Folder of the film, its references and its recipe (default: {})", a->out))
      .type("DIR");
  a->written.add(command, "--format", "format");
  command.add("--blind", a->blind,
              "Omit from film.toml what no laboratory knows exactly: lens blur, surroundings, phase of the load, "
              "displacement of the wall");
  add_quiet(command, a->quiet);
  command.work = [a, &status] { status = execute(*a); };
}

}  // namespace arenite::app
