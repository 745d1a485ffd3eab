#include "report/figures/distributions.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "statistics/tails.hpp"

namespace arenite::report::figures {
namespace {

double count_of(const Set& set) { return estimate_at(*set.of, "/count").value; }

statistics::Estimate share_of(const Set& set) {
  const auto share = estimate_at(*set.of, "/P0");
  return std::isfinite(share.value) ? share : estimate_at(*set.of, "/strong_share");
}

/// As far as the largest member of any set goes.
double end_of(const std::vector<Set>& sets) {
  double end = 2.5;
  for (const Set& set : sets) end = std::fmax(end, estimate_at(*set.of, "/maximum").value);
  return 1.03 * end;
}

}  // namespace

Panel survival(const std::vector<Set>& sets, const std::string& x, const std::string& y, bool logarithmic) {
  const double end = end_of(sets);
  double least = 1;
  for (const Set& set : sets) least = std::min(least, 0.7 / count_of(set));
  Panel panel{{.label = x, .low = 0, .high = end}, {.label = y, .low = 0, .high = 1}, {}};
  if (logarithmic)
    panel.y = {.label = y,
               .logarithmic = true,
               .low = std::min(least, std::pow(10, std::floor(std::log10(least) + 0.25))),
               .high = 1};
  for (const Set& set : sets)
    panel.series.push_back({.name = set.name,
                            .colour = set.colour,
                            .x = reals_at(*set.of, "/cumulative/x"),
                            .y = reals_at(*set.of, "/cumulative/y"),
                            .points = true,
                            .weight = 0.7});
  for (const Set& set : sets) {
    const statistics::FallBeyondMean tail{share_of(set).value, estimate_at(*set.of, "/beta").value};
    if (!tail.is_known()) continue;
    const double last = logarithmic ? std::min(end, tail.where(*panel.y.low)) : end;
    const auto [x_of_tail, y_of_tail] = sampled(
        1, last, [&](double v) { return tail.at(v); }, logarithmic ? 1 : 40);
    panel.series.push_back({.name = set.name,
                            .colour = set.colour,
                            .x = x_of_tail,
                            .y = y_of_tail,
                            .line = Line::dashed,
                            .is_read = false});
  }
  panel.references = {{.x = 1}};
  return panel;
}

std::vector<KeyEntry> tails_key(const std::vector<Set>& sets, const char* share) {
  std::vector<KeyEntry> key;
  for (const Set& set : sets) {
    KeyEntry entry{set.name, set.colour};
    for (const auto& [symbol, path] : {std::pair{"P_{0}", share}, {"\u03b2", "/beta"}})
      if (const auto number = estimate_at(*set.of, path); std::isfinite(number.value))
        entry.numbers.push_back(said(symbol, number));
    key.push_back(entry);
  }
  return key;
}

std::string colour_of_material(std::size_t place) { return "material " + std::to_string(place); }

std::string colour_of_pair(const std::string& key, const std::vector<std::string>& materials) {
  std::size_t mixed = 0;
  for (std::size_t a = 0; a < materials.size(); ++a)
    if (key == materials[a] + "-" + materials[a]) return colour_of_material(a);
  for (std::size_t a = 0; a < materials.size(); ++a)
    for (std::size_t b = a + 1; b < materials.size(); ++b, ++mixed)
      if (key == materials[a] + "-" + materials[b] || key == materials[b] + "-" + materials[a])
        return "mixed " + std::to_string(mixed);
  return "mixed 1";
}

namespace {

/// All, and the parts that have more than one member; of a single material it has no parts.
template <class Colour>
std::vector<Set> sets_of(const Numbers& all, const char* parts, const std::vector<std::string>& materials,
                         Colour colour) {
  std::vector<Set> sets{{"all", "strong", &all}};
  const auto found = all.find(parts);
  if (materials.size() > 1 && found != all.end())
    for (const auto& [name, part] : found->items()) sets.push_back({between_dashes(name), colour(name), &part});
  std::erase_if(sets, [](const Set& set) { return !(count_of(set) > 1); });
  return sets;
}

/// Density of F/<F> with the fits of all contacts, weak k x^-alpha and strong k exp(beta (1 - x)) (T eq. 1.3 and 1.4).
Panel density(const std::vector<Set>& sets) {
  Panel panel{{.label = "F/\u27e8F\u27e9", .low = 0, .high = end_of(sets)}, {}, {}};
  double least = 1, most = 2 / 1.3;
  for (auto set = sets.rbegin(); set != sets.rend(); ++set) {
    const auto y = reals_at(*set->of, "/pdf/y");
    least = least_above_zero(y, least), most = largest_of(y, most);
    const bool all = set->name == "all";
    panel.series.push_back({.name = set->name,
                            .colour = set->colour,
                            .x = reals_at(*set->of, "/pdf/x"),
                            .y = y,
                            .error = all ? reals_at(*set->of, "/pdf/error") : std::vector<double>(),
                            .points = true,
                            .weight = all ? 1 : 0.8,
                            .opacity = all ? 1 : 0.75});
  }
  panel.y = {.label = "probability density",
             .brief = "density",
             .logarithmic = true,
             .low = std::pow(10, std::floor(std::log10(least))),
             .high = 1.3 * most};
  const Numbers& all = *sets.front().of;
  const double k = estimate_at(all, "/k").value;
  const statistics::WeakPowerLaw weak{k, estimate_at(all, "/alpha").value};
  const statistics::FallBeyondMean strong{k, estimate_at(all, "/beta").value};
  const auto fit = [&](const auto& line) {
    panel.series.push_back(
        {.colour = "fit", .x = line.first, .y = line.second, .line = Line::dashed, .is_read = false});
  };
  if (weak.is_known()) fit(sampled(0.02, 1, [&](double x) { return weak.at(x); }));
  if (strong.is_known())
    fit(sampled(
        1, *panel.x.high, [&](double x) { return strong.at(x); }, 1));
  panel.references = {{.x = 1}};
  panel.near = true;
  return panel;
}

}  // namespace

Drawings grain_stresses(const StateData& state) {
  const Numbers* all = state.texture.at_path("/sigma_norm");
  if (!all || !all->contains("cumulative")) return {};
  const auto sets = sets_of(*all, "by_material", state.materials, [&](const std::string& name) -> std::string {
    const auto at = std::ranges::find(state.materials, name);
    return at == state.materials.end() ? "mixed 1"
                                       : colour_of_material(static_cast<std::size_t>(at - state.materials.begin()));
  });
  if (sets.empty()) return {};
  Drawing drawing;
  for (const bool logarithmic : {false, true}) {
    drawing.panels.push_back(survival(sets, "\u03c3_{norm}", "P(\u03c3_{norm})", logarithmic));
    drawing.panels.back().selected = "sigma_norm";
  }
  drawing.key = tails_key(sets, "/P0");
  return {drawing};
}

Drawings contact_forces(const StateData& state) {
  const Numbers* all = state.texture.at_path("/force");
  if (!all || !all->contains("pdf")) return {};
  const auto sets = sets_of(*all, "by_type", state.materials,
                            [&](const std::string& name) { return colour_of_pair(name, state.materials); });
  if (sets.empty() || sets.front().name != "all") return {};
  Drawing drawing{.panels = {density(sets), survival(sets, "F/\u27e8F\u27e9", "survival function", true)},
                  .key = tails_key(sets, "/strong_share")};
  drawing.key.push_back({"fits", "fit", {}, Line::dashed});
  return {drawing};
}

}  // namespace arenite::report::figures
