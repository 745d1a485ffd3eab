#include "report/figures/film_figures.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>

#include "core/mapped.hpp"
#include "report/figures/distributions.hpp"
#include "report/figures/film_forces.hpp"
#include "report/figures/roses.hpp"
#include "report/figures/state_figures.hpp"

namespace arenite::report::figures {
namespace {

std::vector<std::string> names_of(const FilmResult& film) { return mapped(film.packing.materials, &Material::name); }

/// The sources of stresses, with their names and colours.
struct Source {
  const char *key, *name, *colour;
};
constexpr Source sources[] = {{"film", "film", "strong"},
                              {"simulation_peak_to_peak", "simulation, peak to peak", "accent"},
                              {"simulation_state", "simulation, largest load", "mixed 1"}};

const inference::GrainStresses* stresses_by(const FilmData& data, std::string_view source) {
  const auto at = std::ranges::find(data.stresses.sources, source, &inference::GrainStresses::source);
  return at == data.stresses.sources.end() ? nullptr : &*at;
}

double error_of(const FilmResult& film, std::size_t g) {
  return g < film.peak_to_peak.error.size() ? film.peak_to_peak.error[g] : statistics::unknown;
}

double id_of(const FilmResult& film, std::size_t g) { return static_cast<double>(film.packing.grains.id[g]); }

std::vector<KeyEntry> materials_key(const FilmResult& film) {
  std::vector<KeyEntry> key;
  for (const std::string& name : names_of(film)) key.push_back({name, colour_of_material(key.size())});
  return key;
}

/// Pressures of grains in order, by material.
Drawings ranked_stresses(const FilmData& data) {
  const FilmResult& film = data.result;
  const auto& sigma = film.peak_to_peak.sigma_hyd;
  const std::size_t grains = film.packing.grains.size();
  if (sigma.empty() || sigma.size() != grains) return {};
  const Scale scale = scale_of(sigma, "Pa");
  const auto order = ordered_by(grains, [&](std::size_t g) { return std::isfinite(sigma[g]) ? sigma[g] : 1e300; });
  Panel panel{{.label = "rank", .low = 0, .high = static_cast<double>(grains + 1)},
              {.label = "\u2212\u03c3_{hyd}", .unit = scale.unit}};
  const auto names = names_of(film);
  for (std::size_t m = 0; m < names.size(); ++m) {
    Series series{.name = names[m],
                  .colour = colour_of_material(m),
                  .points = true,
                  .weight = grains > 300 ? 0.5 : 0.7,
                  .each = "grain"};
    double rank = 0;
    for (const std::size_t g : order) {
      if (!std::isfinite(sigma[g])) continue;
      ++rank;
      if (static_cast<std::size_t>(film.packing.grains.material[g]) != m) continue;
      series.x.push_back(rank);
      series.y.push_back(-sigma[g] / scale.factor);
      series.error.push_back(error_of(film, g) / scale.factor);
      series.members.push_back(id_of(film, g));
    }
    if (!series.x.empty()) panel.series.push_back(std::move(series));
  }
  panel.references = {{.y = 0, .line = Line::solid}};
  return {{.panels = {panel}, .key = names.size() > 1 ? materials_key(film) : std::vector<KeyEntry>()}};
}

Drawings tails(const FilmData& data) {
  std::vector<Set> sets;
  for (const Source& source : sources) {
    const Numbers* of = data.result.numbers.at_path(std::string("/stresses/") + source.key);
    if (of && of->contains("cumulative") && estimate_at(*of, "/count").value > 1)
      sets.push_back({source.name, source.colour, of});
  }
  if (sets.empty()) return {};
  return {{.panels = {survival(sets, "\u03c3_{norm}", "P(\u03c3_{norm})", true)}, .key = tails_key(sets, "/P0")}};
}

Drawings orientations(const FilmData& data) {
  Drawing drawing;
  for (const auto& [name, colour] : {std::pair{"film", "strong"}, {"simulation", "accent"}}) {
    const Numbers* set = data.result.numbers.at_path(std::string("/contact_orientations/") + name);
    if (set && set->contains("sectors")) drawing.roses.push_back(rose_of(name, colour, *set));
  }
  if (drawing.roses.empty() || drawing.roses.front().name != "film") return {};
  double reach = 0;
  for (const Rose& rose : drawing.roses) reach = std::max(reach, rose.reach);
  for (Rose& rose : drawing.roses) rose.reach = reach;
  return {drawing};
}

/// Both over their means, or in pascal; pale grains do not count.
Drawing against(const FilmData& data, const inference::GrainStresses& own, const inference::GrainStresses& simulation,
                bool over_mean, const std::string& source) {
  const FilmResult& film = data.result;
  const Scale scale = over_mean ? Scale{} : scale_of(std::max(std::abs(own.mean), std::abs(simulation.mean)), "Pa");
  const auto value = [&](const inference::GrainStresses& of, std::size_t g) {
    return over_mean ? of.sigma_norm[g] : -of.sigma_hyd[g] / scale.factor;
  };
  const double unit = over_mean ? std::abs(own.mean) : scale.factor;
  const std::string symbol = over_mean ? "\u03c3_{norm}" : "\u2212\u03c3_{hyd}";
  Drawing drawing;
  Panel panel{{.label = "simulation, " + symbol, .unit = scale.unit}, {.label = "film, " + symbol, .unit = scale.unit}};
  double low = 0, high = 0;
  const auto names = names_of(film);
  for (const bool counts : {true, false})
    for (std::size_t m = 0; m < names.size(); ++m) {
      Series series{.name = names[m],
                    .colour = colour_of_material(m),
                    .points = true,
                    .weight = film.packing.grains.size() > 300 ? 0.6 : 0.85,
                    .opacity = counts ? 0.8 : 0.3,
                    .each = "grain"};
      for (std::size_t g = 0; g < film.packing.grains.size(); ++g) {
        const bool considered = g >= data.stresses.considered.size() || data.stresses.considered[g] != 0;
        const double x = value(simulation, g), y = value(own, g);
        if (static_cast<std::size_t>(film.packing.grains.material[g]) != m || considered != counts ||
            !std::isfinite(x) || !std::isfinite(y))
          continue;
        low = std::min({low, x, y}), high = std::max({high, x, y});
        series.x.push_back(x), series.y.push_back(y), series.error.push_back(error_of(film, g) / unit);
        series.members.push_back(id_of(film, g));
      }
      if (!series.x.empty()) panel.series.push_back(std::move(series));
    }
  high *= 1.04;
  panel.x.low = panel.y.low = low, panel.x.high = panel.y.high = high;
  panel.series.insert(panel.series.begin(),
                      {.colour = "fit", .x = {low, high}, .y = {low, high}, .line = Line::dashed, .is_read = false});
  panel.near = panel.square = true;
  drawing.key = materials_key(film);
  if (const Numbers* about = film.numbers.at_path("/agreement/" + source)) {
    for (KeyEntry& entry : drawing.key)
      if (const auto of = about->find(entry.name); of != about->end())
        if (const auto r = estimate_at(*of, "/correlation"); std::isfinite(r.value)) entry.numbers = {said("r", r)};
    if (const auto r = estimate_at(*about, "/all/correlation"); std::isfinite(r.value)) {
      const double rms = over_mean ? estimate_at(*about, "/all/rms_sigma_norm").value
                                   : estimate_at(*about, "/all/rms_Pa").value / scale.factor;
      panel.corner = {in_words(said("r", r)),
                      "r.m.s. difference " + rounded(rms, 2) + (scale.unit.empty() ? "" : "\u202f" + scale.unit)};
    }
  }
  drawing.panels = {std::move(panel)};
  return drawing;
}

Drawings against_simulation(const FilmData& data) {
  const auto* film = stresses_by(data, "film");
  Drawings drawings;
  for (const auto& [source, companion] :
       {std::pair{"simulation_peak_to_peak", "peak_to_peak"}, {"simulation_state", "state"}})
    for (const bool over_mean : {true, false})
      if (const auto* simulation = stresses_by(data, source); film && simulation) {
        drawings.push_back(against(data, *film, *simulation, over_mean, source));
        drawings.back().chosen = {{"companion", companion}, {"over", over_mean ? "mean" : "unit"}};
      }
  return drawings;
}

}  // namespace

std::string name_of_source(std::string_view source) {
  const auto* const at = std::ranges::find(sources, source, &Source::key);
  return at == std::end(sources) ? std::string(source) : at->name;
}

const std::vector<Row<FilmData>>& film_figures() {
  static const std::vector<Row<FilmData>> list{
      {{"film-simulation",
        "against-simulation",
        "Film against simulation",
        {"Every grain with the film\u2019s standard error, pale near the border; line: equality; r and the difference "
         "exclude the border.",
         "Largest load: includes the stress at the smallest load, which no film shows. On virtual films a simulation "
         "from positions alone reaches a correlation of about 0.4 to 0.5: individual contact forces depend on the "
         "friction history of filling and loading, and this history is lost."},
        false,
        {{"companion", "", {{"peak_to_peak", "Peak to peak"}, {"state", "Largest load"}}},
         {"over", "", {{"mean", "\u03c3_{norm}"}, {"unit", "Pa"}}, Choice::Print::first}}},
       against_simulation},
      {{"film-tails",
        "tails",
        "Tails of \u03c3_{norm}",
        {"P: survival function, the fraction of grains above \u03c3_{norm}, away from the border.",
         "Dashed: P_{0} exp[\u03b2(1 \u2212 \u03c3_{norm})], maximum likelihood."}},
       tails},
      {{"film-orientations",
        "contact-orientations",
        "Contact orientations",
        {"Fraction of contacts between grains in sectors of 10\u00b0, over the isotropic fraction (dashed circle), "
         "away from the border.",
         "Film: contacts whose force changes with the load; simulation: those at the largest load. Line: 1 + a_{c} cos "
         "2(\u03b8 \u2212 \u03b8_{c})."}},
       orientations},
      {{"film-forces",
        "forces",
        "Contact forces \u00b1 s.e.",
        {"Peak-to-peak forces, ranked, with one standard error on either side.",
         "May be absent: contacts that are present with a probability below 95\u202f%; about as many present contacts "
         "are missed."},
        true,
        {{"component", "", {{"fn", "F_{n}"}, {"ft", "F_{t}"}}}}},
       ranked_forces},
      {{"film-certainty", "certainty", "Signal-to-noise ratio of forces",
        "Number of contacts by F_{n} over its standard error; the last bar includes all larger values."},
       certainty},
      {{"film-stresses", "stresses", "Grain stresses \u00b1 s.e.",
        "Peak-to-peak pressure \u2212\u03c3_{hyd} of every grain, ranked, with one standard error on either side "
        "(pixel "
        "noise, position of the grain, lens blur, model)."},
       ranked_stresses}};
  return list;
}

}  // namespace arenite::report::figures
