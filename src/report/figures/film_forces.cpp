#include "report/figures/film_forces.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <numeric>
#include <tuple>
#include <utility>

#include "core/mapped.hpp"
#include "thermal/inference/film_fit.hpp"

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

Bins certainty_bins(std::vector<double> ratios) {
  std::ranges::sort(ratios);
  const double high = std::max(4.0, ratios[static_cast<std::size_t>(0.98 * static_cast<double>(ratios.size() - 1))]),
               low = std::min(0.0, std::max(-6.0, ratios.front()));
  constexpr double most_bars = 36;
  double step = 0.5;
  for (int k = 0; (high - low) / step > most_bars; ++k) step *= k % 3 == 1 ? 2.5 : 2;
  const double first = std::floor(low / step);
  return {first * step, step, static_cast<int>(std::ceil(high / step) - first)};
}

/// Normal forces over their standard errors.
Drawings certainty(const FilmData& data) {
  const FilmResult& film = data.result;
  if (!has_forces(film)) return {};
  const std::vector<double> all = inference::forces_over_errors(film);
  std::vector<double> ratios;
  std::ranges::copy_if(all, std::back_inserter(ratios), [](double ratio) { return std::isfinite(ratio); });
  if (ratios.empty()) return {};
  const Bins bins = certainty_bins(ratios);
  const auto n = static_cast<std::size_t>(bins.count);
  const std::vector<std::uint8_t> doubtful = inference::doubtful_contacts(film);
  std::vector<double> middle, base(n, 0.0);
  for (std::size_t b = 0; b < n; ++b) middle.push_back(bins.first + (static_cast<double>(b) + 0.5) * bins.step);
  Drawing drawing;
  Panel panel{{.label = "F_{n} / standard error", .brief = "F_{n} / s.e."}, {.label = "contacts", .low = 0}};
  for (const Kind& kind : kinds) {
    std::vector<double> counts(n, 0.0);
    for (std::size_t c = 0; c < all.size(); ++c) {
      const double ratio = all[c];
      if (!std::isfinite(ratio) || (doubtful[c] != 0) != kind.doubtful) continue;
      ++counts[static_cast<std::size_t>(
          std::clamp(std::floor((ratio - bins.first) / bins.step), 0.0, static_cast<double>(n - 1)))];
    }
    if (std::ranges::all_of(counts, [](double count) { return count == 0; })) continue;
    auto top = base;
    for (std::size_t b = 0; b < n; ++b) top[b] += counts[b];
    panel.series.push_back({.name = kind.name,
                            .colour = kind.colour,
                            .x = middle,
                            .y = counts,
                            .low = base,
                            .high = top,
                            .bars = 0.92 * bins.step,
                            .opacity = 0.75});
    const double whole = std::accumulate(counts.begin(), counts.end(), 0.0);
    drawing.key.push_back({counted(whole) + " " + kind.name, kind.colour});
    base = std::move(top);
  }
  const double end = bins.first + bins.count * bins.step;
  if (const auto beyond = std::ranges::count_if(ratios, [&](double r) { return r > end; }); beyond > 0)
    panel.corner.push_back(counted(static_cast<double>(beyond)) + " beyond " + rounded(end, 2) + " in the last bar");
  if (const auto below = std::ranges::count_if(ratios, [&](double r) { return r < bins.first; }); below > 0)
    panel.corner.push_back(counted(static_cast<double>(below)) + " below " + rounded(bins.first, 2) +
                           " in the first bar");
  constexpr double above_bars = 1.3;  // room for these words
  if (!panel.corner.empty()) panel.y.high = above_bars * largest_of(base, 1);
  panel.references = {{.x = 0, .line = Line::solid}};
  drawing.panels = {panel};
  return {drawing};
}

}  // namespace arenite::report::figures
