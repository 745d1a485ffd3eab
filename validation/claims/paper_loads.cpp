#include "validation/claims/paper_loads.hpp"

#include <fmt/core.h>

#include <cmath>

namespace arenite::validation {
namespace {

constexpr const char* loads_study = "paper-loads";

std::vector<Run> loaded(const Results& results, const char* loading) {
  return results.runs(loads_study, {{"loads.0.loading", loading}});
}

bool same_sample(const Run& a, const Run& b) {
  for (const char* key : {"bidisperse.size_ratio", "cement.kind", "cement.width", "seed"})
    if (a.text(key) != b.text(key)) return false;
  return true;
}

/// Numbers of the stress and the modulus; a sign may differ, since stresses turn theirs.
struct Compared {
  std::size_t numbers = 0, different = 0, runs = 0;
};

void compare(const Run& a, const Run& b, Compared& compared) {
  compared.runs += 1;
  for (const std::string& name : a.study->table().names) {
    if (!name.starts_with("stress.") && name != "modulus_Pa") continue;
    const double x = std::abs(a(name)), y = std::abs(b(name));
    if (std::isnan(x) && std::isnan(y)) continue;
    compared.numbers += 1;
    compared.different += x != y;
  }
}

}  // namespace

void add_shear(Judgement& judgement, const Results& results, const Asked& asked) {
  const Samples sheared{loaded(results, "shear"), {0.2, 0.6, 1}, "sigma_xy"};
  if (!sheared.runs.empty()) add_beside(judgement, "in shear (sigma_xy)", asked(sheared));
}

void add_compression(Judgement& judgement, const Results& results) {
  Compared compared;
  for (const Run& pushed : loaded(results, "compression"))
    for (const Run& pulled : loaded(results, "tension"))
      if (same_sample(pushed, pulled)) compare(pushed, pulled, compared);
  if (compared.runs == 0) return;
  judgement.findings.push_back(
      fmt::format("Compression is tension with reversed sign: of {} numbers of {} samples loaded in both directions, "
                  "{} differ in any bit, so the findings in tension also hold in compression.",
                  compared.numbers, compared.runs, compared.different));
}

}  // namespace arenite::validation
