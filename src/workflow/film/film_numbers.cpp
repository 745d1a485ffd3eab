#include "workflow/film/film_numbers.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>
#include <vector>

#include "core/median.hpp"
#include "grains/texture/force_level.hpp"
#include "grains/texture/texture.hpp"
#include "model/lockin_maps.hpp"
#include "thermal/inference/film_stresses.hpp"
#include "thermal/thermography/grains/grain_places.hpp"
#include "workflow/film/map_numbers.hpp"

namespace arenite::workflow {
namespace {

using statistics::described;
using statistics::Estimate;
using statistics::put;
using statistics::put_angle;

/// Adds the contact orientations of one source under its name, where it has contacts.
void add_orientations(Numbers& out, const char* source, const texture::Texture& texture) {
  const Numbers fabric = texture.numbers.value("fabric", Numbers::tree());
  if (fabric.value("contacts", 0) == 0) return;
  for (const char* key : {"contacts", "a_c", "theta_c_deg", "a_c_noise", "sectors"})
    if (fabric.contains(key)) out[source][key] = fabric[key];
}

Numbers orientations_of(const texture::Texture& film, const texture::Texture* simulation) {
  Numbers out = Numbers::tree();
  add_orientations(out, "film", film);
  if (simulation && !out.empty()) add_orientations(out, "simulation", *simulation);
  return out;
}

Numbers film_of(const FilmResult& r) {
  return {{"format", r.film.format},
          {"camera", r.film.camera},
          {"width", described(r.film.width, "", "Pixels along x")},
          {"height", described(r.film.height, "", "Pixels along y")},
          {"frames", described(r.film.frames, "", "Frames of the film")},
          {"frame_rate_Hz", described(r.film.frame_rate, "Hz", "Frame rate")},
          {"pixel_m", described(r.pixel, "m", "Side of a pixel on the sample")},
          {"bad_pixels", described(std::count(r.bad.begin(), r.bad.end(), std::uint8_t{1}), "", "Pixels replaced")}};
}

Numbers lockin_of(const FilmResult& r) {
  const LockinMaps& m = r.maps;
  Numbers j = lockin_numbers(m, "K");
  put(j, "standard_error_K", median_of_finite(m.standard_error), "K", "Median standard error of a pixel's amplitude");
  put(j, "residual_K", median_of_finite(m.residual), "K", "Median residual of the fit in a pixel");
  if (!m.second_harmonic.empty())
    put(j, "second_harmonic_K", median_of_finite(m.second_harmonic), "K", "Median amplitude at twice the frequency");
  return j;
}

Numbers grains_of(const FilmResult& r) {
  Numbers j{{"all", described(r.packing.grains.size(), "", "Grains found")}};
  for (std::size_t m = 0; m < r.packing.materials.size(); ++m)
    j[r.packing.materials[m].name] = described(
        std::ranges::count(r.packing.grains.material, static_cast<std::int32_t>(m)), "", "Grains of this material");
  if (!r.grains.position_error.empty())
    put(j, "position_error_pixels", median(r.grains.position_error, statistics::unknown), "pixels",
        "Median standard error of a grain's position");
  return j;
}

Numbers motion_of(const FilmResult& r) {
  std::vector<double> travel, error;
  for (std::size_t i = 0; i < r.motion.size(); ++i) {
    travel.push_back(r.motion.travel(i));
    error.push_back(thermography::error_of_way(r.motion, i));
  }
  Numbers j = Numbers::tree();
  if (travel.empty()) return j;
  put(j, "median_travel_pixels", median(travel, statistics::unknown), "pixels",
      "Median displacement of a grain, peak to peak");
  put(j, "largest_travel_pixels", *std::max_element(travel.begin(), travel.end()), "pixels",
      "Largest displacement of a grain, peak to peak");
  put(j, "standard_error_pixels", median(error, statistics::unknown), "pixels",
      "Median standard error of the displacement, peak to peak");
  return j;
}

Numbers forces_of(const FilmResult& r) {
  const Contacts& contacts = r.packing.contacts;
  if (contacts.size() == 0) return Numbers::tree();
  const texture::ForceLevel level = texture::force_level(r.packing, r.fit.present_error);
  Numbers j{{"proposed", described(r.fit.proposed, "", "Contacts proposed by distance")},
            {"present", described(contacts.size(), "", "Contacts present according to their forces")},
            {"between_grains", described(level.contacts, "", "Of these, contacts between grains")}};
  put(j, "present_error", r.fit.present_error, "", "Standard error of the number of contacts present");
  if (level.contacts > 1) {
    put(j, "mean_N", level.mean, "N", "Mean normal force between grains, peak to peak");
    put(j, "fraction_above_mean", level.above_mean, "", "Fraction of contacts above the mean force");
  }
  put(j, "fn_error_N", median(r.fn_error, statistics::unknown), "N", "Median standard error of a normal force");
  put(j, "ft_error_N", median(r.ft_error, statistics::unknown), "N", "Median standard error of a tangential force");
  return j;
}

/// Where the rims show the container.
void add_walls(Numbers& j, const FilmResult& r) {
  const FilmWalls& w = r.walls;
  if (w.shift_error.x > 0)
    put(j["container"], "right_pixels", Estimate{w.shift.x / r.pixel, w.shift_error.x / r.pixel}, "pixels",
        "Shift of the container to the right, from the recipe's");
  if (w.shift_error.y > 0)
    put(j["container"], "up_pixels", Estimate{w.shift.y / r.pixel, w.shift_error.y / r.pixel}, "pixels",
        "Shift of the container upwards, from the recipe's");
}

/// How forces, film and load agree.
Numbers checks_of(const FilmResult& r) {
  Numbers j = Numbers::tree();
  const ForceFit& fit = r.fit;
  if (fit.over_noise > 0) {
    put(j, "misfit_over_noise", fit.over_noise, "", "Residual of the force fit in a pixel over its noise");
    put(j, "misfit_over_signal", fit.over_signal, "", "The same over the signal");
    put(j, "field_error_that_agrees", fit.model_error, "",
        "Relative model error of the grains' fields that would explain the misfit");
  }
  if (r.halo.share > 0) {
    put(j["halo"], "share", Estimate{r.halo.share, r.halo.error}, "",
        "Fraction of the light that is scattered over many pixels; it was removed");
    put(j["halo"], "width_pixels", r.halo.width, "pixels", "Standard deviation of the scattered light");
    put(j["halo"], "cost", r.halo.cost, "",
        "Root mean square change of the grain stresses by its removal, over the mean stress");
  }
  add_walls(j, r);
  if (fit.factor_scatter > 0)
    put(j, "factor_scatter", fit.factor_scatter, "",
        "Relative scatter of the thermoelastic factors of single grains of a material");
  if (r.rim_blur > 0) put(j, "blur_of_rims_pixels", r.rim_blur, "pixels", "Blur seen at the rims of grains");
  if (fit.shift_error > 0)
    put(j, "common_shift_K", Estimate{fit.shift, fit.shift_error}, "K",
        "Shift of all pixels by the noise that they share, as the balance of forces shows it, peak to peak");
  if (fit.load != 0) put(j, "load_by_forces_N", fit.load, "N", "Load from the forces on the walls, peak to peak");
  for (std::size_t m = 0; m < fit.factor_scale.size(); ++m)
    put(j["factor_scale"], r.packing.materials[m].name, Estimate{fit.factor_scale[m], fit.factor_scale_error[m]}, "",
        "Thermoelastic factor inferred from the film over the given one");
  j["doubts"] = r.doubts;
  return j;
}

bool knows_as_many(const std::vector<double>& a, const std::vector<double>& b) {
  const auto known = [](double stress) { return std::isfinite(stress); };
  return std::ranges::count_if(a, known) == std::ranges::count_if(b, known);
}

/// Of the film itself they are in its texture already, where no other source knows fewer grains.
Numbers statistics_of(const inference::GrainStresses& source, const FilmResult& r, const texture::Texture& texture) {
  if (source.source == "film" && knows_as_many(source.sigma_hyd, r.peak_to_peak.sigma_hyd))
    return texture.numbers.value("sigma_norm", Numbers::tree());
  return texture::stress_distribution(r.packing, source.sigma_hyd);
}

/// "stresses" by their source, and how the film's agree with those of the companion simulation.
void add_stresses(Numbers& j, const FilmResult& r, const texture::Texture& texture) {
  const inference::FilmStresses stresses = inference::film_stresses(r, texture.per_grain.considered);
  for (const inference::GrainStresses& s : stresses.sources) j["stresses"][s.source] = statistics_of(s, r, texture);
  if (stresses.sources.empty() || stresses.sources[0].source != "film") return;
  for (std::size_t k = 1; k < stresses.sources.size(); ++k)
    if (Numbers agreement = inference::agreement_of(r.packing, stresses, stresses.sources[k]); !agreement.empty())
      j["agreement"][stresses.sources[k].source] = std::move(agreement);
}

}  // namespace

texture::Texture texture_of(const FilmResult& film, bool rev) {
  texture::Options options;
  options.grain_sigma_hyd = film.peak_to_peak.sigma_hyd;
  if (!rev) options.rev.sizes = 0;
  return texture::measure(film.packing, options);
}

Numbers film_numbers(const FilmResult& r, const texture::Texture& texture, const texture::Texture* simulation) {
  Numbers j{{"film", film_of(r)},
            {"lockin", lockin_of(r)},
            {"grains", grains_of(r)},
            {"motion", motion_of(r)},
            {"forces", forces_of(r)}};
  if (r.fit.proposed > 0) j["checks"] = checks_of(r);
  if (auto orientations = orientations_of(texture, simulation); !orientations.empty())
    j["contact_orientations"] = std::move(orientations);
  if (r.peak_to_peak.size() == 0) return j;
  j["texture"] = texture::numbers(texture);
  add_stresses(j, r, texture);
  return j;
}

}  // namespace arenite::workflow
