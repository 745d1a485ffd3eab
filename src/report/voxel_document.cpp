#include "report/voxel_document.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "model/voxel_quantities.hpp"
#include "report/figures/field_figures.hpp"
#include "report/figures/headlines.hpp"
#include "report/page_document.hpp"
#include "solid/stress/sample_means.hpp"
#include "statistics/histogram.hpp"

namespace arenite::report {
namespace {

/// The voxels that the page draws: every `stride`-th along each axis, from the middle of the first block.
struct ThinnedVoxels {
  int stride = 1, width = 0, height = 0, depth = 0;
  std::vector<std::size_t> voxel;  ///< their indices in the map

  explicit ThinnedVoxels(const VoxelMap& map, std::size_t most = std::size_t{1} << 21) {
    const auto left = [&](int size) { return std::max(1, size / stride); };
    while (static_cast<std::size_t>(left(map.width)) * static_cast<std::size_t>(left(map.height)) *
               static_cast<std::size_t>(left(map.depth)) >
           most)
      ++stride;
    width = left(map.width), height = left(map.height), depth = left(map.depth);
    for (int z = 0; z < depth; ++z)
      for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
          voxel.push_back(map.index(x * stride + stride / 2, y * stride + stride / 2, z * stride + stride / 2));
  }
};

/// One quantity: its words, the codes of the voxels that are drawn, and its mean, and extremes of all that are not
/// void.
Numbers coded(const VoxelQuantity& quantity, const VoxelResult& result, const ThinnedVoxels& kept, NumberBlock& block) {
  std::vector<double> inside;
  for (std::size_t k = 0; k < result.map.size(); ++k)
    if (result.map.phase[k] != Phase::empty) inside.push_back(quantity.of(result.field, k));
  Numbers out{{"words", std::string(quantity.words)},
              {"symbol", std::string(quantity.symbol)},
              {"unit", std::string(quantity.unit)},
              {"magnitude", quantity.is_magnitude}};
  if (inside.empty()) return out;
  const auto ends = statistics::exact_quantiles(inside, {0, 0.001, 0.999, 1});
  const double low = ends[1], step = std::max(ends[2] - low, 1e-300) / 254;
  std::vector<std::uint32_t> code;
  for (const std::size_t k : kept.voxel) {
    const double place = std::round((quantity.of(result.field, k) - low) / step);
    code.push_back(
        result.map.phase[k] == Phase::empty ? 0u : 1u + static_cast<std::uint32_t>(std::clamp(place, 0.0, 254.0)));
  }
  out.update(Numbers{{"code", block.add_indices(code)},
                     {"low", low},
                     {"high", ends[2]},
                     {"least", ends[0]},
                     {"most", ends[3]},
                     {"mean", stress::sample_mean(result, quantity)}});
  return out;
}

Numbers volume_of(const VoxelResult& r, NumberBlock& block, const figures::WriteList& write) {
  const ThinnedVoxels kept(r.map);
  std::vector<std::uint32_t> phase;
  for (const std::size_t k : kept.voxel) phase.push_back(static_cast<std::uint32_t>(r.map.phase[k]));
  Numbers quantities = Numbers::tree();
  for (const VoxelQuantity* quantity : quantities_of(r))
    quantities[std::string(quantity->id)] = coded(*quantity, r, kept, block);
  const Numbers densities = r.numbers.value("stress", Numbers::tree());
  Numbers out{{"name", r.name},
              {"converged", r.converged},
              {"outcome", r.outcome},
              {"provenance", provenance_of(r.provenance)},
              {"size", {kept.width, kept.height, kept.depth}},
              {"full", {r.map.width, r.map.height, r.map.depth}},
              {"stride", kept.stride},
              {"dx", r.map.dx},
              {"in_voxels", !r.map.has_length},
              {"phase", block.add_indices(phase)},
              {"quantities", std::move(quantities)},
              {"acts_by", std::string(quantities_drawn(r).front()->id)},
              {"headlines", figures::numbers_of(figures::headlines_of(r))},
              {"figures", shortened(figures::numbers_of(figures::voxel_figures(), {r, densities}, write, true))}};
  add_numbers(out, r.numbers);
  return out;
}

}  // namespace

void add_volumes(Numbers& document, const PageData& data, NumberBlock& block, const figures::WriteList& write) {
  for (const VoxelResult& result : data.voxels) document["volumes"].push_back(volume_of(result, block, write));
}

}  // namespace arenite::report
