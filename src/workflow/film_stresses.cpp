#include "workflow/film_stresses.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"

namespace arenite::workflow {
namespace {

/// Grains with a finite stress in every source.
std::vector<std::int32_t> known_in_all(const std::vector<GrainStresses>& sources, std::size_t grains) {
  std::vector<std::int32_t> known;
  for (std::size_t g = 0; g < grains; ++g)
    if (std::all_of(sources.begin(), sources.end(), [&](const GrainStresses& s) { return std::isfinite(s.sigma_hyd[g]); }))
      known.push_back(static_cast<std::int32_t>(g));
  return known;
}

texture::Texture measured(const Packing& packing, texture::Options options) {
  options.rev_sizes = options.rev_places = 1;  // the packing's own tab shows these
  auto texture = texture::measure(packing, options);
  if (texture.considered_grains > 0 || options.border == 0) return texture;
  options.border = 0;
  return texture::measure(packing, options);
}

/// Fills in what follows from sigma_hyd of the known grains, and which of them count.
void normalise(GrainStresses& source, const Packing& packing, const std::vector<std::int32_t>& known, texture::Options options,
               std::vector<std::uint8_t>& considered) {
  options.grain_sigma_hyd.clear();
  for (const std::int32_t g : known) options.grain_sigma_hyd.push_back(source.sigma_hyd[g]);
  source.sigma_hyd.assign(source.sigma_hyd.size(), statistics::unknown);
  source.sigma_norm = source.sigma_hyd;
  source.statistics = Numbers::tree();
  if (known.empty()) return;
  const texture::Texture texture = measured(packing, options);
  double sum = 0;
  std::size_t count = 0;
  for (std::size_t k = 0; k < known.size(); ++k) {
    const auto g = static_cast<std::size_t>(known[k]);
    source.sigma_hyd[g] = options.grain_sigma_hyd[k];
    source.sigma_norm[g] = texture.per_grain.sigma_norm[k];
    considered[g] = texture.per_grain.considered[k];
    if (considered[g]) sum += source.sigma_hyd[g], ++count;
  }
  if (count > 0) source.mean = sum / static_cast<double>(count);
  const Numbers numbers = texture::numbers(texture, true);
  if (numbers.contains("sigma_norm")) source.statistics = numbers["sigma_norm"];
}

}  // namespace

FilmStresses film_stresses(const FilmResult& result, const texture::Options& options) {
  FilmStresses out;
  const std::size_t grains = result.packing.grains.size();
  const auto add = [&](const char* name, const std::vector<double>& values) {
    if (grains > 0 && values.size() == grains) out.sources.push_back({name, values, {}, statistics::unknown, {}});
  };
  add("film", result.swing.sigma_hyd);
  add("twin_swing", result.twin.swing);
  add("twin_state", result.twin.state);
  if (out.sources.empty()) return out;
  const auto known = known_in_all(out.sources, grains);
  const Packing packing{result.packing.materials, result.packing.domain, picked(result.packing.grains, known), {}, {}, {}};  // without contacts and bonds
  out.considered.assign(grains, 0);
  for (GrainStresses& source : out.sources) normalise(source, packing, known, options, out.considered);
  return out;
}

std::vector<StressRelation> stress_relations(const Packing& packing, const GrainStresses& film, const GrainStresses& twin) {
  std::vector<StressRelation> all;
  const auto add = [&](const std::string& name, int material) {
    std::vector<double> x, y;
    double squares = 0, squares_norm = 0;
    for (std::size_t g = 0; g < film.sigma_hyd.size(); ++g) {
      if ((material >= 0 && packing.grains.material[g] != material) || !std::isfinite(film.sigma_hyd[g]) || !std::isfinite(twin.sigma_hyd[g])) continue;
      x.push_back(twin.sigma_hyd[g]);
      y.push_back(film.sigma_hyd[g]);
      squares += std::pow(film.sigma_hyd[g] - twin.sigma_hyd[g], 2);
      squares_norm += std::pow(film.sigma_norm[g] - twin.sigma_norm[g], 2);
    }
    const auto count = static_cast<double>(x.size());
    if (x.size() >= 3) all.push_back({name, statistics::relate(x, y), std::sqrt(squares / count), std::sqrt(squares_norm / count)});
  };
  add("all", -1);
  if (packing.materials.size() > 1)
    for (std::size_t m = 0; m < packing.materials.size(); ++m) add(packing.materials[m].name, static_cast<int>(m));
  return all;
}

}  // namespace arenite::workflow
