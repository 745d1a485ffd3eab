#include "thermography/lockin.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>

#include "commands.hpp"
#include "core/error.hpp"
#include "core/median.hpp"
#include "core/units.hpp"
#include "film_maps.hpp"
#include "io/film.hpp"
#include "option_value.hpp"
#include "progress.hpp"
#include "stop_signal.hpp"
#include "study/film_checks.hpp"

namespace arenite::app {
namespace {

struct Arguments {
  std::string film, frequency, out, dataset, convention = "half", format = "tiff", frame_rate, diffusivity = "0.1 mm^2/s", pixel;
  thermography::LockinOptions options;
  bool nearest_bin = false, no_refinement = false, json = false, quiet = false;
};

FilmMaps maps_of(const LockinMaps& m) {
  return {m.width, m.height, {{"mean", &m.mean}, {"drift", &m.drift}, {"amplitude", &m.amplitude}, {"phase", &m.phase}, {"in_phase", &m.in_phase},
                              {"quadrature", &m.quadrature}, {"standard_error", &m.standard_error}, {"noise_floor", &m.noise_floor},
                              {"second_harmonic", &m.second_harmonic}, {"residual", &m.residual}}};
}

std::string unit_of(const FilmInfo& film) { return film.quantity == FilmQuantity::kelvin ? "K" : "level"; }

/// Whether heat stays where it came to be within a cycle.
struct Adiabatic {
  double length = 0, pixel = 0;  ///< m; no pixel: unknown
  double lost() const { return thermography::swing_lost_to_diffusion(length, pixel); }
  /// At a fifth of a pixel the finest detail loses 2 % of its swing and lags by 11 degrees.
  bool holds() const { return length <= pixel / 5; }
};

Adiabatic adiabatic(const Arguments& a, double frequency) {
  Adiabatic check;
  const double diffusivity = option_value("--diffusivity", [&] { return parse_si(a.diffusivity, dimension::area / dimension::time, "mm^2/s"); });
  if (!(diffusivity > 0)) throw InputError(fmt::format("--diffusivity is {}; it must be above 0", a.diffusivity));
  check.length = thermography::diffusion_length(diffusivity, frequency);
  if (a.pixel.empty()) return check;
  check.pixel = option_value("--pixel", [&] { return parse_si(a.pixel, dimension::length, "mm"); });
  if (!(check.pixel > 0)) throw InputError(fmt::format("--pixel is {}; it must be above 0", a.pixel));
  return check;
}

nlohmann::json numbers(const LockinMaps& m, const Arguments& a, const FilmInfo& film, const Adiabatic& heat) {
  nlohmann::json j;
  j["frequency_Hz"] = m.frequency;
  j["frequency_error_Hz"] = std::isfinite(m.frequency_error) ? nlohmann::json(m.frequency_error) : nlohmann::json();
  j["method"] = a.nearest_bin ? "nearest_bin" : "least_squares";
  j["frames"] = m.frames;
  j["width"] = m.width;
  j["height"] = m.height;
  j["drift_order"] = m.drift_order;
  j["harmonics"] = m.harmonics;
  j["swing"] = m.convention == SwingConvention::full ? "full" : "half";
  j["unit"] = unit_of(film);
  j["reference_phase_rad"] = m.reference_phase;
  j["reference"] = a.options.reference_phase ? "given" : "found on the film; its sign is the one with which pixels warm on the mean";
  for (const auto& [name, map] : maps_of(m).named)
    if (!map->empty()) j["median"][name] = median_of_finite(*map);
  j["noise_ratio"] = m.noise_ratio;
  j["shows_load"] = thermography::shows_swing(m);
  j["chance_of_noise"] = m.chance;
  j["share_in_one_phase"] = m.one_phase;
  j["diffusion_length_m"] = heat.length;
  if (heat.pixel > 0) {
    j["adiabatic"] = heat.holds();
    j["swing_lost_in_finest_detail"] = heat.lost();
  }
  return j;
}

void print(const LockinMaps& m, const Arguments& a, const FilmInfo& film, const Adiabatic& heat) {
  const std::string unit = unit_of(film);
  fmt::print("frequency        {:.9g} Hz", m.frequency);
  if (m.frequency_error > 0 && std::isfinite(m.frequency_error)) fmt::print(" +- {:.1e}", m.frequency_error);
  else if (m.frequency_error > 0) fmt::print(" as given: the film does not tell it");
  fmt::print("\nframes           {} of {} x {} pixels\n", m.frames, m.width, m.height);
  fmt::print("amplitude        {:.4g} {} ({} swing, median)\n", median_of_finite(m.amplitude), unit, m.convention == SwingConvention::full ? "full" : "half");
  fmt::print("standard error   {:.4g} {} (median)\nnoise floor      {:.4g} {} (median)\n", median_of_finite(m.standard_error), unit, median_of_finite(m.noise_floor), unit);
  if (!m.second_harmonic.empty()) fmt::print("second harmonic  {:.4g} {} (median)\n", median_of_finite(m.second_harmonic), unit);
  fmt::print("residual         {:.4g} {} (median)\n", median_of_finite(m.residual), unit);
  fmt::print("noise            {:.3g} times as much at this frequency as if it were white\n", std::sqrt(m.noise_ratio));
  fmt::print("reference phase  {:.6g} rad{}\n", m.reference_phase, a.options.reference_phase ? "" : ", found on the film up to its sign: pixels warm on the mean");
  fmt::print("diffusion length {:.4g} mm", 1e3 * heat.length);
  if (heat.pixel > 0) fmt::print(", {:.3g} pixels: the finest detail loses {:.2g} % of its swing", heat.length / heat.pixel, 100 * heat.lost());
  fmt::print("\n");
}

int execute(Arguments& a) {
  thermography::LockinOptions& o = a.options;
  o.frequency = option_value("--frequency", [&] { return parse_si(a.frequency, dimension::frequency, "Hz"); });
  o.refine = !a.no_refinement;
  o.convention = a.convention == "full" ? SwingConvention::full : SwingConvention::half;
  io::FilmChoice choice;
  choice.dataset = a.dataset;
  if (!a.frame_rate.empty()) choice.frame_rate = option_value("--frame-rate", [&] { return parse_si(a.frame_rate, dimension::frequency, "Hz"); });
  adiabatic(a, 1);  // slips are told before a long film is read
  const auto film = io::open_film(a.film, choice);
  watch_for_signals();
  LockinMaps maps;
  try {
    ProgressLine line(a.quiet || a.json);
    o.progress = frames_progress(line);
    maps = a.nearest_bin ? thermography::nearest_bin_transform(*film, o) : thermography::lock_in(*film, o);
  } catch (const InputError& error) {
    throw in_file(error, a.film);
  }
  if (maps.size() == 0) {
    fmt::print(stderr, "stopped; nothing was stored\n");
    return other_failure;
  }
  if (!a.out.empty()) write_maps(a.out, a.format, maps_of(maps));
  if (!thermography::shows_swing(maps)) fmt::print(stderr, "{}: {}\n", a.film, study::no_load_sentence(maps, maps.frequency, "--frequency"));
  const Adiabatic heat = adiabatic(a, maps.frequency);
  if (heat.pixel > 0 && !heat.holds())
    fmt::print(stderr, "heat diffuses {:.3g} pixels far within a cycle, not far less than one: the finest detail of the swing is not adiabatic; raise the load frequency\n",
               heat.length / heat.pixel);
  if (a.json) fmt::print("{}\n", numbers(maps, a, film->info(), heat).dump(2));
  else print(maps, a, film->info(), heat);
  return done;
}

}  // namespace

void add_lockin(CLI::App& command, int& status) {
  const auto a = std::make_shared<Arguments>();
  command.add_option("film", a->film, "Film of a cyclically loaded sample")->required()->type_name("FILM");
  command.add_option("--frequency", a->frequency, "Of the load, e.g. \"3 Hz\"; refined on the film")->required()->type_name("FREQUENCY");
  command.add_option("--out", a->out, "Folder for the maps; without it nothing is stored")->type_name("DIR");
  command.add_option("--format", a->format, "Of the maps")->check(CLI::IsMember({"tiff", "npy", "hdf5"}));
  command.add_option("--drift", a->options.drift_order, "Order of the polynomial that pixels drift by; default 4")->type_name("N");
  command.add_option("--harmonics", a->options.harmonics, "Of the load frequency; default 2")->type_name("N");
  command.add_option("--convention", a->convention, "Amplitudes are half of the swing (default) or all of it")->check(CLI::IsMember({"half", "full"}));
  command.add_option("--reference-phase", a->options.reference_phase, "Of the load, rad; without it found on the film up to its sign")->type_name("NUMBER");
  command.add_flag("--nearest-bin", a->nearest_bin, "Plain Fourier transform at the nearest bin, mean image subtracted");
  command.add_flag("--no-refinement", a->no_refinement, "Keep the frequency as it is given");
  command.add_option("--diffusivity", a->diffusivity, "Of heat in the grains, for the adiabatic check; default \"0.1 mm^2/s\", about that of plastics")->type_name("QUANTITY");
  command.add_option("--pixel", a->pixel, "Its side on the sample, e.g. \"1.6 mm\": warns where heat diffuses not far less within a cycle")->type_name("LENGTH");
  command.add_option("--frame-rate", a->frame_rate, "Instead of what the film says")->type_name("FREQUENCY");
  command.add_option("--dataset", a->dataset, "Dataset of an HDF5 file that holds several")->type_name("NAME");
  command.add_option("--threads", a->options.threads, "Threads; default 1")->check(CLI::Range(1, 256).description(""))->type_name("N");
  command.add_flag("--json", a->json, "Print all numbers as JSON");
  command.add_flag("--quiet", a->quiet, "No progress");
  command.callback([a, &status] { status = execute(*a); });
}

}  // namespace arenite::app
