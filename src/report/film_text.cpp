#include <fmt/format.h>

#include <algorithm>

#include "core/median.hpp"
#include "io/film/film.hpp"
#include "report/result_text.hpp"
#include "report/summary.hpp"
#include "thermal/thermography/correction.hpp"

namespace arenite::report {
namespace {

const char* name_of(FilmQuantity quantity) {
  switch (quantity) {
    case FilmQuantity::digital_level: return "digital_level";
    case FilmQuantity::kelvin: return "kelvin";
    case FilmQuantity::unknown: return "unknown";
  }
  return "";
}

/// Of the first frames.
struct Pixels {
  std::size_t frames;
  double least, most, middle, noise;
  thermography::Doubtful doubtful;
};

Pixels pixels_of(const thermography::FrameStatistics& s, int bits) {
  return {s.frames,
          static_cast<double>(*std::min_element(s.least.begin(), s.least.end())),
          static_cast<double>(*std::max_element(s.most.begin(), s.most.end())),
          median(s.mean),
          median(s.noise),
          thermography::doubtful(s, bits)};
}

Numbers summary_numbers(const FilmInfo& film, const io::FrameIntervals& times, const Pixels& pixels) {
  const auto known = [](double value) { return value > 0 ? Numbers(value) : Numbers(nullptr); };
  Numbers j{{"format", film.format},
            {"width", film.width},
            {"height", film.height},
            {"frames", film.frames},
            {"frame_rate_Hz", known(film.frame_rate)},
            {"integration_s", known(film.integration)},
            {"camera", film.camera},
            {"lens", film.lens},
            {"filter", film.filter},
            {"bits", film.bits},
            {"floating", film.floating},
            {"quantity", name_of(film.quantity)},
            {"emissivity", known(film.emissivity)},
            {"ambient_K", known(film.ambient)},
            {"band_low_m", known(film.band_low)},
            {"band_high_m", known(film.band_high)},
            {"stamped", !film.time.empty()},
            {"frame_interval_s", known(times.interval)},
            {"duration_s", known(times.duration)},
            {"dropped_frames", times.dropped}};
  j["gaps_before_frames"] = times.gap;
  j["pixels"] = {{"frames_read", pixels.frames},
                 {"least", pixels.least},
                 {"most", pixels.most},
                 {"median", pixels.middle},
                 {"median_noise", pixels.noise},
                 {"constant", pixels.doubtful.constant},
                 {"saturated", pixels.doubtful.saturated}};
  j["remarks"] = film.remarks;
  return j;
}

std::string summary_text(const FilmInfo& film, const io::FrameIntervals& times, const Pixels& pixels) {
  std::string out = fmt::format("{} film of {} frames, {} x {} pixels, {}\n", film.format, film.frames, film.width, film.height,
                                film.floating ? "floating" : fmt::format("{} bit", film.bits));
  const auto line = [&](const char* name, const std::string& value) { out += fmt::format("{:<14}{}\n", name, value); };
  if (!film.camera.empty()) line("camera", film.camera + (film.lens.empty() ? "" : ", " + film.lens) + (film.filter.empty() ? "" : ", " + film.filter));
  if (film.frame_rate > 0) line("frame rate", fmt::format("{:.6g} Hz", film.frame_rate));
  if (film.integration > 0) line("integration", fmt::format("{:.6g} us", film.integration * 1e6));
  if (times.duration > 0)
    line("duration",
         fmt::format("{:.6g} s, a frame every {:.6g} ms ({})", times.duration, times.interval * 1e3, film.time.empty() ? "from the frame rate" : "stamped"));
  if (times.dropped > 0)
    line("missing", fmt::format("{} frames of the camera's{}", times.dropped,
                                times.gap.empty() ? ", evenly" : fmt::format(", before frame {}{}", times.gap[0], times.gap.size() > 1 ? " and others" : "")));
  if (film.quantity == FilmQuantity::kelvin) line("pixels hold", "temperatures, K");
  if (film.quantity == FilmQuantity::digital_level) line("pixels hold", "digital levels");
  line("pixels",
       fmt::format("{:.6g} to {:.6g}, median {:.6g}, noise {:.3g} (first {} frames)", pixels.least, pixels.most, pixels.middle, pixels.noise, pixels.frames));
  if (pixels.doubtful.constant > 0) line("constant", fmt::format("{} pixels never change", pixels.doubtful.constant));
  if (pixels.doubtful.saturated > 0) line("saturated", fmt::format("{} pixels reach the top of the range", pixels.doubtful.saturated));
  for (const std::string& remark : film.remarks) out += remark + '\n';
  return out;
}

void describe_grains(TextLines& lines, const FilmResult& r) {
  lines.heading("Grains");
  lines.number("all", "/grains/all");
  for (const Material& m : r.packing.materials) lines.number(m.name, "/grains/" + m.name);
  lines.numbers({{"error of a centre", "/grains/position_error_pixels", "pixels"},
                 {"travel, median", "/motion/median_travel_pixels", "pixels"},
                 {"travel, largest", "/motion/largest_travel_pixels", "pixels"}});
  if (!lines.has("/texture/sigma_norm")) return;
  lines.section("Peak-to-peak stress of the grains over its mean",
                {{"P_0, fraction above the mean", "/texture/sigma_norm/P0"}, {"beta of the tail", "/texture/sigma_norm/beta"}});
}

/// How the forces agree with the film and with what was given beside it.
void describe_checks(TextLines& lines, const Numbers& checks) {
  lines.section("Forces against film and load", {{"left by the fit over the noise", "/checks/misfit_over_noise"},
                                                 {"left by the fit over the signal", "/checks/misfit_over_signal"},
                                                 {"error of fields that agrees", "/checks/field_error_that_agrees"},
                                                 {"load by forces inferred without it", "/checks/load_by_forces_N", "N"},
                                                 {"blur of the rims", "/checks/blur_of_rims_pixels", "pixels"}});
  if (checks.contains("factor_scale"))
    for (const auto& [name, value] : checks["factor_scale"].items())
      lines.number("factor that fits over the given one, " + name, "/checks/factor_scale/" + name);
  if (checks.contains("doubts"))
    for (const auto& doubt : checks["doubts"]) lines.raw("! " + doubt.get<std::string>());
}

}  // namespace

FilmSummary film_summary(FilmSource& film, std::size_t most_frames) {
  const FilmInfo& info = film.info();
  const io::FrameIntervals times = io::frame_intervals(info);
  const Pixels pixels = pixels_of(thermography::frame_statistics(film, most_frames), info.bits);
  return {summary_text(info, times, pixels), summary_numbers(info, times, pixels)};
}

std::string film_text(const FilmResult& r) {
  TextLines lines(r.numbers);
  lines.section("Film", {{"camera", "/film/camera"},
                         {"format", "/film/format"},
                         {"frames", "/film/frames"},
                         {"frames in a second", "/film/frame_rate_Hz", "Hz"},
                         {"pixels that were replaced", "/film/bad_pixels"}});
  lines.section(r.maps.convention == AmplitudeConvention::peak_to_peak ? "Lock-in (peak to peak)" : "Lock-in (amplitudes)",
                {{"frequency of the load", "/lockin/frequency_Hz", "Hz"},
                 {"phase of the load", "/lockin/reference_phase_deg", "deg"},
                 {"standard error of a pixel", "/lockin/standard_error_K", "K"},
                 {"residual of a frame", "/lockin/residual_K", "K"},
                 {"second harmonic", "/lockin/second_harmonic_K", "K"}});
  describe_grains(lines, r);
  if (lines.has("/forces/proposed"))
    lines.section("Contact forces (peak to peak)", {{"contacts proposed", "/forces/proposed"},
                                                    {"of these there", "/forces/present"},
                                                    {"mean normal force", "/forces/mean_N", "N"},
                                                    {"fraction above the mean", "/forces/fraction_above_mean"},
                                                    {"standard error, normal", "/forces/fn_error_N", "N"},
                                                    {"standard error, tangential", "/forces/ft_error_N", "N"}});
  if (lines.has("/checks")) describe_checks(lines, r.numbers["checks"]);
  if (lines.has("/directions/film"))
    lines.section("Contact orientations", {{"film: a_c", "/directions/film/a_c"},
                                           {"film: theta_c", "/directions/film/theta_c_deg", "deg"},
                                           {"simulation: a_c", "/directions/simulation/a_c"},
                                           {"simulation: theta_c", "/directions/simulation/theta_c_deg", "deg"}});
  if (lines.has("/simulation"))
    lines.section("Companion simulation", {{"peak to peak: correlation", "/simulation/peak_to_peak/all/correlation"},
                                           {"peak to peak: rms of sigma_norm", "/simulation/peak_to_peak/all/rms_sigma_norm"},
                                           {"state at the largest load: correlation", "/simulation/state/all/correlation"},
                                           {"state at the largest load: rms of sigma_norm", "/simulation/state/all/rms_sigma_norm"}});
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
