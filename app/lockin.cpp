#include "thermal/thermography/lockin.hpp"

#include <fmt/core.h>

#include <cmath>
#include <memory>
#include <numbers>

#include "commands.hpp"
#include "film_maps.hpp"
#include "io/table/table.hpp"
#include "print.hpp"
#include "progress.hpp"
#include "thermal/thermography/blank_frames.hpp"
#include "thermal/thermography/film_checks.hpp"
#include "thermal/thermography/judge_amplitude.hpp"
#include "workflow/film/film_correction.hpp"
#include "workflow/film/map_numbers.hpp"

namespace arenite::app {
namespace {

using statistics::described;

struct LockinArguments : MapsOfFilm {
  KeyOptions keys{recipe::every_key<recipe::LockinAlone>()};
  recipe::LockinAlone section;  ///< what they say
  thermography::LockinOptions options;
  bool by_lock_in_line = false;
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
  j["method"] = a.is_nearest_bin() ? "nearest_bin" : "least_squares";
  j["reference"] = a.by_lock_in_line ? "the film's lock-in line"
                   : a.options.reference_phase
                       ? "given"
                       : "found on the film; its sign is such that pixels warm with the load on "
                         "average";
  const std::vector<float> phase = phase_in_degrees(m);
  a.describe(j, maps_of(m, phase), film);
  j["diffusion_length_m"] = described(heat.length, "m", "Length over which heat diffuses within a cycle");
  if (heat.pixel <= 0) return j;
  j["adiabatic"] = described(heat.holds(), "", "Whether that is below a fifth of a pixel");
  j["amplitude_lost_in_finest_detail"] =
      described(heat.lost(), "", "Share of its amplitude that the finest detail of the picture loses to it");
  return j;
}

/// The film's own signal of the load, where it has one, gives frequency and reference.
void follow_load_signal(LockinArguments& a, const FilmInfo& film, ProgressLine& line) {
  thermography::LockinOptions& o = a.options;
  const auto load =
      workflow::load_signal_of(a.film, film, o.frequency, [&](const std::string& sentence) { line.notice(sentence); });
  if (!load) return;
  o.frequency = load->frequency;
  if (!o.reference_phase) o.reference_phase = load->phase, a.by_lock_in_line = true;
}

int execute(LockinArguments& a) {
  read_options(a.section, a.keys.given());
  tell_bare_phase(a.keys.text("phase"));
  thermography::LockinOptions& o = a.options;
  o = a.section.options();
  o.threads = a.threads;
  const auto film = a.open();
  const LockinMaps maps = a.made([&](ProgressLine& line) {
    follow_load_signal(a, film->info(), line);
    o.progress = frames_progress(line);
    return a.is_nearest_bin() ? thermography::nearest_bin_transform(*film, o) : thermography::lock_in(*film, o);
  });
  if (maps.size() == 0) return other_failure;
  a.write(maps_of(maps, phase_in_degrees(maps)));
  if (!maps.blank.empty()) a.tell(thermography::blank_frames_sentence(maps.blank));
  if (!thermography::shows_load(maps)) a.tell(thermography::no_load_sentence(maps, maps.frequency, "--frequency"));
  else if (maps.other_frequency > 0)
    a.tell(fmt::format("the amplitude is larger at {:.4g} Hz than at {:.6g} Hz, a multiple of it", maps.other_frequency,
                       maps.frequency));
  for (const std::string& sentence : maps.disturbances) a.tell(sentence);
  const thermography::Adiabatic heat = adiabatic(a, maps.frequency);
  if (heat.pixel > 0 && !heat.holds()) print(stderr, "{}\n", heat.sentence());
  a.print_numbers(numbers(maps, a, film->info(), heat));
  return done;
}

}  // namespace

void add_lockin(Options& command, int& status) {
  const auto a = std::make_shared<LockinArguments>();
  a->add_film(command, "Film of a cyclically loaded sample");
  a->keys.add(command, "--frequency", "frequency").required().type("FREQUENCY");
  a->add_out(command);
  a->keys.add(command, "--drift", "drift");
  a->keys.add(command, "--harmonics", "harmonics");
  a->keys.add(command, "--convention", "convention");
  a->keys.add(command, "--reference-phase", "phase", "rad").type("ANGLE");
  a->keys.add_word(command, "--nearest-bin", "method", "nearest_bin");
  a->keys.add_word(command, "--no-refinement", "refine", "false");
  a->keys.add(command, "--diffusivity", "diffusivity");
  a->keys.add(command, "--pixel", "pixel").type("LENGTH");
  a->add_others(command);
  command.work = [a, &status] { status = execute(*a); };
}

}  // namespace arenite::app
