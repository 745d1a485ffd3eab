#include <algorithm>
#include <atomic>
#include <cmath>
#include <utility>

#include "grains/dem/bodies/bodies.hpp"
#include "grains/dem/forces.hpp"
#include "model/shapes.hpp"

namespace arenite::dem {
namespace {

/// What the image of a place some cells on adds to place and velocity.
struct Image {
  Vec2 place, velocity;
};
Image image_of(const Sample& s, const BodyDisk& part) {
  const double width = s.domain.width(), height = s.domain.height();
  const double stretch_x = s.domain.periodic_x ? s.domain.wall[right].velocity - s.domain.wall[left].velocity : 0;
  const double stretch_y = s.domain.periodic_y ? s.domain.wall[top].velocity - s.domain.wall[bottom].velocity : 0;
  return {{part.shift_x * width + part.shift_y * s.domain.tilt, part.shift_y * height},
          {part.shift_x * stretch_x + part.shift_y * (s.domain.tilt * stretch_x / width + s.shear_rate * height), part.shift_y * stretch_y}};
}

template <class Use> void for_parts(const Sample& s, const Body& b, Use use) {
  for (auto d = static_cast<std::size_t>(b.first); d < static_cast<std::size_t>(b.first + b.count); ++d) use(d, static_cast<std::size_t>(s.part_disk[d]));
}

void place_parts_of(Sample& s, const Body& b) {
  const Vec2 by = direction(b.angle);
  for_parts(s, b, [&](std::size_t d, std::size_t k) {
    const BodyDisk& part = s.part[d];
    const Vec2 arm = turned({part.x, part.y}, by);
    Image image;
    if (part.shift_x != 0 || part.shift_y != 0) image = image_of(s, part);
    s.lever[k] = arm;
    DiskRecord& disk = s.record[k];
    disk.x = b.x + arm.x + image.place.x;
    disk.y = b.y + arm.y + image.place.y;
    s.vx[k] = disk.vx = b.seen_x - b.seen_omega * arm.y + image.velocity.x;
    s.vy[k] = disk.vy = b.seen_y + b.seen_omega * arm.x + image.velocity.y;
    s.omega[k] = disk.omega = b.seen_omega;
    s.angle[k] = b.angle;
  });
}

struct BodyAcceleration {
  double ax, ay, alpha;
};
BodyAcceleration acceleration_of(const Sample& s, const Body& b) {
  const BodyLoad load = load_on(s, b);
  const AffineMotion mx = affine_x(s.domain), my = affine_y(s.domain);
  return {load.force.x / b.mass + s.gravity.x - s.drag * (b.seen_x - mx.at(b.x)), load.force.y / b.mass + s.gravity.y - s.drag * (b.seen_y - my.at(b.y)),
          s.integration.rotations ? load.torque / b.inertia() : 0.0};
}

/// The step of integrators/verlet.cpp for a body.
void move(const Sample& s, const SweepTask& t, Body& b) {
  const BodyLoad load = load_on(s, b);
  const double ax = load.force.x / b.mass + t.x.gravity - t.drag * (b.seen_x - t.x.before.at(b.x));
  const double ay = load.force.y / b.mass + t.y.gravity - t.drag * (b.seen_y - t.y.before.at(b.y));
  const double alpha = t.turning * load.torque / b.inertia();
  b.vx += t.kick * ax;
  b.vy += t.kick * ay;
  b.omega += t.kick * alpha;
  b.angle += t.dt * b.omega;
  b.x = t.x.moved.apply(b.x) + t.dt * (1 + 0.5 * t.x.growth) * b.vx;
  b.y = t.y.moved.apply(b.y) + t.dt * (1 + 0.5 * t.y.growth) * b.vy;
  b.seen_x = b.vx + t.ahead * ax + t.x.after.at(b.x);
  b.seen_y = b.vy + t.ahead * ay + t.y.after.at(b.y);
  b.seen_omega = b.omega + t.ahead * alpha;
}

/// Whether the disks of a body are near enough to their places in the list.
bool are_near(const Sample& s, const SweepTask& t, const Body& b) {
  bool near = true;
  for_parts(s, b, [&](std::size_t, std::size_t k) {
    const DiskRecord& d = s.record[k];
    const double y_then = t.y.listed.apply(t.listed_y[k]);
    const double dx = d.x - t.x.listed.apply(t.listed_x[k]) - t.listed_shear * (y_then - t.middle), dy = d.y - y_then;
    near = near && dx * dx + dy * dy <= t.limit;
  });
  return near;
}

}  // namespace

BodyLoad load_on(const Sample& s, const Body& b) {
  BodyLoad sum;
  for_parts(s, b, [&](std::size_t, std::size_t k) {
    const Load load = contact_load(s.list, k);
    const Vec2 force{load.fx, load.fy};
    sum.force += force;
    sum.torque += load.torque + cross(s.lever[k], force);
  });
  return sum;
}

void number_parts(Sample& s) {
  if (s.part.empty()) return;
  for (std::size_t k = 0; k < s.count; ++k) s.part_disk[static_cast<std::size_t>(s.record[k].grain)] = static_cast<std::int32_t>(k);
  for (const Body& b : s.body) {
    const Vec2 by = direction(b.angle);
    for_parts(s, b, [&](std::size_t d, std::size_t k) { s.lever[k] = turned({s.part[d].x, s.part[d].y}, by); });
  }
}

void drop_own_disks(const Sample& s, std::size_t k, std::vector<std::int32_t>& partner, std::size_t from) {
  const std::int32_t own = body_of(s, s.record[k].grain);
  const auto is_corner = [&](std::int32_t body) { return body >= 0 && s.body[static_cast<std::size_t>(body)].filled != 0; };
  const bool corner = is_corner(own);
  const auto is_own = [&](std::int32_t j) {
    const std::int32_t other = body_of(s, s.record[static_cast<std::size_t>(j)].grain);
    return corner || (own >= 0 && other == own) || is_corner(other);
  };
  partner.erase(std::remove_if(partner.begin() + static_cast<std::ptrdiff_t>(from), partner.end(), is_own), partner.end());
}

bool move_bodies(Sample& s, const SweepTask& t, const Team& team) {
  if (s.body.empty()) return true;
  std::atomic<bool> near = true;
  team.for_ranges(s.body.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t b = begin; b < end; ++b) {
      move(s, t, s.body[b]);
      place_parts_of(s, s.body[b]);
      if (!are_near(s, t, s.body[b])) near = false;
    }
  });
  return near;
}

void place_parts(Sample& s) {
  for (const Body& b : s.body) place_parts_of(s, b);
}

namespace {

void wrap_centre(Sample& s, Body& b) {
  const auto& w = s.domain.wall;
  const double width = s.domain.width(), height = s.domain.height();
  const AffineMotion mx = affine_x(s.domain), my = affine_y(s.domain);
  if (s.domain.periodic_y) {
    const double n = std::floor((b.y - w[bottom].position) / height), y = b.y - n * height, faster = -n * s.shear_rate * height;
    b.seen_y += my.at(y) - my.at(b.y);
    b.y = y;
    b.x -= n * s.domain.tilt;
    if (n != 0 && s.integration.track_energy) s.tally.work_walls += 0.5 * b.mass * faster * (2 * b.vx + faster);
    b.vx += faster;
    b.seen_x += faster;
  }
  if (s.domain.periodic_x) {
    const double x = b.x - std::floor((b.x - w[left].position) / width) * width;
    b.seen_x += mx.at(x) - mx.at(b.x);
    b.x = x;
  }
}

/// Cells between a disk and its body's centre, so that both lie in the cell.
void wrap_part(const Sample& s, const Body& b, Vec2 by, BodyDisk& part) {
  const auto& w = s.domain.wall;
  const Vec2 arm = turned({part.x, part.y}, by);
  if (s.domain.periodic_y) part.shift_y = -static_cast<std::int32_t>(std::floor((b.y + arm.y - w[bottom].position) / s.domain.height()));
  if (s.domain.periodic_x)
    part.shift_x = -static_cast<std::int32_t>(std::floor((b.x + arm.x + part.shift_y * s.domain.tilt - w[left].position) / s.domain.width()));
}

}  // namespace

void wrap_bodies(Sample& s) {
  for (Body& b : s.body) {
    wrap_centre(s, b);
    const Vec2 by = direction(b.angle);
    for_parts(s, b, [&](std::size_t d, std::size_t) { wrap_part(s, b, by, s.part[d]); });
  }
  place_parts(s);
}

Motion motion_of(const Sample& s, const Body& b) {
  if (s.lag == 0) return {b.vx, b.vy, b.omega};
  const BodyAcceleration a = acceleration_of(s, b);
  return {b.vx + s.lag * a.ax, b.vy + s.lag * a.ay, b.omega + s.lag * a.alpha};
}

double kinetic_energy(const Sample& s, const Body& b) {
  const Motion v = motion_of(s, b);
  return 0.5 * b.mass * (v.vx * v.vx + v.vy * v.vy) + 0.5 * b.inertia() * v.omega * v.omega;
}

Vec2 between_centres(const Sample& s, std::size_t slot, Vec2 branch) {
  if (s.part.empty()) return branch;
  return branch - own_lever(s, slot) + partner_lever(s, slot);
}

void put_body(const Sample& s, const Body& b, const AffineMotion& mx, const AffineMotion& my, Grains& grains) {
  const auto g = static_cast<std::size_t>(s.part[static_cast<std::size_t>(b.first)].grain);
  const Motion v = motion_of(s, b);
  grains.x[g] = b.x;
  grains.y[g] = b.y;
  grains.angle[g] = b.angle;
  grains.vx[g] = v.vx + mx.at(b.x);
  grains.vy[g] = v.vy + my.at(b.y);
  grains.omega[g] = v.omega;
}

void add_levers(const Sample& s, std::size_t slot, bool swapped, Contacts& contacts) {
  Vec2 i = own_lever(s, slot), j = partner_lever(s, slot);
  if (swapped) std::swap(i, j);
  contacts.off_i_x.push_back(i.x);
  contacts.off_i_y.push_back(i.y);
  contacts.off_j_x.push_back(j.x);
  contacts.off_j_y.push_back(j.y);
}

}  // namespace arenite::dem
