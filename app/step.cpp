#include <fmt/core.h>

#include <memory>
#include <utility>

#include "commands.hpp"
#include "core/median.hpp"
#include "film_reading.hpp"
#include "progress.hpp"
#include "thermal/thermography/step_load.hpp"

namespace arenite::app {
namespace {

struct StepArguments {
  std::string film, time, rise = "0 s", window, out, format = "tiff";
  FilmReading reading;
  thermography::StepOptions options;
  bool json = false, quiet = false;
};

FilmMaps maps_of(const thermography::StepMaps& m) {
  return {m.width,
          m.height,
          {{"jump", &m.jump},
           {"standard_error", &m.standard_error},
           {"level", &m.level},
           {"drift_before", &m.drift_before},
           {"drift_after", &m.drift_after},
           {"residual", &m.residual}}};
}

void tell(const thermography::StepMaps& m, const StepArguments& a, const FilmInfo& film) {
  const std::string unit = film.quantity == FilmQuantity::kelvin ? "K" : "level";
  if (!a.json) {
    fmt::print("step             {:.6g} s after the first frame{}\n", m.time, a.time.empty() ? ", found on the film" : "");
    fmt::print("frames           {} before, {} after, of {} x {} pixels\n", m.before, m.after, m.width, m.height);
    for (const auto& [side, time] : {std::pair{"before", m.relaxation_before}, std::pair{"after", m.relaxation_after}})
      if (time > 0) fmt::print("relaxation       {:.4g} s, exponential, {} the step\n", time, side);
    fmt::print("jump             {:.4g} {} (median)\nstandard error   {:.4g} {} (median)\nresidual         {:.4g} {} (median)\n", median_of_finite(m.jump),
               unit, median_of_finite(m.standard_error), unit, median_of_finite(m.residual), unit);
    return;
  }
  Numbers j{{"time_s", m.time},
            {"time", a.time.empty() ? "found on the film" : "given"},
            {"frames_before", m.before},
            {"frames_after", m.after},
            {"width", m.width},
            {"height", m.height},
            {"drift_order", m.drift_order},
            {"unit", unit}};
  const auto relaxation = [](double time) { return time > 0 ? Numbers(time) : Numbers(); };
  j["relaxation_before_s"] = relaxation(m.relaxation_before);
  j["relaxation_after_s"] = relaxation(m.relaxation_after);
  for (const auto& [name, map] : maps_of(m).named) j["median"][name] = median_of_finite(*map);
  fmt::print("{}\n", to_json(j, 2));
}

int execute(StepArguments& a) {
  thermography::StepOptions& o = a.options;
  const auto seconds = [](const char* option, const std::string& text) { return option_value(option, [&] { return parse_si(text, dimension::time, "s"); }); };
  if (!a.time.empty()) o.time = seconds("--time", a.time);
  o.rise = seconds("--rise", a.rise);
  if (!a.window.empty()) o.window = seconds("--window", a.window);
  const auto film = io::open_film(a.film, a.reading.choice());
  watch_for_signals();
  thermography::StepMaps maps;
  try {
    ProgressLine line(a.quiet || a.json);
    o.progress = frames_progress(line);
    maps = thermography::step_load(*film, o);
  } catch (const InputError& error) { throw in_file(error, a.film); }
  if (maps.size() == 0) {
    fmt::print(stderr, "stopped; nothing was stored\n");
    return other_failure;
  }
  if (!a.out.empty()) write_maps(a.out, a.format, maps_of(maps));
  tell(maps, a, film->info());
  return done;
}

}  // namespace

void add_step(Options& command, int& status) {
  const auto a = std::make_shared<StepArguments>();
  command.add("film", a->film, "Film of a sample whose load steps once").required().type("FILM");
  command.add("--time", a->time, "Time of the middle of the step after the first frame, e.g. \"2.5 s\"; if not given, found on the film").type("TIME");
  command.add("--rise", a->rise, "Time that the load takes to change; frames within it are left out; default 0 s").type("TIME");
  command.add("--window", a->window, "Time before and after the step that is used; default: the whole film").type("TIME");
  command.add("--drift", a->options.drift_order, "Order of the polynomial that describes the drift of pixels on each side; default 1").type("N");
  command.add("--out", a->out, "Folder for the maps; if not given, nothing is stored").type("DIR");
  command.add("--format", a->format, "Format of the maps").among({"tiff", "npy", "hdf5"});
  a->reading.add_to(command);
  command.add("--threads", a->options.threads, "Threads (default: 1)").between(1, 256).type("N");
  command.add("--json", a->json, "Print all numbers as JSON");
  command.add("--quiet", a->quiet, "Show no progress");
  command.work = [a, &status] { status = execute(*a); };
}

}  // namespace arenite::app
