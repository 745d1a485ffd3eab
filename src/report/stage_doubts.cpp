#include "report/stage_doubts.hpp"

#include <fmt/core.h>

#include <cmath>

#include "grains/fields/discharge.hpp"
#include "statistics/numbers.hpp"
#include "statistics/numbers_text.hpp"

namespace arenite::report {
namespace {

/// The loads by side; nothing of a stage without, or whose numbers were stored before there were any.
const Numbers* loads_of(const Numbers& stage) {
  return stage.is_tree() && stage.contains("loads") ? &stage["loads"] : nullptr;
}

std::string in_words(const std::string& side, const Numbers& load) {
  const std::string unit = load.contains("asked_Pa") ? "Pa" : "N";
  const Numbers& reached = load["reached_" + unit];
  const double asked = load["asked_" + unit].get<double>();
  const bool is_large = std::abs(asked) >= 1000;
  const double scale = is_large ? 1e-3 : 1;
  const std::string shown = (is_large ? "k" : "") + unit;
  const statistics::Estimate found{reached["value"].get<double>(),
                                   reached["error"].is_number() ? reached["error"].get<double>() : statistics::unknown};
  std::string text = fmt::format("{}: {} {} reached, {:.4g} {} asked for", side, statistics::with_error(found, scale),
                                 shown, scale * asked, shown);
  if (load.contains("spread_" + unit))
    text += fmt::format(", spread {:.2g} {}", scale * load["spread_" + unit].get<double>(), shown);
  return text;
}

void doubt_loads(const Numbers& stage, std::vector<std::string>& doubts) {
  const Numbers* loads = loads_of(stage);
  if (!loads) return;
  for (const auto& [side, load] : loads->items())
    if (!load["held"].get<bool>()) doubts.push_back("a load is not the one asked for: " + in_words(side, load));
}

void doubt_energy(const Numbers& stage, std::vector<std::string>& doubts) {
  if (!stage.is_tree() || !stage.contains("energy_balance")) return;
  const Numbers& balance = stage["energy_balance"];
  if (balance["closed"].get<bool>()) return;
  doubts.push_back(
      fmt::format("the energy balance is open by {:.2g} %, and work and dissipation are no better known; a smaller "
                  "integration.safety closes it",
                  100 * balance["open"].get<double>()));
}

void doubt_discharge(const Numbers& stage, std::vector<std::string>& doubts) {
  if (const auto filling = fields::too_low_filling(stage))
    doubts.push_back(
        fmt::format("the filling was {:.2g} openings high, too low for a rate that does not depend on it; take more "
                    "grains, a narrower container or a smaller opening",
                    *filling));
}

}  // namespace

std::vector<std::string> loads_in_words(const Numbers& stage) {
  std::vector<std::string> words;
  if (const Numbers* loads = loads_of(stage))
    for (const auto& [side, load] : loads->items()) words.push_back(in_words(side, load));
  return words;
}

std::vector<std::string> doubts_about(const Numbers& stage) {
  std::vector<std::string> doubts;
  doubt_loads(stage, doubts);
  doubt_energy(stage, doubts);
  doubt_discharge(stage, doubts);
  return doubts;
}

}  // namespace arenite::report
