#include <memory>

#include "commands.hpp"
#include "film_maps.hpp"
#include "thermal/thermography/blank_frames.hpp"
#include "thermal/thermography/step/step_load.hpp"
#include "workflow/film/map_numbers.hpp"

namespace arenite::app {
namespace {

struct StepArguments : MapsOfFilm {
  KeyOptions keys{recipe::every_key<recipe::StepSection>()};
  thermography::StepOptions options;
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
  j["unit"] = unit_of(film);
  a.describe(j, maps_of(m), film);
  return j;
}

int execute(StepArguments& a) {
  thermography::StepOptions& o = a.options;
  recipe::StepSection section;
  read_options(section, a.keys.given());
  o = section.options();
  o.threads = a.threads;
  const auto film = a.open();
  const thermography::StepMaps maps = a.made([&](ProgressLine& line) {
    o.progress = frames_progress(line);
    return thermography::step_load(*film, o);
  });
  if (maps.size() == 0) return other_failure;
  if (!maps.blank.empty()) a.tell(thermography::blank_frames_sentence(maps.blank));
  for (const std::string& doubt : maps.doubts) a.tell(doubt);
  a.write(maps_of(maps));
  a.print_numbers(numbers(maps, a, film->info()));
  return done;
}

}  // namespace

void add_step(Options& command, int& status) {
  const auto a = std::make_shared<StepArguments>();
  a->add_film(command, "Film of a sample whose load steps once");
  for (const char* key : {"time", "rise", "window"}) a->keys.add(command, option_name(key), key).type("TIME");
  a->keys.add(command, "--drift", "drift");
  a->add_out(command);
  a->add_others(command);
  command.work = [a, &status] { status = execute(*a); };
}

}  // namespace arenite::app
