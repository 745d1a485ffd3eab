#include "report/figures/film_forces.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <tuple>
#include <utility>
#include <vector>

#include "core/mapped.hpp"
#include "thermal/inference/force_certainty.hpp"

namespace arenite::report::figures {
namespace {

struct Kind {
  bool doubtful;
  const char *name, *colour;
};
constexpr std::array<Kind, 2> kinds{{{false, "present", "strong"}, {true, "may be absent", "tension"}}};

bool has_forces(const FilmResult& film) {
  return std::ranges::any_of(film.packing.contacts.fn, [](double force) { return force != 0; });
}

}  // namespace

Drawings ranked_forces(const FilmData& data) {
  const FilmResult& film = data.result;
  const Contacts& contacts = film.packing.contacts;
  if (!has_forces(film)) return {};
  const std::vector<std::uint8_t> doubtful = inference::doubtful_contacts(film);
  std::vector<KeyEntry> key;
  for (const Kind& kind : kinds) {
    const auto count = std::ranges::count(doubtful, kind.doubtful ? 1 : 0);
    if (count > 0) key.push_back({counted(static_cast<double>(count)) + " " + kind.name, kind.colour});
  }
  Drawings drawings;
  for (const auto& [name, symbol, force, error] :
       {std::tuple{"fn", "F_{n}", &contacts.fn, &film.fn_error}, {"ft", "F_{t}", &contacts.ft, &film.ft_error}}) {
    if (force->empty()) continue;
    const Scale scale = scale_of(*force, "N");
    const auto order = ordered_by(force->size(), [&, force = force](std::size_t c) { return -(*force)[c]; });
    Panel panel{{.label = "rank", .low = 0, .high = static_cast<double>(force->size() + 1)},
                {.label = symbol, .unit = scale.unit}};
    for (const Kind& kind : kinds) {
      Series series{.name = kind.name,
                    .colour = kind.colour,
                    .points = true,
                    .weight = force->size() > 300 ? 0.5 : 0.8,
                    .each = "contact"};
      double rank = 0;
      for (const std::size_t c : order) {
        if (!std::isfinite((*force)[c])) continue;
        ++rank;
        if ((doubtful[c] != 0) != kind.doubtful) continue;
        series.x.push_back(rank);
        series.y.push_back((*force)[c] / scale.factor);
        series.error.push_back(c < error->size() ? (*error)[c] / scale.factor : statistics::unknown);
        series.members.push_back(static_cast<double>(c));
      }
      if (!series.x.empty()) panel.series.push_back(std::move(series));
    }
    panel.references = {{.y = 0, .line = Line::solid}};
    drawings.push_back({.chosen = {{"component", name}}, .panels = {panel}, .key = key});
  }
  return drawings;
}

/// Normal forces over their standard errors.
Drawings certainty(const FilmData& data) {
  if (!has_forces(data.result)) return {};
  const auto found = inference::force_certainty(data.result);
  if (!found) return {};
  const statistics::Bins& bins = found->bins;
  std::vector<double> middle, base(bins.count, 0.0);
  for (std::size_t b = 0; b < bins.count; ++b) middle.push_back(bins.centre(b));
  Drawing drawing;
  Panel panel{{.label = "F_{n} / standard error", .brief = "F_{n} / s.e."}, {.label = "contacts", .low = 0}};
  for (const Kind& kind : kinds) {
    const statistics::Counts& counts = found->there_and_doubtful[kind.doubtful ? 1 : 0];
    const double whole = statistics::total(counts);
    if (whole == 0) continue;
    auto top = base;
    for (std::size_t b = 0; b < bins.count; ++b) top[b] += counts[b];
    panel.series.push_back({.name = kind.name,
                            .colour = kind.colour,
                            .x = middle,
                            .y = counts,
                            .low = base,
                            .high = top,
                            .bars = 0.92 * bins.width,
                            .opacity = 0.75});
    drawing.key.push_back({counted(whole) + " " + kind.name, kind.colour});
    base = std::move(top);
  }
  const auto outside = [&](std::size_t count, const char* where, double edge, const char* bar) {
    if (count > 0)
      panel.corner.push_back(counted(static_cast<double>(count)) + where + rounded(edge, 2) + " in the " + bar +
                             " bar");
  };
  outside(found->beyond, " beyond ", bins.edge(bins.count), "last");
  outside(found->below, " below ", bins.low, "first");
  constexpr double above_bars = 1.3;  // room for these words
  if (!panel.corner.empty()) panel.y.high = above_bars * largest_of(base, 1);
  panel.references = {{.x = 0, .line = Line::solid}};
  drawing.panels = {panel};
  return {drawing};
}

}  // namespace arenite::report::figures
