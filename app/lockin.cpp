#include "thermal/thermography/lockin.hpp"

#include <fmt/core.h>

#include <cmath>
#include <memory>
#include <numbers>

#include "commands.hpp"
#include "core/thread_count.hpp"
#include "film_reading.hpp"
#include "io/film/written_format.hpp"
#include "io/table/table.hpp"
#include "print.hpp"
#include "progress.hpp"
#include "statistics/numbers_text.hpp"
#include "thermal/thermography/blank_frames.hpp"
#include "thermal/thermography/film_checks.hpp"
#include "thermal/thermography/judge_amplitude.hpp"
#include "workflow/film/film_correction.hpp"
#include "workflow/film/map_numbers.hpp"

namespace arenite::app {
namespace {

using statistics::described;

struct LockinArguments {
  std::string film, out;
  KeyOptions written{recipe::every_key<io::WrittenMaps>()};
  FilmReading reading;
  KeyOptions keys{recipe::every_key<recipe::LockinAlone>()};
  recipe::LockinAlone section;  ///< what they say
  thermography::LockinOptions options;
  int threads = Threads{}.threads;
  bool by_lock_in_line = false, json = false, quiet = false;
  bool is_nearest_bin() const { return section.method == recipe::LockinSection::Method::nearest_bin; }
};

constexpr double degrees = 180 / std::numbers::pi;

/// `phase`: that of the maps, in degrees.
FilmMaps maps_of(const LockinMaps& m, const std::vector<float>& phase) {
  FilmMaps maps{m.width, m.height, {}};
  for (const auto& [name, unit, values] : lockin_maps) {
    const bool is_phase = values == &LockinMaps::phase;
    maps.maps.push_back({name, is_phase ? "deg" : unit, is_phase ? &phase : &(m.*values)});
  }
  return maps;
}

std::vector<float> phase_in_degrees(const LockinMaps& m) {
  std::vector<float> phase = m.phase;
  for (float& v : phase) v *= static_cast<float>(degrees);
  return phase;
}

/// A bare number was in radians once, and still is.
void tell_bare_phase(const std::string& text) {
  if (!text.empty() && io::to_number(text))
    print(stderr,
          "--reference-phase {0} is taken to be in radians; write \"{0} rad\" or an angle in degrees, such as \"90 "
          "deg\"\n",
          text);
}

thermography::Adiabatic adiabatic(const LockinArguments& a, double frequency) {
  return {a.section.diffusivity, frequency, a.section.pixel.value_or(0)};
}

Numbers numbers(const LockinMaps& m, const LockinArguments& a, const FilmInfo& film,
                const thermography::Adiabatic& heat) {
  Numbers j = workflow::lockin_numbers(m, unit_of(film));
  j["width"] = described(m.width, "", "Pixels along x");
  j["height"] = described(m.height, "", "Pixels along y");
  j["method"] = a.is_nearest_bin() ? "nearest_bin" : "least_squares";
  j["reference"] = a.by_lock_in_line ? "the film's lock-in line"
                   : a.options.reference_phase
                       ? "given"
                       : "found on the film; its sign is such that pixels warm with the load on "
                         "average";
  const std::vector<float> phase = phase_in_degrees(m);
  j["median"] = medians(maps_of(m, phase), film);
  j["diffusion_length_m"] = described(heat.length, "m", "Length over which heat diffuses within a cycle");
  if (heat.pixel <= 0) return j;
  j["adiabatic"] = described(heat.holds(), "", "Whether that is below a fifth of a pixel");
  j["amplitude_lost_in_finest_detail"] =
      described(heat.lost(), "", "Share of its amplitude that the finest detail of the picture loses to it");
  return j;
}

int execute(LockinArguments& a) {
  read_options(a.section, a.keys.given());
  tell_bare_phase(a.keys.text("phase"));
  thermography::LockinOptions& o = a.options;
  o = a.section.options();
  o.threads = a.threads;
  const auto film = io::open_film(a.film, a.reading.choice());
  tell_remarks(a.film, film->info());
  watch_for_signals();
  LockinMaps maps;
  try {
    ProgressLine line(a.quiet || a.json);
    if (const auto load = workflow::load_signal_of(a.film, film->info(), o.frequency,
                                                   [&](const std::string& sentence) { line.notice(sentence); })) {
      o.frequency = load->frequency;
      if (!o.reference_phase) o.reference_phase = load->phase, a.by_lock_in_line = true;
    }
    o.progress = frames_progress(line);
    maps = a.is_nearest_bin() ? thermography::nearest_bin_transform(*film, o) : thermography::lock_in(*film, o);
  } catch (const InputError& error) { throw in_file(error, a.film); }
  if (maps.size() == 0) {
    print(stderr, "stopped; nothing was stored\n");
    return other_failure;
  }
  if (!a.out.empty()) write_maps(a.out, a.written.given(), maps_of(maps, phase_in_degrees(maps)));
  if (!maps.blank.empty()) print(stderr, "{}: {}\n", a.film, thermography::blank_frames_sentence(maps.blank));
  if (!thermography::shows_load(maps))
    print(stderr, "{}: {}\n", a.film, thermography::no_load_sentence(maps, maps.frequency, "--frequency"));
  else if (maps.other_frequency > 0)
    print(stderr, "{}: the amplitude is larger at {:.4g} Hz than at {:.6g} Hz, a multiple of it\n", a.film,
          maps.other_frequency, maps.frequency);
  for (const std::string& sentence : maps.disturbances) print(stderr, "{}: {}\n", a.film, sentence);
  const thermography::Adiabatic heat = adiabatic(a, maps.frequency);
  if (heat.pixel > 0 && !heat.holds()) print(stderr, "{}\n", heat.sentence());
  const Numbers found = numbers(maps, a, film->info(), heat);
  print("{}", a.json ? to_json(found, 2) + "\n" : to_text(found));
  return done;
}

}  // namespace

void add_lockin(Options& command, int& status) {
  const auto a = std::make_shared<LockinArguments>();
  command.add("film", a->film, "Film of a cyclically loaded sample").required().type("FILM");
  a->keys.add(command, "--frequency", "frequency").required().type("FREQUENCY");
  command.add("--out", a->out, "Folder for the maps; if not given, nothing is stored").type("DIR");
  a->written.add(command, "--format", "format");
  a->keys.add(command, "--drift", "drift");
  a->keys.add(command, "--harmonics", "harmonics");
  a->keys.add(command, "--convention", "convention");
  a->keys.add(command, "--reference-phase", "phase", "rad").type("ANGLE");
  a->keys.add_word(command, "--nearest-bin", "method", "nearest_bin");
  a->keys.add_word(command, "--no-refinement", "refine", "false");
  a->keys.add(command, "--diffusivity", "diffusivity");
  a->keys.add(command, "--pixel", "pixel").type("LENGTH");
  a->reading.add_to(command);
  add_threads(command, a->threads);
  add_json(command, a->json);
  add_quiet(command, a->quiet);
  command.work = [a, &status] { status = execute(*a); };
}

}  // namespace arenite::app
