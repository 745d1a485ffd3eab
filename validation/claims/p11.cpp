#include <fmt/core.h>

#include <cmath>
#include <tuple>

#include "validation/claims/claims.hpp"
#include "validation/claims/paper_checks.hpp"

namespace arenite::validation {
namespace {

constexpr const char* linearity_study = "paper-linearity";

/// The runs with this stretch, strain and cement.
std::vector<Run> pulled(const Results& results, bool exact, const char* strain, double width) {
  std::vector<Run> runs;
  for (const Run& run :
       results.runs(linearity_study, {{"loads.0.exact_stretch", exact ? "true" : "false"}, {"loads.0.strain", strain}}))
    if (cement_of(run) == width) runs.push_back(run);
  return runs;
}

/// Modulus over that of others, seed by seed, minus 1, over `unit`.
Value departure(const std::vector<Run>& runs, const std::vector<Run>& others, double unit) {
  std::vector<double> values;
  for (const Run& run : runs)
    for (const Run& other : others)
      if (run.text("seed") == other.text("seed"))
        values.push_back((run("modulus_Pa") / other("modulus_Pa") - 1) / unit);
  return values.empty() ? Value() : statistics::mean_of(values);
}

}  // namespace

/// The modulus at a strain and at three times it, a factor that floating point does not carry through by itself; with
/// P's stretch its departure from the linear one over the strain.
Judgement judge_p11(const Results& results) {
  Judgement j;
  std::string ours;
  for (const double width : {full, 0.2}) {
    const std::string name = width == full ? "full" : "eta 0.2";
    const auto at = [&](bool exact, const char* strain) { return pulled(results, exact, strain, width); };
    const std::vector<Draw> draws{{linearity_study,
                                   {width == full ? std::pair<std::string, std::string>{"cement.kind", "full"}
                                                  : std::pair<std::string, std::string>{"cement.width", "0.2"}}}};
    const auto once = at(false, "1e-4"), thrice = at(false, "3e-4");
    const Value linear = size_of(departure(thrice, once, 1)),
                stretched = size_of(departure(at(true, "3e-4"), at(true, "1e-4"), 1));
    j.checks.push_back(
        below("relative change of the modulus at three times the strain, linearised, " + name, "linear", linear, 1e-6));
    j.checks.push_back(number(below("relative change of the modulus at three times the strain, P's stretch, " + name,
                                    "linear", stretched, 1e-3)));
    const double low = width == full ? 0.5 : 1.3, high = width == full ? 0.65 : 2.5;
    for (const auto& [strain, unit, linearised] : {std::tuple{"1e-4", 1e-4, once}, {"3e-4", 3e-4, thrice}})
      j.checks.push_back(
          between(fmt::format("departure with P's stretch, divided by the strain of {}, {}", strain, name),
                  "proportional to strain", size_of(departure(at(true, strain), linearised, unit)), low, high));
    for (Check& check : j.checks)
      if (check.draws.empty()) check.draws = draws;
    if (std::isfinite(stretched.value))
      ours += fmt::format("{}{}: {}", ours.empty() ? "change of the modulus at three times the strain, " : "; ", name,
                          text_of(stretched));
  }
  j.ours = ours;
  j.decides =
      "P's stretch is not linear in the displacements; the departure from linearity is proportional to the strain. "
      "With the linearised stretch the response is linear.";
  return j;
}

}  // namespace arenite::validation
