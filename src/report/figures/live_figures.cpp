#include "report/figures/live_figures.hpp"

#include <cmath>
#include <vector>

#include "core/mapped.hpp"
#include "report/figures/figure_document.hpp"
#include "report/run_drawing.hpp"

namespace arenite::report::figures {
namespace {

constexpr std::size_t most_live_figures = 2;
constexpr std::size_t most_grains = 20'000;  // that are sent and drawn again every few seconds

Numbers known_values(const std::vector<double>& values) {
  return mapped(values, [](double v) { return std::isfinite(v) ? Numbers(v) : Numbers(); });
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
  const figures::StageData data{now, {&state}, before};
  for (const auto& row : figures::stage_figures()) {
    if (found.size() > most_live_figures) break;
    const figures::Drawings drawings = row.draw(data);
    if (drawings.empty()) continue;
    found.push_back({{"id", row.head.id}, {"title", row.head.title}, {"caption", ""}});
    found.back()["drawing"] = figures::numbers_of(figures::thinned(drawings.front()), known_values);
  }
  return found;
}

}  // namespace arenite::report::figures
