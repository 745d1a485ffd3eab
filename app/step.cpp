#include <fmt/core.h>

#include <memory>

#include "commands.hpp"
#include "core/thread_count.hpp"
#include "film_reading.hpp"
#include "io/film/written_format.hpp"
#include "print.hpp"
#include "progress.hpp"
#include "thermal/thermography/blank_frames.hpp"
#include "thermal/thermography/step/step_load.hpp"
#include "workflow/film/map_numbers.hpp"

namespace arenite::app {
namespace {

using statistics::described;

struct StepArguments {
  std::string film, out;
  KeyOptions written{recipe::every_key<io::WrittenMaps>()};
  FilmReading reading;
  KeyOptions keys{recipe::every_key<recipe::StepSection>()};
  thermography::StepOptions options;
  int threads = Threads{}.threads;
  bool json = false, quiet = false;
};

FilmMaps maps_of(const thermography::StepMaps& m) {
  return {m.width,
          m.height,
          {{"jump", "K", &m.jump},
           {"standard_error", "K", &m.standard_error},
           {"level", "K", &m.level},
           {"drift_before", "K/s", &m.drift_before},
           {"drift_after", "K/s", &m.drift_after},
           {"residual", "K", &m.residual}}};
}

Numbers numbers(const thermography::StepMaps& m, const StepArguments& a, const FilmInfo& film) {
  Numbers j = workflow::step_numbers(m);
  j["time"] = a.options.time ? "given" : "found on the film";
  j["width"] = described(m.width, "", "Pixels along x");
  j["height"] = described(m.height, "", "Pixels along y");
  j["unit"] = unit_of(film);
  j["median"] = medians(maps_of(m), film);
  return j;
}

int execute(StepArguments& a) {
  thermography::StepOptions& o = a.options;
  recipe::StepSection section;
  read_options(section, a.keys.given());
  o = section.options();
  o.threads = a.threads;
  const auto film = io::open_film(a.film, a.reading.choice());
  tell_remarks(a.film, film->info());
  watch_for_signals();
  thermography::StepMaps maps;
  try {
    ProgressLine line(a.quiet || a.json);
    o.progress = frames_progress(line);
    maps = thermography::step_load(*film, o);
  } catch (const InputError& error) { throw in_file(error, a.film); }
  if (maps.size() == 0) {
    print(stderr, "stopped; nothing was stored\n");
    return other_failure;
  }
  if (!maps.blank.empty()) print(stderr, "{}: {}\n", a.film, thermography::blank_frames_sentence(maps.blank));
  for (const std::string& doubt : maps.doubts) print(stderr, "{}: {}\n", a.film, doubt);
  if (!a.out.empty()) write_maps(a.out, a.written.given(), maps_of(maps));
  const Numbers found = numbers(maps, a, film->info());
  print("{}", a.json ? to_json(found, 2) + "\n" : to_text(found));
  return done;
}

}  // namespace

void add_step(Options& command, int& status) {
  const auto a = std::make_shared<StepArguments>();
  command.add("film", a->film, "Film of a sample whose load steps once").required().type("FILM");
  for (const char* key : {"time", "rise", "window"}) a->keys.add(command, option_name(key), key).type("TIME");
  a->keys.add(command, "--drift", "drift");
  command.add("--out", a->out, "Folder for the maps; if not given, nothing is stored").type("DIR");
  a->written.add(command, "--format", "format");
  a->reading.add_to(command);
  add_threads(command, a->threads);
  add_json(command, a->json);
  add_quiet(command, a->quiet);
  command.work = [a, &status] { status = execute(*a); };
}

}  // namespace arenite::app
