#include "workflow/run_film.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/error.hpp"
#include "core/median.hpp"

namespace arenite::workflow {
namespace {

using statistics::described;
using statistics::Estimate;
using statistics::put;

/// Adds the contact orientations of one source under its name, where it has contacts.
void add_orientations(Numbers& out, const char* source, const texture::Texture& texture) {
  const Numbers measured = texture::numbers(texture, true);
  if (!measured.contains("fabric") || measured["fabric"].value("contacts", 0) == 0) return;
  for (const char* key : {"contacts", "a_c", "theta_c_deg", "a_c_noise", "sectors"})
    if (measured["fabric"].contains(key)) out[source][key] = measured["fabric"][key];
}

Numbers orientations_of(const FilmResult& film, const texture::Texture& texture, const Packing* simulation) {
  Numbers out = Numbers::tree();
  if (film.packing.contacts.size() == 0) return out;
  add_orientations(out, "film", texture);
  if (simulation) add_orientations(out, "simulation", texture::measure(*simulation, {.rev_sizes = 0}));
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
          {"bad_pixels", described(std::count(r.bad.begin(), r.bad.end(), std::uint8_t{1}), "", "Pixels that were replaced")}};
}

Numbers lockin_of(const FilmResult& r) {
  const LockinMaps& m = r.maps;
  Numbers j{{"convention", name_of(m.convention)}, {"frames", described(m.frames, "", "Frames of whole cycles")}};
  put(j, "frequency_Hz", Estimate{m.frequency, m.frequency_error}, "Hz", "Frequency of the load");
  put(j, "reference_phase_deg", m.reference_phase * 180 / std::numbers::pi, "deg", "Phase of the load at the first frame");
  put(j, "standard_error_K", median_of_finite(m.standard_error), "K", "Median standard error of a pixel's amplitude");
  put(j, "residual_K", median_of_finite(m.residual), "K", "Median residual of the fit in a pixel");
  if (!m.second_harmonic.empty()) put(j, "second_harmonic_K", median_of_finite(m.second_harmonic), "K", "Median amplitude at twice the frequency");
  return j;
}

Numbers grains_of(const FilmResult& r) {
  Numbers j{{"all", described(r.packing.grains.size(), "", "Grains that were found")}};
  for (std::size_t m = 0; m < r.packing.materials.size(); ++m)
    j[r.packing.materials[m].name] = std::count(r.packing.grains.material.begin(), r.packing.grains.material.end(), static_cast<std::int32_t>(m));
  if (!r.grains.position_error.empty())
    put(j, "position_error_pixels", median(r.grains.position_error, statistics::unknown), "pixels", "Median standard error of a grain's position");
  return j;
}

Numbers motion_of(const FilmResult& r) {
  std::vector<double> travel;
  for (std::size_t i = 0; i < r.motion.size(); ++i) {
    const Vec2 c = r.motion.cosine[i], s = r.motion.sine[i];
    travel.push_back(2 * std::hypot(c.x, s.x, std::hypot(c.y, s.y)));
  }
  Numbers j = Numbers::tree();
  if (travel.empty()) return j;
  put(j, "median_travel_pixels", median(travel, statistics::unknown), "pixels", "Median travel of a grain, peak to peak");
  put(j, "largest_travel_pixels", *std::max_element(travel.begin(), travel.end()), "pixels", "Largest travel of a grain, peak to peak");
  put(j, "standard_error_pixels", median(r.motion.error, statistics::unknown), "pixels", "Median standard error of the travel");
  return j;
}

Numbers forces_of(const FilmResult& r) {
  const Contacts& contacts = r.packing.contacts;
  if (contacts.size() == 0) return Numbers::tree();
  std::vector<double> between;
  for (std::size_t c = 0; c < contacts.size(); ++c)
    if (!contacts.is_wall(c)) between.push_back(contacts.fn[c]);
  const auto n = static_cast<double>(between.size());
  double mean = 0, squares = 0;
  for (const double f : between) mean += f / n;
  for (const double f : between) squares += (f - mean) * (f - mean);
  const auto above = static_cast<double>(std::count_if(between.begin(), between.end(), [&](double f) { return f > mean; }));
  Numbers j{{"proposed", described(r.fit.proposed, "", "Contacts proposed by distance")},
            {"present", described(contacts.size(), "", "Contacts present according to their forces")},
            {"between_grains", described(between.size(), "", "Of these, contacts between grains")}};
  put(j, "present_error", r.fit.present_error, "", "Standard error of the number of contacts present");
  if (between.size() > 1) {
    // Of the sample's contacts, and of how many there are: one more or less of those that carry next to nothing.
    const double spread = std::sqrt(squares / (n - 1) / n), counted = mean * r.fit.present_error / n;
    put(j, "mean_N", Estimate{mean, std::hypot(spread, counted)}, "N", "Mean normal force between grains, peak to peak");
    put(j, "fraction_above_mean", Estimate{above / n, std::sqrt(above * (n - above) / n) / n}, "", "Share of contacts above the mean force");
  }
  put(j, "fn_error_N", median(r.fn_error, statistics::unknown), "N", "Median standard error of a normal force");
  put(j, "ft_error_N", median(r.ft_error, statistics::unknown), "N", "Median standard error of a tangential force");
  return j;
}

/// How forces, film and load agree.
Numbers checks_of(const FilmResult& r) {
  Numbers j = Numbers::tree();
  const ForceFit& fit = r.fit;
  if (fit.over_noise > 0) {
    put(j, "misfit_over_noise", fit.over_noise, "", "What the fit of forces leaves in a pixel over its noise");
    put(j, "misfit_over_signal", fit.over_signal, "", "The same over the signal");
    put(j, "field_error_that_agrees", fit.model_error, "", "Relative model error of the grains' fields that would explain the misfit");
  }
  if (r.rim_blur > 0) put(j, "blur_of_rims_pixels", r.rim_blur, "pixels", "Blur that the rims of grains show");
  if (fit.load != 0) put(j, "load_by_forces_N", fit.load, "N", "Load as the forces on the walls have it, peak to peak");
  for (std::size_t m = 0; m < fit.factor_scale.size(); ++m)
    put(j["factor_scale"], r.packing.materials[m].name, Estimate{fit.factor_scale[m], fit.factor_scale_error[m]}, "",
        "Thermoelastic factor that the film asks for over the one given");
  j["doubts"] = r.doubts;
  return j;
}

Numbers agreement_of(const FilmResult& r, const std::vector<double>& simulation, const std::vector<std::uint8_t>& considered) {
  Numbers j = Numbers::tree();
  const auto add = [&](const std::string& name, const std::vector<std::uint8_t>& counts) {
    const Agreement a = agreement(r.peak_to_peak.sigma_hyd, simulation, counts);
    if (a.grains < 3) return;
    j[name] = {{"grains", described(a.grains, "", "Grains that are compared")},
               {"correlation", described(a.correlation, "", "Pearson's correlation of the grains' stresses, film and simulation")},
               {"rms_sigma_norm", described(a.rms_sigma_norm, "", "Root mean square difference of the stresses, each over its mean")},
               {"slope", described(a.slope, "", "Slope of film on simulation, through the origin")}};
  };
  add("all", considered);
  for (std::size_t m = 0; m < r.packing.materials.size(); ++m) {
    auto counts = considered;
    for (std::size_t i = 0; i < counts.size(); ++i) counts[i] = counts[i] && r.packing.grains.material[i] == static_cast<std::int32_t>(m);
    add(r.packing.materials[m].name, counts);
  }
  return j;
}

/// Grains with a finite stress in every source.
std::vector<std::int32_t> known_in_all(const std::vector<GrainStresses>& sources, std::size_t grains) {
  std::vector<std::int32_t> known;
  for (std::size_t g = 0; g < grains; ++g)
    if (std::all_of(sources.begin(), sources.end(), [&](const GrainStresses& s) { return std::isfinite(s.sigma_hyd[g]); }))
      known.push_back(static_cast<std::int32_t>(g));
  return known;
}

texture::Texture measured(const Packing& packing, texture::Options options) {
  options.rev_sizes = options.rev_places = 1;  // the packing's own tab shows these
  auto texture = texture::measure(packing, options);
  if (texture.considered_grains > 0 || options.border == 0) return texture;
  options.border = 0;
  return texture::measure(packing, options);
}

/// Fills in what follows from sigma_hyd of the known grains, and which of them count.
void normalise(GrainStresses& source, const Packing& packing, const std::vector<std::int32_t>& known, texture::Options options,
               std::vector<std::uint8_t>& considered) {
  options.grain_sigma_hyd.clear();
  for (const std::int32_t g : known) options.grain_sigma_hyd.push_back(source.sigma_hyd[g]);
  source.sigma_hyd.assign(source.sigma_hyd.size(), statistics::unknown);
  source.sigma_norm = source.sigma_hyd;
  source.statistics = Numbers::tree();
  if (known.empty()) return;
  const texture::Texture texture = measured(packing, options);
  double sum = 0;
  std::size_t count = 0;
  for (std::size_t k = 0; k < known.size(); ++k) {
    const auto g = static_cast<std::size_t>(known[k]);
    source.sigma_hyd[g] = options.grain_sigma_hyd[k];
    source.sigma_norm[g] = texture.per_grain.sigma_norm[k];
    considered[g] = texture.per_grain.considered[k];
    if (considered[g]) sum += source.sigma_hyd[g], ++count;
  }
  if (count > 0) source.mean = sum / static_cast<double>(count);
  const Numbers numbers = texture::numbers(texture, true);
  if (numbers.contains("sigma_norm")) source.statistics = numbers["sigma_norm"];
}

}  // namespace

texture::Texture texture_of(const FilmResult& film) { return texture::measure(film.packing, {.rev_sizes = 0, .grain_sigma_hyd = film.peak_to_peak.sigma_hyd}); }

Numbers film_orientations(const FilmResult& film, const Packing* simulation) { return orientations_of(film, texture_of(film), simulation); }

Agreement agreement(const std::vector<double>& one, const std::vector<double>& other, const std::vector<std::uint8_t>& counts) {
  std::vector<double> a, b;
  for (std::size_t i = 0; i < one.size(); ++i) {
    if (!counts[i] || !std::isfinite(one[i]) || !std::isfinite(other[i])) continue;
    a.push_back(one[i]);
    b.push_back(other[i]);
  }
  if (a.size() < 2) return {a.size()};
  double mean_a = 0, mean_b = 0, ab = 0, bb = 0, square = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    mean_a += a[i] / static_cast<double>(a.size());
    mean_b += b[i] / static_cast<double>(a.size());
    ab += a[i] * b[i];
    bb += b[i] * b[i];
  }
  for (std::size_t i = 0; i < a.size(); ++i) square += std::pow(a[i] / mean_a - b[i] / mean_b, 2);
  return {a.size(), statistics::pearson(a, b), std::sqrt(square / static_cast<double>(a.size())), ab / bb};
}

Numbers film_numbers(const FilmResult& r, const Packing* simulation) {
  Numbers j{{"film", film_of(r)}, {"lockin", lockin_of(r)}, {"grains", grains_of(r)}, {"motion", motion_of(r)}, {"forces", forces_of(r)}};
  if (r.fit.proposed > 0) j["checks"] = checks_of(r);
  if (r.packing.contacts.size() == 0 && r.peak_to_peak.size() == 0) return j;
  const texture::Texture texture = texture_of(r);
  if (auto orientations = orientations_of(r, texture, simulation); !orientations.empty()) j["contact_orientations"] = std::move(orientations);
  if (r.peak_to_peak.size() == 0) return j;
  j["texture"] = texture::numbers(texture);
  if (!r.simulation.empty())
    j["simulation"] = {{"peak_to_peak", agreement_of(r, r.simulation.peak_to_peak, texture.per_grain.considered)},
                       {"state", agreement_of(r, r.simulation.state, texture.per_grain.considered)}};
  return j;
}

FilmStresses film_stresses(const FilmResult& result, const texture::Options& options) {
  FilmStresses out;
  const std::size_t grains = result.packing.grains.size();
  const auto add = [&](const char* name, const std::vector<double>& values) {
    if (grains > 0 && values.size() == grains) out.sources.push_back({name, values, {}, statistics::unknown, {}});
  };
  add("film", result.peak_to_peak.sigma_hyd);
  add("simulation_peak_to_peak", result.simulation.peak_to_peak);
  add("simulation_state", result.simulation.state);
  if (out.sources.empty()) return out;
  const auto known = known_in_all(out.sources, grains);
  const Packing packing{result.packing.materials, result.packing.domain, picked(result.packing.grains, known), {}, {}, {}};  // without contacts and bonds
  out.considered.assign(grains, 0);
  for (GrainStresses& source : out.sources) normalise(source, packing, known, options, out.considered);
  return out;
}

std::vector<StressRelation> stress_relations(const Packing& packing, const GrainStresses& film, const GrainStresses& simulation) {
  std::vector<StressRelation> all;
  const auto add = [&](const std::string& name, int material) {
    std::vector<double> x, y;
    double squares = 0, squares_norm = 0;
    for (std::size_t g = 0; g < film.sigma_hyd.size(); ++g) {
      if ((material >= 0 && packing.grains.material[g] != material) || !std::isfinite(film.sigma_hyd[g]) || !std::isfinite(simulation.sigma_hyd[g])) continue;
      x.push_back(simulation.sigma_hyd[g]);
      y.push_back(film.sigma_hyd[g]);
      squares += std::pow(film.sigma_hyd[g] - simulation.sigma_hyd[g], 2);
      squares_norm += std::pow(film.sigma_norm[g] - simulation.sigma_norm[g], 2);
    }
    const auto count = static_cast<double>(x.size());
    if (x.size() >= 3) all.push_back({name, statistics::relate(x, y), std::sqrt(squares / count), std::sqrt(squares_norm / count)});
  };
  add("all", -1);
  if (packing.materials.size() > 1)
    for (std::size_t m = 0; m < packing.materials.size(); ++m) add(packing.materials[m].name, static_cast<int>(m));
  return all;
}

}  // namespace arenite::workflow
