#include "grains/dem/conditions.hpp"

#include <fmt/core.h>

#include <vector>

#include "core/error.hpp"
#include "grains/dem/measure.hpp"
#include "grains/dem/movers.hpp"

namespace arenite::dem {

void synchronise(Sample& s) {
  the<EnergyBalance>(s).open = false;
  if (s.lag == 0 && !s.settled) return;
  // All is read before anything is set, for rates of walls hang on the places and velocities of disks.
  const Domain now = domain_now(s);
  the<Membranes>(s).synchronise(s);
  std::vector<Motion<2>> moved;
  for (std::size_t b = 0; b < the<Bodies>(s).body.size(); ++b) moved.push_back(motion_of(s, s.count + b));
  for (std::size_t k = 0; k < s.count; ++k) {
    if (is_part(s, k)) continue;
    const Motion<2> own = motion_of(s, k);
    s.record[k].place = place_of(s, k);
    s.velocity.put(k, own.velocity);
    s.omega[k] = own.omega;
  }
  for (std::size_t b = 0; b < the<Bodies>(s).body.size(); ++b) the<Bodies>(s).body[b].own = moved[b];
  for (std::size_t b = 0; b < the<Boundaries>(s).body.size(); ++b)
    the<Boundaries>(s).body[b].rate = s.domain.boundaries[b].velocity = now.boundaries[b].velocity;
  for (int side = 0; side < sides; ++side) {
    s.wall[side].rate = now.wall[side].velocity;
    s.domain.wall[side].position = now.wall[side].position;
  }
  s.lag = 0;
  s.settled = false;
}

void set_gravity(Sample& s, Vec2 g) {
  if (g.x == s.gravity.x && g.y == s.gravity.y) return;
  synchronise(s);
  s.gravity = g;
}

void set_drag(Sample& s, double rate) {
  if (rate == s.drag) return;
  if (!(rate >= 0)) throw InputError(fmt::format("drag {} 1/s must be >= 0", rate));
  synchronise(s);
  s.drag = rate;
}

void set_friction(Sample& s, std::optional<double> mu) {
  if (mu && !(*mu >= 0)) throw InputError(fmt::format("friction {} must be a number >= 0", *mu));
  apply_friction(s, mu);
}

void set_shear_rate(Sample& s, double rate) {
  if (rate == s.shear_rate) return;
  if (!s.domain.periodic[0] || !s.domain.periodic[1])
    throw InputError("a cell that is sheared must be periodic in x and y");
  check_still_cell(s, {}, true);
  synchronise(s);
  change_shear_rate(s, rate);
  refresh_ghosts(s);
}

void change_shear_rate(Sample& s, double rate) {
  if (rate == s.shear_rate) return;
  const double middle = 0.5 * (s.domain.wall[bottom].position + s.domain.wall[top].position);
  const auto faster_at = [&](double y) { return (rate - s.shear_rate) * (y - middle); };
  book_change(s, &Energies::work_walls, &Energies::kinetic, [&] {
    for (std::size_t k = 0; k < s.count; ++k) {
      s.velocity.along[0][k] += faster_at(s.record[k].place.y);
      s.record[k].velocity.x += faster_at(s.record[k].place.y);
    }
    for (Body& b : the<Bodies>(s).body) {
      b.own.velocity.x += faster_at(b.place.y);
      b.seen.velocity.x += faster_at(b.place.y);
    }
    s.shear_rate = rate;
    place_parts(s);
  });
}

}  // namespace arenite::dem
