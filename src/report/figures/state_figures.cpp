#include "report/figures/state_figures.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "report/figures/distributions.hpp"
#include "report/figures/roses.hpp"

namespace arenite::report::figures {
namespace {

/// Mean number of contacts: of all grains, by material, and X-Y, the Y neighbours of an X grain.
Drawings coordination(const StateData& state) {
  const Numbers* found = state.texture.at_path("/coordination");
  if (!found || !found->contains("all")) return {};
  Panel panel{{.label = "contacts per grain", .brief = "z", .low = 0}, {.label = ""}, {}};
  panel.lying = true;
  const auto add = [&](const std::string& name, std::string label, std::string colour) {
    const auto at = found->find(name);
    if (at == found->end()) return;
    const auto z = estimate_at(*at, "");
    panel.series.push_back({.name = label,
                            .colour = std::move(colour),
                            .x = {static_cast<double>(panel.y.names.size())},
                            .y = {z.value},
                            .error = {z.error},
                            .bars = 0.66,
                            .opacity = 0.82});
    panel.y.names.push_back(std::move(label));
  };
  add("all", "all", "strong");
  add("without_rattlers", "without rattlers", "weak");
  const auto& names = state.materials;
  for (std::size_t m = 0; names.size() > 1 && m < names.size(); ++m)
    add(names[m] + "-ANY", names[m] + "\u2013any", colour_of_material(m));
  for (const auto& x : names)
    for (const auto& y : names)
      if (names.size() > 1) add(x + "-" + y, x + "\u2013" + y, colour_of_pair(x + "-" + y, names));
  return {{.panels = {panel}}};
}

Drawings contact_numbers(const StateData& state) {
  const auto share = reals_at(state.texture, "/coordination/histogram");
  if (share.empty()) return {};
  std::vector<double> contacts;
  for (std::size_t z = 0; z < share.size(); ++z) contacts.push_back(static_cast<double>(z));
  return {{.panels = {{{.label = "contacts", .low = -0.6, .high = contacts.back() + 0.6},
                       {.label = "grains", .unit = "%", .low = 0},
                       {{.x = contacts, .y = scaled(share, 100), .bars = 0.8, .opacity = 0.75}}}}}};
}

/// Solid fraction of windows of growing size at random positions (T Fig. 3.6).
Drawings rev(const StateData& state) {
  const bool in_space = state.texture.at_path("/rev/volume_share") != nullptr;
  const auto share = scaled(reals_at(state.texture, in_space ? "/rev/volume_share" : "/rev/area_share"), 100),
             mean = reals_at(state.texture, "/rev/mean"), deviation = reals_at(state.texture, "/rev/deviation");
  if (share.empty()) return {};
  std::vector<double> low, high;
  for (std::size_t k = 0; k < mean.size(); ++k)
    low.push_back(mean[k] - deviation[k]), high.push_back(mean[k] + deviation[k]);
  Panel panel{{.label = "window", .unit = in_space ? "% of the volume" : "% of the area", .low = 0, .high = 100},
              {.label = "solid fraction"},
              {{.x = share, .y = mean, .low = low, .high = high, .opacity = 0.12, .is_read = false},
               {.x = share, .y = mean, .error = reals_at(state.texture, "/rev/error"), .points = true}}};
  Drawing drawing{.panels = {}, .key = {{"mean, with the standard deviation", "strong"}}};
  if (const double whole = estimate_at(state.texture, "/solid_fraction").value; std::isfinite(whole)) {
    panel.references = {{.y = whole, .colour = "accent", .line = Line::dashed}};
    drawing.key.push_back({"whole sample, without its border", "accent", {}, Line::dashed});
  }
  drawing.panels = {panel};
  return {drawing};
}

/// Signed anisotropy of the contacts above and below a force threshold (T Fig. 1.12a), in bands of random orientations.
Drawings threshold(const StateData& state) {
  const Numbers* found = state.texture.at_path("/fabric/threshold");
  if (!found) return {};
  constexpr double lost = 0.6;  // noise beyond which nothing can be seen
  Drawing drawing;
  Panel panel{{.label = "\u03be"}, {.label = "a_{c}"}, {}, {{.y = 0, .line = Line::solid}}};
  for (const auto& [part, name, colour] :
       {std::tuple{"above", "F > \u03be\u27e8F\u27e9", "strong"}, {"below", "F < \u03be\u27e8F\u27e9", "accent"}}) {
    auto y = reals_at(*found, std::string("/a_c_") + part), high = reals_at(*found, std::string("/noise_") + part);
    for (std::size_t k = 0; k < y.size(); ++k)
      if (!(high[k] < lost)) y[k] = high[k] = statistics::unknown;
    const Series line{.name = name, .colour = colour, .x = reals_at(*found, "/force"), .y = y, .line = Line::solid};
    Series band = line;
    band.line = Line::none, band.low = scaled(high, -1), band.high = high, band.opacity = 0.1, band.is_read = false;
    panel.series.insert(panel.series.begin(), band);
    panel.series.push_back(line);
    drawing.key.push_back({name, colour});
  }
  drawing.panels = {panel};
  return {drawing};
}

Drawings fabric(const StateData& state) {
  const Numbers* all = state.texture.at_path("/fabric");
  if (!all || !all->contains("sectors")) return {};
  const auto named = all->find("sets");
  const auto set = [&](const std::string& name) -> const Numbers* {
    if (named == all->end() || !named->contains(name)) return nullptr;
    const Numbers& found = *named->find(name);
    return estimate_at(found, "/contacts").value > 0 && found.contains("sectors") ? &found : nullptr;
  };
  Drawing drawing{.roses = {rose_of("all", "strong", *all, set("strong"))}};
  if (const Numbers* strong = set("strong")) drawing.roses.push_back(rose_of("strong", "strong", *strong, strong));
  if (const Numbers* weak = set("weak")) drawing.roses.push_back(rose_of("weak", "weak", *weak));
  if (named != all->end())
    for (const auto& [name, unused] : named->items()) {
      const bool of_walls = name == "wall" || name == "walls";
      if (name.ends_with("strong") || name.ends_with("weak") || (state.materials.size() == 1 && !of_walls)) continue;
      if (const Numbers* found = set(name))
        drawing.roses.push_back(rose_of(of_walls ? "walls" : between_dashes(name),
                                        of_walls ? "wall" : colour_of_pair(name, state.materials), *found,
                                        set(name + " strong")));
    }
  for (Rose& rose : drawing.roses) rose.axis = estimate_at(*all, "/load_axis_deg").value;
  return {drawing};
}

}  // namespace

const std::vector<Row<StateData>>& state_figures() {
  static const std::vector<Row<StateData>> list{
      {{"fabric",
        "contact-orientations",
        "Contact orientations",
        {"Fraction of contacts in sectors of 10\u00b0, over the isotropic fraction (dashed circle); darker: strong "
         "contacts, F_{n} > \u27e8F_{n}\u27e9.",
         "Line: 1 + a_{c} cos 2(\u03b8 \u2212 \u03b8_{c}). \u25b6 marks the axis of compression."},
        true},
       fabric},
      {{"sigma-norm",
        "sigma-norm",
        "Normalised stress of grains, \u03c3_{norm} = \u03c3_{hyd}/\u27e8\u03c3_{hyd}\u27e9",
        {"P: survival function, the fraction of grains above \u03c3_{norm}.",
         "Dashed: P_{0} exp[\u03b2(1 \u2212 \u03c3_{norm})], maximum likelihood."},
        true},
       grain_stresses},
      {{"forces",
        "forces",
        "Contact forces, F = F_{n}",
        {"Left: density of F/\u27e8F\u27e9 (each type over its own mean), all contacts with counting errors, and the "
         "fits k x^{\u2212\u03b1} (weak) and k exp[\u03b2(1 \u2212 x)] (strong).",
         "Right: survival function, the fraction of contacts above."},
        true},
       contact_forces},
      {{"coordination", "coordination", "Coordination number z",
        "Mean number of contacts per grain with its standard error; X\u2013Y counts the Y neighbours of an X grain."},
       coordination},
      {{"contact-numbers", "contact-numbers", "Contacts per grain",
        "Fraction of grains by number of contacts with other grains."},
       contact_numbers},
      {{"rev",
        "rev",
        "Representative volume",
        {"Solid fraction of windows at random positions: mean with standard error, band of one standard deviation.",
         "Dashed: whole sample without its border."}},
       rev},
      {{"threshold", "threshold", "Anisotropy by force",
        "Signed a_{c} along the loading axis, for the contacts above and below a force threshold; bands: values for "
        "random orientations."},
       threshold}};
  return list;
}

}  // namespace arenite::report::figures
