#include "report/film_document.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "core/mapped.hpp"
#include "model/film_place.hpp"
#include "model/grain_motion.hpp"
#include "model/lockin_maps.hpp"
#include "report/colour_ends.hpp"
#include "report/figures/film_figures.hpp"
#include "report/figures/headlines.hpp"
#include "report/figures/state_numbers.hpp"
#include "report/packing_layers.hpp"
#include "report/page_document.hpp"
#include "statistics/correlation.hpp"
#include "thermal/inference/film_fit.hpp"
#include "thermal/inference/film_maps.hpp"
#include "thermal/inference/film_stresses.hpp"
#include "thermal/inference/force_certainty.hpp"

namespace arenite::report {
namespace {

/// The steps of the maps' codes over their middle half width: noise does not deflate, so maps of nothing else have
/// coarse ones; a phase comes to a tenth of a degree.
double steps_of(std::string_view map) {
  if (map == "picture") return 2000;
  if (map == "phase") return 1000;
  return map == "amplitude" || map == "in_phase" || map == "fitted" ? 500 : 125;
}

std::vector<std::uint32_t> places_of_ones(const std::vector<std::uint8_t>& marks) {
  std::vector<std::uint32_t> places;
  for (std::size_t k = 0; k < marks.size(); ++k)
    if (marks[k]) places.push_back(static_cast<std::uint32_t>(k));
  return places;
}

/// One map, rows from the top; where pixels have no value, "holes" lists them.
Numbers map_of(int width, int height, const std::vector<float>& values, double levels, NumberBlock& block) {
  const auto known = mapped<std::uint8_t>(values, [](float v) { return std::isfinite(v); });
  const auto holes = places_of_ones(mapped<std::uint8_t>(values, [](float v) { return !std::isfinite(v); }));
  Numbers out = numbers_of(code_field(width, height, {values.begin(), values.end()}, known, true, levels), block);
  if (!holes.empty()) out["holes"] = block.add_indices(holes);
  return out;
}

/// What is said of each map that the film has, and its values; a map with marks is drawn on the picture's.
Numbers maps_of(const FilmResult& r, NumberBlock& block) {
  Numbers all = Numbers::tree();
  for (const inference::FilmMap& map : inference::film_maps()) {
    const std::vector<float> values = inference::values_of(map, r);
    if (values.empty()) continue;
    Numbers& one = all[map.id];
    one = inference::words_of(map, r);
    one["ends"] = numbers_of(ends_of({values.begin(), values.end()}, pixels_beyond));
    if (map.marks_bad) one["on"] = "picture";
    else one.update(map_of(r.film.width, r.film.height, values, steps_of(map.id), block));
  }
  return all;
}

Numbers film_of(const FilmResult& r) {
  const FilmInfo& f = r.film;
  return {{"width", f.width},
          {"height", f.height},
          {"frames", f.frames},
          {"frame_rate", f.frame_rate},
          {"integration", f.integration},
          {"format", f.format},
          {"camera", f.camera},
          {"unit", inference::unit_in(f, "K")},
          {"pixel", r.pixel},
          {"used", r.maps.frames},
          {"frequency", r.maps.frequency},
          {"frequency_error", r.maps.frequency_error},
          {"convention", name_of(r.maps.convention)}};
}

/// Circles where the maps show the grains: from their places in metres, with the errors that they were found with.
PictureGrains circles_of(const FilmResult& r) {
  const Grains& grains = r.packing.grains;
  if (!(r.pixel > 0)) return r.grains;
  PictureGrains out = r.grains.size() == grains.size() ? r.grains : PictureGrains{};
  out.centre.clear(), out.radius.clear();
  const FilmPlace place{r.origin, r.pixel};
  for (std::size_t g = 0; g < grains.size(); ++g) {
    out.centre.push_back(place.pixels(grains.position[g]));
    out.radius.push_back(grains.radius[g] / r.pixel);
  }
  return out;
}

/// Way of each grain from the smallest to the largest load along one axis, pixels.
std::vector<double> way(const GrainMotion& motion, double phase, double Vec2::*axis) {
  std::vector<double> out;
  for (std::size_t g = 0; g < motion.size(); ++g) out.push_back(motion.way(g, phase).*axis);
  return out;
}

Numbers grains_of(const FilmResult& r, const inference::FilmStresses& stresses, NumberBlock& block) {
  const Grains& grains = r.packing.grains;
  const PictureGrains circles = circles_of(r);
  Numbers out{{"count", circles.size() == grains.size() ? grains.size() : 0}};
  const auto reals = [&](const char* name, const std::vector<double>& values, const std::string& unit) {
    if (!values.empty() && values.size() == grains.size()) out[name] = block.add_reals(values, unit);
  };
  out["id"] = block.add_integers(std::vector<std::int32_t>(grains.id.begin(), grains.id.end()));
  out["material"] = block.add_indices(grains.material);
  reals("x", mapped(circles.centre, &Vec2::x), "px");
  reals("y", mapped(circles.centre, &Vec2::y), "px");
  reals("radius", circles.radius, "px");
  out["mean_radius"] = statistics::mean_of_known(circles.radius);
  reals("position_error", circles.position_error, "px");
  reals("radius_error", circles.radius_error, "px");
  reals("temperature", r.peak_to_peak.temperature, inference::unit_in(r.film, "K"));
  reals("sigma_hyd", r.peak_to_peak.sigma_hyd, "Pa");
  reals("error", r.peak_to_peak.error, "Pa");
  reals("motion_x", way(r.motion, r.maps.reference_phase, &Vec2::x), "px");
  reals("motion_y", way(r.motion, r.maps.reference_phase, &Vec2::y), "px");
  reals("motion_error", r.motion.error, "px");
  if (!stresses.considered.empty()) out["considered"] = block.add_indices(stresses.considered);
  return out;
}

Numbers contacts_of(const FilmResult& r, NumberBlock& block) {
  const Contacts& contacts = r.packing.contacts;
  Numbers out = pairs_of(r.packing, block);
  out["count"] = contacts.size();
  add_columns(out, contacts, io::contact_columns, {"nx", "ny", "fn", "ft"}, block);
  for (const auto& [name, values, unit] :
       {std::tuple{"fn_error", &r.fn_error, "N"}, {"ft_error", &r.ft_error, "N"}, {"presence", &r.presence, ""}})
    if (values->size() == contacts.size()) out[name] = block.add_reals(*values, unit);
  if (const auto ratios = inference::forces_over_errors(r); !ratios.empty())
    out["over_error"] = block.add_reals(ratios);
  out["may_be_absent"] = block.add_indices(inference::doubtful_contacts(r));
  return out;
}

/// What the film shows, what the forces make of it and the difference, in the pixels that have both: the map that each
/// is of, by which factor, so that all are peak to peak, and its root mean square. Nothing without forces.
Numbers fit_of(const FilmResult& r) {
  const inference::FitMaps maps = inference::fit_maps(r);
  if (maps.residual.empty()) return Numbers::tree();
  const auto said = [](std::string_view id) {
    return *std::ranges::find(inference::film_maps(), id, &inference::FilmMap::id);
  };
  const auto picture = [&](std::string_view label, std::string_view map, double factor, const auto& values) {
    return Numbers{{"label", std::string(label)},
                   {"map", std::string(map)},
                   {"factor", factor},
                   {"rms", inference::root_mean_square(values)}};
  };
  return {
      {"title", std::string(said("in_phase").title)},
      {"ends", numbers_of(ends_of({maps.measured.begin(), maps.measured.end()}, pixels_beyond))},
      {"pictures", Numbers::list({picture("Measured", "in_phase", to_peak_to_peak(r.maps.convention), maps.measured),
                                  picture(said("fitted").label, "fitted", 1, maps.fitted),
                                  picture(said("fit_residual").label, "fit_residual", 1, maps.residual)})}};
}

/// The container's inner sides in pixels: left, right, bottom, top; y down.
Numbers container_of(const FilmResult& r) {
  const Domain& domain = r.packing.domain;
  if (!(r.pixel > 0) || !(domain.area() > 0)) return nullptr;
  const FilmPlace place{r.origin, r.pixel};
  const Vec2 low = place.pixels(domain.corner()), high = place.pixels(domain.corner() + domain.size());
  return {low.x, high.x, low.y, high.y};
}

Numbers stresses_of(const inference::FilmStresses& stresses, NumberBlock& block) {
  Numbers all = Numbers::tree();
  for (const inference::GrainStresses& s : stresses.sources)
    all[s.source] = {{"name", figures::name_of_source(s.source)},
                     {"mean", s.mean},
                     {"sigma_hyd", block.add_reals(s.sigma_hyd, "Pa")},
                     {"sigma_norm", block.add_reals(s.sigma_norm)}};
  return all;
}

/// What stands over and under the tables of these stresses.
Numbers comparison_of(const inference::FilmStresses& stresses) {
  return {
      {"title", stresses.sources.size() > 1 ? "Experiment and simulation" : "Stress of grains"},
      {"caption",
       "Grains away from the border; \u03c3_{norm} of each set is over its own mean. Agreement: correlation, slope of "
       "the film on the simulation, r.m.s. difference."}};
}

Numbers one_film(const FilmResult& r, const texture::Texture* texture, NumberBlock& block,
                 const figures::WriteList& write) {
  const inference::FilmStresses stresses =
      texture ? inference::film_stresses(r, texture->per_grain.considered) : inference::FilmStresses{};
  Numbers out{{"name", r.name},
              {"converged", r.converged},
              {"outcome", r.outcome},
              {"provenance", provenance_of(r.provenance)},
              {"film", film_of(r)},
              {"maps", maps_of(r, block)},
              {"faint_below", inference::faint_below},
              {"bad", block.add_indices(places_of_ones(r.bad))},
              {"materials", materials_of(r.packing.materials)},
              {"grains", grains_of(r, stresses, block)},
              {"contacts", contacts_of(r, block)},
              {"force_scale", numbers_of(figures::force_scale(r))},
              {"fit", fit_of(r)},
              {"container", container_of(r)},
              {"stresses", stresses_of(stresses, block)},
              {"comparison", comparison_of(stresses)},
              {"headlines", figures::numbers_of(figures::headlines_of(r))},
              {"figures", shortened(figures::numbers_of(figures::film_figures(), {r, stresses}, write))}};
  Numbers numbers = r.numbers;
  erase(numbers, Trait::curve);
  add_numbers(out, numbers);
  for (auto&& [name, meaning] : out["meanings"].items())
    meaning[0] = inference::unit_in(r.film, meaning[0].get<std::string>());
  return out;
}

}  // namespace

void add_film(Numbers& document, const FilmResult& film, const texture::Texture* texture, NumberBlock& block,
              const figures::WriteList& write) {
  document["films"].push_back(one_film(film, texture, block, write));
}

}  // namespace arenite::report
