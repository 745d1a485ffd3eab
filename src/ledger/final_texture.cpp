#include "ledger/final_texture.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "io/run_folder.hpp"
#include "io/stage_file.hpp"
#include "study/recipe.hpp"
#include "study/run.hpp"

namespace arenite::ledger {

FinalState final_state(const Run& run, bool rev) {
  const auto files = io::stage_files(run.folder());
  if (files.empty()) throw InputError(run.folder().string(), 0, "there are no stage files of this run; remove its folder and run the study again");
  StageResult result = io::read_stage(files.back());
  if (result.frames.empty()) throw InputError(files.back().string(), 0, "this stage holds no state; remove it and run the study again");
  const study::Recipe recipe = study::parse_recipe(result.provenance.recipe, files.back().string());
  texture::Options options = study::texture_options(recipe, recipe.stages.size());
  if (!rev) options.rev_sizes = 0;
  FinalState state;
  state.packing = std::move(result.frames.back().packing);
  state.texture = texture::measure(state.packing, options);
  return state;
}

double chance_of_one_law(std::vector<double> a, std::vector<double> b) {
  if (a.empty() || b.empty()) return statistics::unknown;
  std::sort(a.begin(), a.end());
  std::sort(b.begin(), b.end());
  const auto n = static_cast<double>(a.size()), m = static_cast<double>(b.size());
  double distance = 0;
  for (std::size_t i = 0, j = 0; i < a.size() && j < b.size();) {
    const double x = std::min(a[i], b[j]);
    while (i < a.size() && a[i] == x) ++i;
    while (j < b.size() && b[j] == x) ++j;
    distance = std::max(distance, std::abs(static_cast<double>(i) / n - static_cast<double>(j) / m));
  }
  // Kolmogorov's series with Stephens's correction for finite samples.
  const double root = std::sqrt(n * m / (n + m)), t = (root + 0.12 + 0.11 / root) * distance;
  if (t < 0.2) return 1;
  double sum = 0;
  for (int k = 1; k <= 100; ++k) sum += (k % 2 == 1 ? 2 : -2) * std::exp(-2.0 * k * k * t * t);
  return std::clamp(sum, 0.0, 1.0);
}

}  // namespace arenite::ledger
