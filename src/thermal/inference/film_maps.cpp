#include "thermal/inference/film_maps.hpp"

#include <algorithm>
#include <cstdint>
#include <numbers>

#include "core/mapped.hpp"
#include "model/lockin_maps.hpp"
#include "thermal/inference/film_fit.hpp"
#include "thermal/thermography/lockin.hpp"

namespace arenite::inference {
namespace {

using MapPixels = std::vector<float>;

template <MapPixels LockinMaps::*member> MapPixels of_lockin(const FilmResult& film) { return film.maps.*member; }

MapPixels degrees_after_load(const FilmResult& film) {
  return mapped(thermography::phase_after_load(film.maps),
                [](float phase) { return static_cast<float>(phase * 180 / std::numbers::pi); });
}

}  // namespace

const std::vector<FilmMap>& film_maps() {
  using enum ColourScale;
  const auto picture = [](const FilmResult& film) { return film.picture; };
  static const std::vector<FilmMap> list{
      {.id = "picture",
       .label = "Picture",
       .title = "Image at the smallest load",
       .unit = "K",
       .colours = grey,
       .values = picture},
      {.id = "amplitude",
       .label = "Amplitude",
       .title = "Amplitude",
       .unit = "K",
       .colours = stress,
       .has_convention = true,
       .values = of_lockin<&LockinMaps::amplitude>},
      {.id = "phase",
       .label = "Phase",
       .title = "Phase relative to the load, \u00b0",
       .colours = cyclic,
       .values = degrees_after_load},
      {.id = "in_phase",
       .label = "Signed",
       .title = "Warming with the load",
       .unit = "K",
       .colours = diverging,
       .has_convention = true,
       .values = of_lockin<&LockinMaps::in_phase>},
      {.id = "fitted",
       .label = "From forces",
       .title = "Warming predicted from the contact forces (peak to peak)",
       .unit = "K",
       .colours = diverging,
       .values = [](const FilmResult& film) { return film.fit.picture; }},
      {.id = "fit_residual",
       .label = "Misfit",
       .title = "Warming beyond that predicted from the contact forces (peak to peak)",
       .unit = "K",
       .colours = diverging,
       .values = [](const FilmResult& film) { return fit_maps(film).residual; }},
      {.id = "second_harmonic",
       .label = "2\u2009f",
       .title = "Amplitude at twice the frequency",
       .unit = "K",
       .colours = stress,
       .values = of_lockin<&LockinMaps::second_harmonic>},
      {.id = "standard_error",
       .label = "Noise",
       .title = "Standard error of the signed amplitude",
       .unit = "K",
       .values = of_lockin<&LockinMaps::standard_error>},
      {.id = "residual",
       .label = "Residual",
       .title = "Residual of the fit (r.m.s.)",
       .unit = "K",
       .values = of_lockin<&LockinMaps::residual>},
      {.id = "bad",
       .label = "Bad pixels",
       .title = "Image at the smallest load",
       .unit = "K",
       .colours = grey,
       .marks_bad = true,
       .values = picture}};
  return list;
}

std::string title_of(const FilmMap& map, const FilmResult& film) {
  const std::string title(map.title);
  if (!map.has_convention) return title;
  const bool whole = film.maps.convention == AmplitudeConvention::peak_to_peak;
  return title + (whole ? " (peak to peak)" : " (half of peak to peak)");
}

std::vector<float> values_of(const FilmMap& map, const FilmResult& film) {
  const std::size_t pixels = film.film.pixels();
  if (pixels == 0 || (map.marks_bad && std::ranges::none_of(film.bad, [](auto mark) { return mark != 0; }))) return {};
  std::vector<float> values = map.values(film);
  return values.size() == pixels ? values : std::vector<float>{};
}

std::string unit_in(const FilmInfo& film, std::string_view unit) {
  return std::string(unit == "K" && film.quantity == FilmQuantity::digital_level ? "DL" : unit);
}

Numbers words_of(const FilmMap& map, const FilmResult& film) {
  return {{"label", std::string(map.label)},
          {"title", title_of(map, film)},
          {"unit", unit_in(film.film, map.unit)},
          {"colours", std::string(word_of(map.colours))},
          {"around", map.colours == ColourScale::diverging ? "zero" : "ends"},
          {"cyclic", map.colours == ColourScale::cyclic},
          {"marks", map.marks_bad}};
}

}  // namespace arenite::inference
