#include "grains/dem/boundaries/set_boundaries.hpp"

#include <fmt/core.h>

#include <cstdint>
#include <optional>

#include "core/error.hpp"
#include "grains/dem/conditions.hpp"
#include "grains/dem/measure.hpp"
#include "grains/dem/movers.hpp"
#include "grains/dem/neighbours.hpp"

namespace arenite::dem {
namespace {

/// How each boundary is to move.
template <int D>
std::vector<BoundaryMotionIn<D>> motions_of(const std::vector<BoundaryIn<D>>& boundaries,
                                            const std::vector<BoundaryMotionIn<D>>& named) {
  std::vector<BoundaryMotionIn<D>> motions;
  for (const auto& boundary : boundaries) motions.push_back({boundary.name, {}, {}, mean_point(boundary.points)});
  for (const auto& motion : named) {
    const std::size_t at = index_of(boundaries, motion.name);
    if (at == boundaries.size())
      throw InputError(fmt::format("boundary \"{}\" is to move, but does not exist", motion.name));
    const auto mean = motions[at].centre;
    motions[at] = motion;
    if (!motion.centre) motions[at].centre = mean;
  }
  return motions;
}

template <int D> BoundaryMotionIn<D> motion_now(const SampleIn<D>& s, std::size_t b) {
  const BoundaryIn<D>& now = s.domain.boundaries[b];
  const BoundaryBodyIn<D>& body = the<BoundariesIn<D>>(s).body[b];
  return {now.name,   now.velocity, now.spin,
          now.centre, !now.present, body.mass > 0 ? std::optional(body.mass) : std::nullopt,
          body.force};
}

/// Membranes, whose segments are boundaries, move as they are.
void leave_membranes(const SampleIn<3>& /*sample*/, std::vector<BoundaryMotionIn<3>>& /*motions*/) {}
void leave_membranes(const Sample& s, std::vector<BoundaryMotion>& motions) {
  for (const Membrane& m : the<Membranes>(s).list) motions[m.boundary] = motion_now(s, m.boundary);
}

}  // namespace

template <int D> void check_still_cell(const SampleIn<D>& s, const WallDrivesIn<D>& drives, bool sheared) {
  if (the<BoundariesIn<D>>(s).body.empty()) return;
  for (int side = 0; side < sides_in<D>; ++side)
    if (s.domain.is_periodic(side) && drives[side].kind != WallDrive::Kind::fixed)
      throw InputError(
          fmt::format("the {} side is periodic and cannot move, because the boundaries would no longer fit the cell; "
                      "leave it fixed",
                      any_side_names[side]));
  if (sheared) throw InputError("a periodic cell with boundaries cannot be sheared; move the boundaries, or a wall");
}

template <int D>
void set_boundaries(SampleIn<D>& s, const std::vector<BoundaryMotionIn<D>>& named, const ThreadPool& pool) {
  auto& boundaries = s.domain.boundaries;
  std::vector<BoundaryMotionIn<D>> motions = motions_of<D>(boundaries, named);
  leave_membranes(s, motions);
  bool changed = false, others_there = false;
  for (std::size_t b = 0; b < motions.size(); ++b) {
    changed |= motions[b] != motion_now(s, b);
    others_there |= motions[b].absent == boundaries[b].present;
    if (motions[b].mass && !integrator_of(s).moves_bodies)
      throw InputError(fmt::format("boundary \"{}\" has a mass, which {} cannot move; use {}", motions[b].name,
                                   integrator_of(s).word.word, integrators_of_bodies("")));
  }
  if (!changed) return;
  synchronise(s);
  book_change(s, &Energies::work_walls, &Energies::kinetic, [&] {
    for (std::size_t b = 0; b < motions.size(); ++b) {
      const BoundaryMotionIn<D>& motion = motions[b];
      const bool goes_on = motion.mass && the<BoundariesIn<D>>(s).body[b].mass > 0;
      if (!goes_on) boundaries[b].velocity = motion.velocity;
      the<BoundariesIn<D>>(s).body[b] = {motion.mass.value_or(0), motion.force, boundaries[b].velocity};
      boundaries[b].spin = motion.spin;
      boundaries[b].centre = *motion.centre;
      boundaries[b].present = !motion.absent;
    }
  });
  if (others_there) list_anew(s, pool);
  else the<BoundariesIn<D>>(s).add_forces(s);
}

#define ARENITE_OF(D)                                                               \
  template void check_still_cell(const SampleIn<D>&, const WallDrivesIn<D>&, bool); \
  template void set_boundaries(SampleIn<D>&, const std::vector<BoundaryMotionIn<D>>&, const ThreadPool&);
ARENITE_OF(2)
ARENITE_OF(3)
#undef ARENITE_OF

}  // namespace arenite::dem
