#include "thermal/inference/film_stresses.hpp"

#include <algorithm>
#include <cmath>

namespace arenite::inference {
namespace {

using statistics::put;

/// Where every source has a finite stress.
std::vector<std::uint8_t> known_in_all(const std::vector<GrainStresses>& sources, std::size_t grains) {
  std::vector<std::uint8_t> known(grains, 1);
  for (const GrainStresses& s : sources)
    for (std::size_t g = 0; g < grains; ++g) known[g] = known[g] && std::isfinite(s.sigma_hyd[g]);
  return known;
}

/// Forgets the stress of grains that are not known, and fills in what follows from the others.
void normalise(GrainStresses& source, const std::vector<std::uint8_t>& known,
               const std::vector<std::uint8_t>& considered) {
  for (std::size_t g = 0; g < known.size(); ++g)
    if (!known[g]) source.sigma_hyd[g] = statistics::unknown;
  source.mean = statistics::mean_of_known(source.sigma_hyd, considered);
  source.sigma_norm = statistics::over(source.sigma_hyd, source.mean);
}

}  // namespace

FilmStresses film_stresses(const FilmResult& result, const std::vector<std::uint8_t>& considered) {
  FilmStresses out;
  const std::size_t grains = result.packing.grains.size();
  const auto add = [&](const char* name, const std::vector<double>& values) {
    if (grains > 0 && values.size() == grains) out.sources.push_back({name, values, {}, statistics::unknown});
  };
  add("film", result.peak_to_peak.sigma_hyd);
  add("simulation_peak_to_peak", result.simulation.peak_to_peak);
  add("simulation_state", result.simulation.state);
  if (out.sources.empty()) return out;
  const auto known = known_in_all(out.sources, grains);
  out.considered = known;
  for (std::size_t g = 0; g < grains; ++g) out.considered[g] = known[g] && considered[g];
  if (std::ranges::count(out.considered, 1) < 3) out.considered = known;
  for (GrainStresses& source : out.sources) normalise(source, known, out.considered);
  return out;
}

Agreement agreement(const std::vector<double>& film, const std::vector<double>& simulation,
                    const std::vector<std::uint8_t>& counts) {
  std::vector<double> a, b;
  for (std::size_t g = 0; g < film.size(); ++g) {
    if (!counts[g] || !std::isfinite(film[g]) || !std::isfinite(simulation[g])) continue;
    a.push_back(film[g]);
    b.push_back(simulation[g]);
  }
  if (a.size() < 2) return {};
  return {statistics::relate(b, a), statistics::rms_difference(a, b),
          statistics::rms_difference(statistics::over_mean(a), statistics::over_mean(b))};
}

Numbers numbers(const Agreement& a) {
  Numbers j = Numbers::tree();
  put(j, "count", a.relation.count, "", "Grains compared");
  put(j, "correlation", a.relation.pearson, "", "Pearson correlation of the grain stresses in film and simulation");
  put(j, "slope", statistics::Estimate{a.relation.line.slope, a.relation.line.slope_error}, "",
      "Slope of the stresses from the film against those of the simulation");
  put(j, "rms_Pa", a.rms, "Pa", "Root mean square difference of the stresses");
  put(j, "rms_sigma_norm", a.rms_sigma_norm, "", "Root mean square difference of the stresses, each over its mean");
  return j;
}

Numbers agreement_of(const Packing& packing, const FilmStresses& stresses, const GrainStresses& simulation) {
  Numbers all = Numbers::tree();
  const auto add = [&](const std::string& set, int material) {
    auto counts = stresses.considered;
    for (std::size_t g = 0; g < counts.size(); ++g)
      counts[g] = counts[g] && (material < 0 || packing.grains.material[g] == material);
    const Agreement a = agreement(stresses.sources[0].sigma_hyd, simulation.sigma_hyd, counts);
    if (a.relation.count >= 3) all[set] = numbers(a);
  };
  add("all", -1);
  if (packing.materials.size() > 1)
    for (std::size_t m = 0; m < packing.materials.size(); ++m) add(packing.materials[m].name, static_cast<int>(m));
  return all;
}

}  // namespace arenite::inference
