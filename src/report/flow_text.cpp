#include "report/result_text.hpp"

namespace arenite::report {

std::string flow_text(const Numbers& numbers) {
  TextLines rows(numbers, TextLines::Layout::explained);
  if (rows.has("/discharge")) {
    rows.section("Discharge", {{"rate of discharge", "/discharge/rate_kg_s", "kg/s", "mean over the time in which it is steady"},
                               {"the same in grains", "/discharge/rate_grains_s", "1/s"},
                               {"steady", "/discharge/steady", "", "\"no\": the mean over all the time in which anything passed, which has no error"},
                               {"from", "/discharge/begin_s", "s"},
                               {"to", "/discharge/end_s", "s"},
                               {"opening", "/discharge/opening_m", "m", "narrowest way between two boundaries"}});
  }
  if (rows.has("/surface")) {
    rows.section("Free surface, of the grains that hang together",
                 {{"angle of repose", "/surface/angle_deg", "deg", "of the flanks in the last state, by the middle of their height"},
                  {"the same to the left", "/surface/left_angle_deg", "deg"},
                  {"the same to the right", "/surface/right_angle_deg", "deg"},
                  {"mean angle", "/surface/mean_angle_deg", "deg", "over the second half of the states, where it only fluctuates"},
                  {"left end", "/surface/left_m", "m"},
                  {"right end", "/surface/right_m", "m"},
                  {"highest grain", "/surface/top_m", "m"},
                  {"run-out", "/surface/runout_m", "m", "way of the front since the stage began, known to half a grain"},
                  {"run-out over width", "/surface/runout_over_width", "", "over the width as the stage began"},
                  {"aspect ratio before", "/surface/aspect_ratio_before", "", "height over width as the stage began"}});
  }
  if (rows.has("/floor")) {
    rows.section("Floor of a silo, over the second half of the stage",
                 {{"pressure", "/floor/pressure_Pa", "Pa"},
                  {"of a liquid as heavy", "/floor/hydrostatic_Pa", "Pa"},
                  {"height of the filling", "/floor/height_m", "m"},
                  {"wall friction mobilised", "/floor/wall_friction", "", "weight that the walls carry over their normal force"}});
  }
  if (rows.has("/cohesion")) {
    rows.section("Cohesion", {{"pairs joined", "/cohesion/pairs", "", "in the last state"},
                              {"of them apart", "/cohesion/pairs_apart", ""},
                              {"pull of touching grains", "/cohesion/pull_N", "N", "mean, as the stage began"},
                              {"granular Bond number", "/cohesion/bond_number", "", "that over a grain's weight, or over p d t"},
                              {"tensile strength", "/cohesion/tensile_strength_Pa", "Pa", "largest tension on a side that is drawn outward"},
                              {"Rumpf's estimate", "/cohesion/rumpf_Pa", "Pa", "phi z F/(pi d t) of the state before"}});
  }
  return std::move(rows).text();
}

}  // namespace arenite::report
