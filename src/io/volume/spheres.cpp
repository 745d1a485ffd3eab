#include "io/volume/spheres.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>
#include <variant>

#include "core/error.hpp"
#include "io/sample/sample.hpp"

namespace arenite::io {
namespace {

/// The smallest box that holds them all.
void enclose(SpherePack& pack) {
  for (int axis = 0; axis < 3; ++axis) {
    double low = INFINITY, high = -INFINITY;
    for (std::size_t k = 0; k < pack.size(); ++k) {
      low = std::min(low, pack.centre[k][axis] - pack.radius[k]);
      high = std::max(high, pack.centre[k][axis] + pack.radius[k]);
    }
    pack.low[axis] = low;
    pack.high[axis] = high;
  }
}

}  // namespace

bool is_sphere_table(const std::filesystem::path& path) {
  return path.extension() == ".csv" || known_sample_format(path) != nullptr;
}

SpherePack read_spheres(const std::filesystem::path& path, std::vector<std::string>& notes) {
  SampleOptions options;
  options.dimension = 3;
  options.may_be_given = false;
  auto sample = std::get<SampleIn<3>>(read_any_sample(path, {}, options));
  notes = std::move(sample.notes);
  const DomainIn<3>& cell = sample.packing.domain;
  SpherePack pack;
  pack.centre = std::move(sample.packing.grains.position);
  pack.radius = std::move(sample.packing.grains.radius);
  pack.label.resize(pack.size());
  std::iota(pack.label.begin(), pack.label.end(), 0);
  const auto periodic = std::ranges::count(cell.periodic, true);
  pack.periodic = periodic == 3;
  if (pack.periodic && cell.tilt != 0)
    throw InputError(
        path.string(), 0,
        "is of a sheared cell, whose images are no whole numbers of voxels apart; give a cell without tilt");
  if (periodic > 0 && !pack.periodic)
    notes.emplace_back(
        "Its cell repeats itself along some axes only; the spheres are taken as they lie, without their images.");
  if (!pack.periodic) enclose(pack);
  else pack.low = cell.corner(), pack.high = cell.corner(1);
  return pack;
}

}  // namespace arenite::io
