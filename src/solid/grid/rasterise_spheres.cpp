#include "solid/grid/rasterise_spheres.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "core/problems.hpp"
#include "solid/cement/cement_spheres.hpp"

namespace arenite::grid {
namespace {

/// The voxels of a box.
class Voxels {
 public:
  Voxels(const SpherePack& pack, int voxels) : low_(pack.low) {
    double longest = 0;
    for (int axis = 0; axis < 3; ++axis) longest = std::max(longest, pack.high[axis] - pack.low[axis]);
    if (pack.size() == 0 || !(longest > 0)) throw InputError("there are no spheres, or they have no extent");
    dx_ = longest / voxels;
    if (pack.periodic && !is_whole_in_voxels(pack, voxels))
      throw refusal(
          "a periodic box of {:g} x {:g} x {:g} m is no whole number of voxels along each axis; choose another "
          "number of voxels",
          pack.high.x - pack.low.x, pack.high.y - pack.low.y, pack.high.z - pack.low.z);
    for (int axis = 0; axis < 3; ++axis) {
      const double side = (pack.high[axis] - pack.low[axis]) / dx_, whole = std::round(side);
      count_[static_cast<std::size_t>(axis)] = std::max(1, static_cast<int>(whole));
    }
  }
  double dx() const { return dx_; }
  const std::array<int, 3>& count() const { return count_; }

  /// visit(voxel, middle) for every voxel whose middle lies in a box.
  template <class Visit> void each_in(const VoxelMap& map, Vec3 low, Vec3 high, const Visit& visit) const {
    std::array<int, 3> first, last;
    for (int axis = 0; axis < 3; ++axis) {
      const auto a = static_cast<std::size_t>(axis);
      first[a] = std::max(0, static_cast<int>(std::ceil((low[axis] - low_[axis]) / dx_ - 0.5)));
      last[a] = std::min(count_[a] - 1, static_cast<int>(std::floor((high[axis] - low_[axis]) / dx_ - 0.5)));
    }
    for (int z = first[2]; z <= last[2]; ++z)
      for (int y = first[1]; y <= last[1]; ++y)
        for (int x = first[0]; x <= last[0]; ++x)
          visit(map.index(x, y, z), low_ + dx_ * Vec3{x + 0.5, y + 0.5, z + 0.5});
  }

 private:
  Vec3 low_;
  double dx_ = 1;
  std::array<int, 3> count_{};
};

Vec3 about(Vec3 centre, double reach, int sign) { return centre + Vec3{sign * reach, sign * reach, sign * reach}; }

void add_spheres(const Voxels& voxels, const SpherePack& all, VoxelMap& map) {
  std::vector<float> power(map.size(), 0);
  for (std::size_t s = 0; s < all.size(); ++s) {
    const double r = all.radius[s];
    voxels.each_in(map, about(all.centre[s], r, -1), about(all.centre[s], r, 1), [&](std::size_t k, Vec3 at) {
      const Vec3 d = at - all.centre[s];
      const double own = dot(d, d) - r * r;
      if (own > 0 || (map.grain[k] >= 0 && own >= static_cast<double>(power[k]))) return;
      map.phase[k] = Phase::particle;
      map.grain[k] = all.label[s];
      power[k] = static_cast<float>(own);
    });
  }
}

void add_neck(const Voxels& voxels, const SphereNeck& neck, VoxelMap& map) {
  const Vec3 axis = neck.b - neck.a;
  const double length2 = dot(axis, axis), widest = std::max(neck.half_a, neck.half_b);
  if (!(length2 > 0)) return;
  Vec3 low, high;
  for (int c = 0; c < 3; ++c) {
    low[c] = std::min(neck.a[c], neck.b[c]) - widest;
    high[c] = std::max(neck.a[c], neck.b[c]) + widest;
  }
  voxels.each_in(map, low, high, [&](std::size_t k, Vec3 at) {
    if (map.phase[k] != Phase::empty) return;
    const Vec3 e = at - neck.a;
    const double t = dot(e, axis) / length2;
    if (t < 0 || t > 1) return;
    const double half = neck.half_a + t * (neck.half_b - neck.half_a);
    if (dot(e, e) - t * t * length2 <= half * half) map.phase[k] = Phase::matrix;
  });
}

void add_meniscus(const Voxels& voxels, const SphereMeniscus& meniscus, VoxelMap& map) {
  const auto& shape = meniscus.shape;
  const Vec3 axis = (1 / shape.length) * (meniscus.b - meniscus.a);
  const double widest = std::max(shape.touch_i.y, shape.touch_j.y);
  Vec3 low, high;
  for (int c = 0; c < 3; ++c) {
    low[c] = std::min(meniscus.a[c], meniscus.b[c]) - widest;
    high[c] = std::max(meniscus.a[c], meniscus.b[c]) + widest;
  }
  voxels.each_in(map, low, high, [&](std::size_t k, Vec3 at) {
    if (map.phase[k] != Phase::empty) return;
    const Vec3 e = at - meniscus.a;
    const double along = dot(e, axis), across = std::sqrt(std::max(0.0, dot(e, e) - along * along));
    if (shape.contains({along, across})) map.phase[k] = Phase::matrix;
  });
}

VoxelMap grains_in(const Voxels& voxels, const SpherePack& pack) {
  const auto [width, height, depth] = voxels.count();
  VoxelMap map = make_voxel_map(width, height, depth, voxels.dx());
  map.grain_class.assign(pack.size(), GrainClass::none);
  add_spheres(voxels, cement::with_images(pack, 0), map);
  return map;
}

void add_cement(const Voxels& voxels, const SpherePack& pack, const SphereCement& cement, VoxelMap& map) {
  if (cement.full)
    for (Phase& phase : map.phase)
      if (phase == Phase::empty) phase = Phase::matrix;
  const SpherePack all = cement.coating > 0 ? cement::with_images(pack, cement.coating) : SpherePack{};
  for (std::size_t s = 0; s < all.size(); ++s) {
    const double reach = all.radius[s] + cement.coating;
    voxels.each_in(map, about(all.centre[s], reach, -1), about(all.centre[s], reach, 1), [&](std::size_t k, Vec3 at) {
      const Vec3 d = at - all.centre[s];
      if (map.phase[k] == Phase::empty && dot(d, d) <= reach * reach) map.phase[k] = Phase::matrix;
    });
  }
  for (const SphereNeck& neck : cement.necks) add_neck(voxels, neck, map);
  for (const SphereMeniscus& meniscus : cement.menisci) add_meniscus(voxels, meniscus, map);
}

}  // namespace

VoxelMap rasterise_spheres(const SpherePack& pack, const SphereCement& cement, int voxels) {
  const Voxels grid(pack, voxels);
  VoxelMap map = grains_in(grid, pack);
  add_cement(grid, pack, cement, map);
  return map;
}

bool is_whole_in_voxels(const SpherePack& pack, int voxels) {
  const Vec3 size = pack.high - pack.low;
  const double dx = std::max({size.x, size.y, size.z}) / voxels;
  for (int axis = 0; axis < 3; ++axis) {
    const double whole = std::round(size[axis] / dx);
    if (std::abs(size[axis] / dx - whole) > 1e-6 * whole) return false;
  }
  return true;
}

void cut_out(SpherePack& pack, const std::vector<double>& box) {
  if (pack.periodic) throw InputError("these spheres repeat themselves, and their box is their period; leave box out");
  pack.low = {box[0], box[1], box[2]};
  pack.high = {box[3], box[4], box[5]};
  for (std::size_t k = 0; k < pack.size(); ++k) {
    const Vec3 c = pack.centre[k];
    const Vec3 nearest{std::clamp(c.x, box[0], box[3]), std::clamp(c.y, box[1], box[4]),
                       std::clamp(c.z, box[2], box[5])};
    if (norm(nearest - c) < pack.radius[k]) return;
  }
  throw refusal("no sphere reaches into a box from {:g}, {:g}, {:g} to {:g}, {:g}, {:g} m; move it", box[0], box[1],
                box[2], box[3], box[4], box[5]);
}

double saturation_of(const VoxelMap& map) {
  double matrix = 0, grains = 0;
  for (const Phase phase : map.phase) matrix += phase == Phase::matrix, grains += phase == Phase::particle;
  const double rest = static_cast<double>(map.size()) - grains;
  return rest > 0 ? matrix / rest : 0;
}

std::string doubt_about_cement(const cement::CementParameters& parameters, const VoxelMap& map) {
  if (parameters.kind == cement::CementParameters::Kind::none || saturation_of(map) > 0) return {};
  return "the cement is thinner than a voxel everywhere, so that no voxel has any; take more voxels, or wider cement";
}

VoxelMap cemented_voxels(const SpherePack& pack, cement::CementParameters parameters, int voxels, double& parameter) {
  using Kind = cement::CementParameters::Kind;
  const bool coats = parameters.kind == Kind::coating;
  double& free = coats ? parameters.thickness : parameters.width;
  const Voxels grid(pack, voxels);
  const VoxelMap grains = grains_in(grid, pack);
  const auto made = [&] {
    parameter = free;
    VoxelMap map = grains;
    add_cement(grid, pack, cement::cement_spheres(pack, parameters), map);
    return map;
  };
  const bool necks = parameters.kind == Kind::bridges || parameters.kind == Kind::menisci;
  if (!parameters.saturation || (!coats && !necks)) return made();
  double low = 0, high = coats ? 2 * *std::ranges::max_element(pack.radius) : 1;
  free = high;
  VoxelMap map = made();
  if (const double most = saturation_of(map); most < *parameters.saturation)
    throw refusal("{} fill at most {:.3f} of the space between these spheres; ask for less than that, or for full",
                  coats                              ? "coatings"
                  : parameters.kind == Kind::menisci ? "menisci"
                                                     : "bridges",
                  most);
  for (int round = 0; round < 24; ++round) {
    free = (low + high) / 2;
    map = made();
    (saturation_of(map) < *parameters.saturation ? low : high) = free;
  }
  return map;
}

}  // namespace arenite::grid
