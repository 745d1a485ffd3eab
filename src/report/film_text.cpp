#include "report/film_text.hpp"

#include <fmt/format.h>

#include "report/number_lines.hpp"
#include "statistics/numbers.hpp"

namespace arenite::report {
namespace {

void describe_film(NumberLines& lines, const FilmResult& r) {
  lines.heading("Film");
  lines.add("camera", "/film/camera");
  lines.add("format", "/film/format");
  lines.add("frames", "/film/frames");
  lines.add("frames in a second", "/film/frame_rate_Hz", "Hz");
  lines.add("pixels that were replaced", "/film/bad_pixels");
  lines.heading(fmt::format("Lock-in ({} swings)", r.maps.convention == SwingConvention::full ? "full" : "half"));
  lines.add("frequency of the load", "/lockin/frequency_Hz", "Hz");
  lines.add("phase of the load", "/lockin/reference_phase_deg", "deg");
  lines.add("standard error of a pixel", "/lockin/standard_error_K", "K");
  lines.add("residual of a frame", "/lockin/residual_K", "K");
  lines.add("second harmonic", "/lockin/second_harmonic_K", "K");
}

void describe_grains(NumberLines& lines, const FilmResult& r) {
  lines.heading("Grains");
  lines.add("all", "/grains/all");
  for (const Material& m : r.packing.materials) lines.add(m.name, "/grains/" + m.name);
  lines.add("error of a centre", "/grains/position_error_pixels", "pixels");
  lines.add("travel, median", "/motion/median_travel_pixels", "pixels");
  lines.add("travel, largest", "/motion/largest_travel_pixels", "pixels");
  if (!lines.has("/texture/sigma_norm")) return;
  lines.heading("Swing of the grains' stress over its mean");
  lines.add("P_0, share above the mean", "/texture/sigma_norm/P0");
  lines.add("beta of the tail", "/texture/sigma_norm/beta");
}

void describe_forces(NumberLines& lines) {
  if (!lines.has("/forces/proposed")) return;
  lines.heading("Contact forces (swing)");
  lines.add("contacts proposed", "/forces/proposed");
  lines.add("of these there", "/forces/present");
  lines.add("mean normal force", "/forces/mean_N", "N");
  lines.add("share above the mean", "/forces/share_above_mean");
  lines.add("standard error, normal", "/forces/fn_error_N", "N");
  lines.add("standard error, tangential", "/forces/ft_error_N", "N");
}

/// How the forces agree with the film and with what was told beside it.
void describe_checks(NumberLines& lines, const Numbers& numbers) {
  if (!lines.has("/checks")) return;
  lines.heading("Forces against film and load");
  lines.add("left by the fit over the noise", "/checks/misfit_over_noise");
  lines.add("left by the fit over the signal", "/checks/misfit_over_signal");
  lines.add("error of fields that agrees", "/checks/field_error_that_agrees");
  lines.add("load by forces not told it", "/checks/load_by_forces_N", "N");
  lines.add("blur of the rims", "/checks/blur_of_rims_pixels", "pixels");
  if (lines.has("/checks/factor_scale"))
    for (const auto& [name, value] : numbers["checks"]["factor_scale"].items()) lines.add("factor wanted over told, " + name, "/checks/factor_scale/" + name);
  if (lines.has("/checks/doubts"))
    for (const auto& doubt : numbers["checks"]["doubts"]) lines.raw("! " + doubt.get<std::string>());
}

void describe_directions(NumberLines& lines) {
  if (!lines.has("/directions/film")) return;
  lines.heading("Directions of contacts");
  for (const auto& [what, words] : {std::pair{"film", "film"}, {"twin", "simulation"}}) {
    lines.add(fmt::format("{}: a_c", words), fmt::format("/directions/{}/a_c", what));
    lines.add(fmt::format("{}: theta_c", words), fmt::format("/directions/{}/theta_c_deg", what), "deg");
  }
}

void describe_twin(NumberLines& lines) {
  if (!lines.has("/twin")) return;
  lines.heading("Simulation beside the film");
  for (const auto& [what, words] : {std::pair{"swing", "swing"}, {"state", "state at the largest load"}}) {
    lines.add(fmt::format("{}: correlation", words), fmt::format("/twin/{}/all/correlation", what));
    lines.add(fmt::format("{}: rms of sigma_norm", words), fmt::format("/twin/{}/all/rms_sigma_norm", what));
  }
}

}  // namespace

std::string film_text(const FilmResult& r) {
  NumberLines lines(r.numbers);
  describe_film(lines, r);
  describe_grains(lines, r);
  describe_forces(lines);
  describe_checks(lines, r.numbers);
  describe_directions(lines);
  describe_twin(lines);
  return r.outcome + "\n" + std::move(lines).text();
}

Numbers film_numbers(const FilmResult& r) {
  Numbers j = r.numbers;
  const Provenance& p = r.provenance;
  j["provenance"] = {{"version", p.version}, {"stage", p.stage}, {"input_hash", p.input_hash}, {"recipe", p.recipe}};
  j["outcome"] = r.outcome;
  return j;
}

}  // namespace arenite::report
