#include "grains/dem/conditions.hpp"

#include <fmt/core.h>

#include "core/error.hpp"
#include "grains/dem/boundaries/set_boundaries.hpp"
#include "grains/dem/measure.hpp"
#include "grains/dem/movers.hpp"

namespace arenite::dem {

template <int D> void synchronise(SampleIn<D>& s) {
  each_part(s, [&](auto& part) { part.break_step(s); });
  if (s.lag == 0 && !s.settled) return;
  // All is read before anything is set, for rates of walls hang on the places and velocities of disks.
  const DomainIn<D> now = domain_now(s);
  each_part(s, [&](auto& part) { part.note_present(s); });
  for (std::size_t k = 0; k < s.count; ++k) {
    if (is_part(s, k)) continue;
    const Motion<D> own = motion_of(s, k);
    s.record[k].place = place_of(s, k);
    s.velocity.put(k, own.velocity);
    s.omega.put(k, own.omega);
  }
  each_part(s, [&](auto& part) { part.go_to_present(s, now); });
  for (int side = 0; side < sides_in<D>; ++side) {
    s.wall[side].rate = now.wall[side].velocity;
    s.domain.wall[side].position = now.wall[side].position;
  }
  s.lag = 0;
  s.settled = false;
}

template <int D> void set_gravity(SampleIn<D>& s, Vec<D> g) {
  if (g == s.gravity) return;
  synchronise(s);
  s.gravity = g;
}

template <int D> void set_drag(SampleIn<D>& s, double rate) {
  if (rate == s.drag) return;
  if (!(rate >= 0)) throw InputError(fmt::format("drag {} 1/s must be >= 0", rate));
  synchronise(s);
  s.drag = rate;
}

template <int D> void set_friction(SampleIn<D>& s, std::optional<double> mu) {
  if (mu && !(*mu >= 0)) throw InputError(fmt::format("friction {} must be a number >= 0", *mu));
  apply_friction(s, mu);
}

template <int D> void set_shear_rate(SampleIn<D>& s, double rate) {
  if (rate == s.shear_rate) return;
  if (!s.domain.periodic[0] || !s.domain.periodic[1])
    throw InputError("a cell that is sheared must be periodic in x and y");
  check_still_cell(s, {}, true);
  synchronise(s);
  change_shear_rate(s, rate);
  refresh_ghosts(s);
}

template <int D> void change_shear_rate(SampleIn<D>& s, double rate) {
  if (rate == s.shear_rate) return;
  const double middle = 0.5 * (s.domain.wall[bottom].position + s.domain.wall[top].position);
  const double faster = rate - s.shear_rate;
  const auto faster_at = [&](double y) { return faster * (y - middle); };
  book_change(s, &Energies::work_walls, &Energies::kinetic, [&] {
    for (std::size_t k = 0; k < s.count; ++k) {
      s.velocity.along[0][k] += faster_at(s.record[k].place.y);
      s.record[k].velocity.x += faster_at(s.record[k].place.y);
    }
    s.shear_rate = rate;
    each_part(s, [&](auto& part) { part.shear(s, faster_at); });
  });
}

template void synchronise(Sample&);
template void synchronise(SampleIn<3>&);
template void set_gravity(Sample&, Vec2);
template void set_gravity(SampleIn<3>&, Vec3);
template void set_drag(Sample&, double);
template void set_drag(SampleIn<3>&, double);
template void set_friction(Sample&, std::optional<double>);
template void set_friction(SampleIn<3>&, std::optional<double>);
template void set_shear_rate(Sample&, double);
template void set_shear_rate(SampleIn<3>&, double);
template void change_shear_rate(Sample&, double);
template void change_shear_rate(SampleIn<3>&, double);

}  // namespace arenite::dem
