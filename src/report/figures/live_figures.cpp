#include "report/figures/live_figures.hpp"
#include "report/figures/stage_figures.hpp"

#include <cmath>
#include <vector>

#include "core/mapped.hpp"
#include "report/figures/figure_document.hpp"
#include "report/figures/run_figures.hpp"
#include "report/number_block.hpp"
#include "report/run_drawing.hpp"
#include "report/sphere_document.hpp"

namespace arenite::report::figures {
namespace {

constexpr std::size_t most_live_figures = 2;
constexpr std::size_t most_grains = 20'000,  // that are sent and drawn again every few seconds
    most_spheres = 50'000;                   // which are drawn by the graphics card

Numbers known_values(const std::vector<double>& values) {
  return mapped(values, [](double v) { return std::isfinite(v) ? Numbers(v) : Numbers(); });
}

/// The first of a list that show anything, behind the picture.
template <class Data> void add_first(Numbers& found, const std::vector<Row<Data>>& list, const Data& data) {
  for (const Row<Data>& row : list) {
    if (found.size() > most_live_figures) break;
    const Drawings drawings = row.draw(data);
    if (drawings.empty()) continue;
    found.push_back({{"id", row.head.id}, {"title", row.head.title}, {"caption", ""}});
    found.back()["drawing"] = numbers_of(thinned(drawings.front()), known_values);
  }
}

}  // namespace

Numbers live_figures(const StageResult& now, const Packing* before) {
  Numbers found = Numbers::list();
  if (now.snapshots.empty()) return found;
  const Snapshot& state = now.snapshots.back();
  found.push_back({{"id", "grains"},
                   {"title", "Grains and forces now"},
                   {"caption", "Lines: normal forces between grains, as wide as strong."}});
  if (state.packing.grains.size() <= most_grains)
    found.back()["sample"] = sample_drawing({state.packing, {}}, FigureKind::forces);
  else found.back()["missing"] = "So many grains are drawn on the full page only.";
  add_first(found, stage_figures(), StageData{now, {&state}, before});
  return found;
}

Numbers live_figures(const SphereResult& now) {
  Numbers found = Numbers::list();
  if (now.snapshots.empty()) return found;
  found.push_back({{"id", "spheres"}, {"title", "Spheres now"}, {"caption", ""}});
  if (now.snapshots.back().packing.grains.size() <= most_spheres) {
    NumberBlock block;
    found.back()["spheres"] = {
        {"name", now.name}, {"figures", Numbers::tree()}, {"states", Numbers::list({state_of_now(now, block)})}};
    found.back()["block"] = block.text();
  } else found.back()["missing"] = "So many spheres are drawn on the full page only.";
  add_first(found, sphere_figures(), now);
  return found;
}

}  // namespace arenite::report::figures
