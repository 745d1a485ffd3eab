#include "grains/dem/advance.hpp"

#include "grains/dem/forces.hpp"
#include "grains/dem/movers.hpp"
#include "grains/dem/neighbours.hpp"
#include "grains/dem/walls.hpp"

namespace arenite::dem {

template <int D> void advance(SampleIn<D>& s, const ThreadPool& pool, std::int64_t steps) {
  if (steps <= 0) return;
  each_part(s, [&](auto& part) { part.prepare(s); });
  if (const auto start = std::get<OwnSteps<D>>(integrator_of(s).own).start) start(s);
  bool edges = s.integration.track_energy;
  for (int side = 0; side < sides_in<D>; ++side)
    edges |= !s.domain.wall[side].present && s.wall[side].drive.kind == DriveKind::force;
  each_part(s, [&](auto& part) { part.begin(s); });
  for (std::int64_t n = 0; n < steps; ++n) {
    each_part(s, [&](auto& part) { part.before_step(s); });
    const bool near = make_step(s, pool);
    each_part(s, [&](auto& part) { part.after_step(s); });
    follow_drift(s);
    if (near) refresh_ghosts(s);
    else rebuild_list(s, pool);
    compute_forces(s, pool);
    if (edges) sum_edge_forces(s, pool);
    each_part(s, [&](auto& part) { part.after_forces(s); });
  }
  sum_edge_forces(s, pool);
}

template void advance(SampleIn<2>&, const ThreadPool&, std::int64_t);
template void advance(SampleIn<3>&, const ThreadPool&, std::int64_t);

}  // namespace arenite::dem
