#include "grains/texture/gap_coordination.hpp"

#include <array>
#include <utility>
#include <vector>

#include "core/problems.hpp"
#include "grains/texture/view.hpp"
#include "model/periodic_images.hpp"

namespace arenite::texture {
namespace {

/// Neighbours of every grain in the two classes.
std::vector<std::array<int, 2>> count_neighbours(const Packing& packing, const PeriodicImages& images, double gap,
                                                 std::array<int, 2> classes) {
  const auto& material = packing.grains.material;
  std::vector<std::array<int, 2>> count(packing.grains.size(), {0, 0});
  const auto add = [&](std::size_t image, std::size_t neighbour) {
    if (image >= count.size()) return;  // an image's own neighbours are counted with its grain
    for (std::size_t k = 0; k < 2; ++k)
      if (material[images.of[neighbour]] == classes[k]) ++count[image][k];
  };
  for (const auto [i, j] : images.close_pairs(gap)) {
    add(i, j);
    add(j, i);
  }
  return count;
}

constexpr std::pair<const char*, const char*> declared[] = {{"Z", "Neighbours Z of a grain, mean of Z_l and Z_s"},
                                                            {"Z_l", "Neighbours of a large grain"},
                                                            {"Z_s", "Neighbours of a small grain"},
                                                            {"Z_ll", "Large neighbours of a large grain"},
                                                            {"Z_ls", "Small neighbours of a large grain"},
                                                            {"Z_sl", "Large neighbours of a small grain"},
                                                            {"Z_ss", "Small neighbours of a small grain"}};

/// In the order declared, from the number of large grains and of their neighbours, then the same of small.
std::vector<double> means(const std::vector<double>& sums) {
  const auto by_large = [&](double sum) { return sums[0] > 0 ? sum / sums[0] : unknown; };
  const auto by_small = [&](double sum) { return sums[3] > 0 ? sum / sums[3] : unknown; };
  const double l = by_large(sums[1] + sums[2]), s = by_small(sums[4] + sums[5]);
  return {(l + s) / 2, l, s, by_large(sums[1]), by_large(sums[2]), by_small(sums[4]), by_small(sums[5])};
}

}  // namespace

Numbers gap_coordination(const Packing& packing, double gap, int large, int small,
                         const std::optional<geometry::Rectangle>& window) {
  if (!(gap >= 0)) throw refusal("neighbours up to a surface gap of {:g} m; give 0 or more", gap);
  if (large == small) throw InputError("large and small grains are of one material; give each class its own");
  const PeriodicImages images = images_of(packing.grains, packing.domain, gap);
  const auto neighbours = count_neighbours(packing, images, gap, {large, small});
  const auto& material = packing.grains.material;

  Items counted;
  std::size_t of_class[2] = {0, 0};
  for (std::size_t g = 0; g < neighbours.size(); ++g) {
    if (window && !window->holds(images.centre[g])) continue;
    of_class[0] += material[g] == large;
    of_class[1] += material[g] == small;
    if (material[g] == large || material[g] == small) counted.push_back(g);
  }
  Numbers j{{"gap_m", described(gap, "m", "Largest distance of the surfaces of neighbours")},
            {"large_grains", described(of_class[0], "", "Large grains considered")},
            {"small_grains", described(of_class[1], "", "Small grains considered")}};
  if (counted.empty()) return j;
  const BlockGrid blocks{window.value_or(box_of(packing.domain)), blocks_per_side(counted.size())};
  std::vector<int> block;
  for (std::size_t g = 0; g < neighbours.size(); ++g) block.push_back(blocks.block_of(images.centre[g], g));
  const auto add = [&](std::size_t g, double* sums) {
    double* own = material[g] == large ? sums : sums + 3;
    own[0] += 1;
    own[1] += neighbours[g][0];
    own[2] += neighbours[g][1];
  };
  const auto e = jackknife_of_sums(counted, block, 6, add, means);
  for (std::size_t k = 0; k < e.size(); ++k) put(j, declared[k].first, e[k], "", declared[k].second);
  return j;
}

}  // namespace arenite::texture
