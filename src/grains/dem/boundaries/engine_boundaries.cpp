#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "core/error.hpp"
#include "grains/dem/bodies/bodies.hpp"
#include "grains/dem/boundaries/boundaries.hpp"
#include "grains/dem/forces.hpp"
#include "grains/dem/neighbours.hpp"
#include "grains/dem/setup.hpp"
#include "grains/dem/walls.hpp"

namespace arenite::dem {

void list_anew(Sample& s, const ThreadPool& pool) {
  book_change(s, &Energies::work_walls, &Energies::elastic, [&] {
    rebuild_list(s, pool);
    s.laws.lead = -s.laws.lag;
    compute_forces(s, pool);
    s.laws = laws_between_steps(s);
  });
}

namespace {

void check_opening(const Sample& s, int side, bool open) {
  if (open && s.domain.is_periodic(side))
    throw InputError(fmt::format("the {} side is periodic and has no wall that could be open", side_names[side]));
  std::size_t beyond = 0;
  for (std::size_t k = 0; k < s.count; ++k) beyond += s.domain.depth(side, s.record[k].place) < 0;
  if (!open && beyond > 0)
    throw InputError(
        fmt::format("the {} wall cannot be restored, because {} grains are beyond it; leave that side open",
                    side_names[side], beyond));
}

/// Grains nearer to a rough wall than half their radius go with it from now on; one that was held before stays.
void hold_nearest(Sample& s) {
  std::vector<HeldGrain> held;
  for (std::size_t k = 0; k < s.count; ++k) {
    const DiskRecord& d = s.record[k];
    const HeldGrain* before = find_held(s, d.grain);
    for (int side = 0; side < sides; ++side) {
      const double plane = s.domain.wall[side].position, slid = s.wall[side].slid;
      if (!s.wall[side].rough || (before ? before->side != side : s.domain.depth(side, d.place) > 1.5 * d.radius))
        continue;
      held.push_back({d.grain, side, d.place - of_side(side, plane, slid)});
      break;
    }
  }
  std::sort(held.begin(), held.end(), [](const HeldGrain& a, const HeldGrain& b) { return a.grain < b.grain; });
  s.held = std::move(held);
  number_held(s);
  hold_grains(s);
}

/// How each boundary is to move.
std::vector<BoundaryMotion> motions_of(const std::vector<Boundary>& boundaries,
                                       const std::vector<BoundaryMotion>& named) {
  std::vector<BoundaryMotion> motions;
  for (const Boundary& boundary : boundaries) motions.push_back({boundary.name, {}, 0, mean_point(boundary.points)});
  for (const BoundaryMotion& motion : named) {
    const std::size_t at = index_of(boundaries, motion.name);
    if (at == boundaries.size())
      throw InputError(fmt::format("boundary \"{}\" is to move, but does not exist", motion.name));
    const auto mean = motions[at].centre;
    motions[at] = motion;
    if (!motion.centre) motions[at].centre = mean;
  }
  return motions;
}

BoundaryMotion motion_now(const Sample& s, std::size_t b) {
  const Boundary& now = s.domain.boundaries[b];
  const BoundaryBody& body = s.boundary[b];
  return {now.name,   now.velocity, now.spin,
          now.centre, !now.present, body.mass > 0 ? std::optional(body.mass) : std::nullopt,
          body.force};
}

}  // namespace

void Engine::set_rough(const BySide<bool>& rough) {
  Sample& s = machine_->sample;
  if (std::ranges::equal(rough, s.wall, {}, {}, &WallBody::rough)) return;
  if (!s.part.empty())
    throw InputError("rough walls work with disks only; use smooth walls with friction for clumps and polygons");
  synchronise(s);
  for (int side = 0; side < sides; ++side) s.wall[side].rough = rough[side] && s.domain.wall[side].present;
  hold_nearest(s);
  list_anew(s, machine_->pool);
}

void Engine::set_open(const BySide<bool>& open) {
  Sample& s = machine_->sample;
  if (std::ranges::equal(open, s.wall, {}, {}, &WallBody::open)) return;
  for (int side = 0; side < sides; ++side)
    if (open[side] != s.wall[side].open) check_opening(s, side, open[side]);
  synchronise(s);
  for (int side = 0; side < sides; ++side) {
    s.wall[side].open = open[side];
    if (open[side]) s.domain.wall[side].force = s.domain.wall[side].shear_force = 0;
  }
  apply_open(s);
  list_anew(s, machine_->pool);
}

void Engine::set_boundaries(const std::vector<BoundaryMotion>& named) {
  Sample& s = machine_->sample;
  auto& boundaries = s.domain.boundaries;
  const std::vector<BoundaryMotion> motions = motions_of(boundaries, named);
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
      const BoundaryMotion& motion = motions[b];
      const bool goes_on = motion.mass && s.boundary[b].mass > 0;
      if (!goes_on) boundaries[b].velocity = motion.velocity;
      s.boundary[b] = {motion.mass.value_or(0), motion.force, boundaries[b].velocity};
      boundaries[b].spin = motion.spin;
      boundaries[b].centre = *motion.centre;
      boundaries[b].present = !motion.absent;
    }
  });
  if (others_there) list_anew(s, machine_->pool);
  else sum_boundary_forces(s);
}

void Engine::set_programmes(Programmes programmes) {
  Sample& s = machine_->sample;
  const auto& boundaries = s.domain.boundaries;
  WallDrives drives;
  bool sheared = false;
  for (const Programme& p : programmes.list) {
    if (p.drives_side()) drives[p.side()].kind = WallDrive::Kind::velocity;
    sheared |= p.of == Programme::shear_rate;
    if (!p.drives_boundary()) continue;
    const std::size_t at = index_of(boundaries, p.name);
    if (at == boundaries.size())
      throw InputError(fmt::format("a programme drives boundary \"{}\", which does not exist", p.name));
    BoundaryBody& body = s.boundary[at];
    if (p.is_of_force() != (body.mass > 0) && p.boundary_axis() < 2)
      throw InputError(fmt::format("boundary \"{}\" {} a mass; a table can give {}", p.name,
                                   body.mass > 0 ? "has" : "does not have",
                                   body.mass > 0 ? "the force on it" : "its position or velocity"));
    if (!p.is_of_force()) continue;
    synchronise(s);
    (p.boundary_axis() == 0 ? body.force.x : body.force.y) = p.at(0);
  }
  check_still_cell(s, drives, sheared);
  s.programmes = std::move(programmes);
}

Amount Engine::below(double height) const {
  const Sample& s = machine_->sample;
  Amount amount;
  each_mover(s, [&](std::size_t k) {
    if (!(mover_at(s, k).place.y < height)) return;
    ++amount.grains;
    amount.mass += k < s.count ? own_mass(s, s.record[k].grain) : own_mass(s, s.body[k - s.count].first);
  });
  return amount;
}

}  // namespace arenite::dem
