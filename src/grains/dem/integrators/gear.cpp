#include "grains/dem/integrators/gear.hpp"

#include <array>
#include <cstdint>
#include <vector>

#include "grains/dem/advance.hpp"
#include "grains/dem/movers.hpp"
#include "grains/dem/neighbours.hpp"
#include "grains/dem/walls.hpp"

namespace arenite::dem {
namespace {

/// One of the ways in which something turns.
double& component(double& turning, int /*way*/) { return turning; }
double component(const double& turning, int /*way*/) { return turning; }
double& component(Vec3& turning, int way) { return turning[way]; }
double component(const Vec3& turning, int way) { return turning[way]; }

/// One coordinate (of a disk or a wall) while the starting values are sought: derivatives 0 to 5, unscaled.
struct Path {
  double value, rate, bend, jerk = 0, snap = 0, crackle = 0;
  double at(double t) const {
    return value + t * (rate + t / 2 * (bend + t / 3 * (jerk + t / 4 * (snap + t / 5 * crackle))));
  }
  double rate_at(double t) const { return rate + t * (bend + t / 2 * (jerk + t / 3 * (snap + t / 4 * crackle))); }
  /// From accelerations at -2h, -h, h, 2h and the one in the middle.
  void fit(const std::array<double, 4>& a, double h) {
    jerk = (8 * (a[2] - a[1]) - (a[3] - a[0])) / (12 * h);
    snap = (16 * (a[2] + a[1]) - (a[3] + a[0]) - 30 * bend) / (12 * h * h);
    crackle = (a[3] - a[0] - 2 * (a[2] - a[1])) / (2 * h * h * h);
  }
};

/// What moves so: the grains' coordinates and angles, then the walls.
template <int D> class Start {
 public:
  explicit Start(SampleIn<D>& sample) : s(sample), here(s.domain) {
    for (std::size_t k = 0; k < s.count; ++k) {
      for (int axis = 0; axis < D; ++axis) path.push_back({s.record[k].place[axis], s.velocity[k][axis], 0});
      for (std::size_t way = 0; way < turnings<D>; ++way)
        path.push_back({s.angle.along[way][k], s.omega.along[way][k], 0});
    }
    for (int side = 0; side < sides_in<D>; ++side) path.push_back({here.wall[side].position, s.wall[side].rate, 0});
  }

  void run() {
    const double lag = 0.5 * s.dt;
    set_springs(-lag, 0);
    evaluate(0);
    const Turnings<D> springs = s.list.memory;
    const std::vector<SlotForce<D>> force = s.list.force;
    const std::vector<double> now = accelerations();
    for (std::size_t q = 0; q < path.size(); ++q) path[q].bend = now[q];
    const double h = 0.5 * s.dt;
    for (int round = 0; round < 3; ++round) {
      std::array<std::vector<double>, 4> a;
      std::vector<std::uint8_t> rough(s.count, 0);
      for (std::size_t n = 0; n < 4; ++n) {
        const double t = h * std::array{-2.0, -1.0, 1.0, 2.0}[n];
        s.list.memory = springs;
        set_springs(t, 0);
        evaluate(t);
        a[n] = accelerations();
        mark_changes(force, rough);
      }
      for (std::size_t q = 0; q < path.size(); ++q) {
        const bool smooth = q / ways >= s.count || !rough[q / ways];
        if (smooth) path[q].fit({a[0][q], a[1][q], a[2][q], a[3][q]}, h);
        if (!smooth) path[q].jerk = path[q].snap = path[q].crackle = 0;
      }
    }
    s.list.memory = springs;
    set_springs(0, lag);
    evaluate(0);
    set_springs(lag, lag);
    store();
  }

 private:
  static constexpr std::size_t ways = D + turnings<D>;

  void set_springs(double lead, double lag) { s.laws = choose_laws(s.contact, lead, lag); }

  void evaluate(double t) {
    s.domain = here;
    for (int side = 0; side < sides_in<D>; ++side) {
      const Path& wall = path[ways * s.count + side];
      s.domain.wall[side].position = wall.at(t);
      s.domain.wall[side].velocity = wall.rate_at(t);
    }
    each_part(s, [&](auto& part) { part.move(s, t); });
    const CellFrame<D> before = cell_frame(here), after = cell_frame(s.domain);
    const CellMotion<D> cell = cell_motion(s.domain);
    for (std::size_t k = 0; k < s.count; ++k) {
      GrainRecord<D>& d = s.record[k];
      const Path* const p = &path[ways * k];
      for (int axis = 0; axis < D; ++axis) {
        d.place[axis] = after[axis].since(before[axis]).apply(p[axis].value) + (p[axis].at(t) - p[axis].value);
        d.velocity[axis] = p[axis].rate_at(t);
      }
      d.velocity += cell.at(d.place);
      for (int way = 0; way < turnings<D>; ++way) component(d.omega, way) = p[D + way].rate_at(t);
    }
    if (s.domain.periodic[0]) s.domain.tilt *= after[0].length / before[0].length;
    s.domain.tilt += t * s.shear_rate * s.domain.extent(1);
    refresh_ghosts(s);
    compute_forces(s);
    sum_edge_forces(s);
  }

  std::vector<double> accelerations() const {
    std::vector<double> a;
    for (std::size_t k = 0; k < s.count; ++k) {
      const Acceleration<D> now = acceleration_of(s, k);
      for (int axis = 0; axis < D; ++axis) a.push_back(now.linear[axis]);
      for (int way = 0; way < turnings<D>; ++way) a.push_back(component(now.alpha, way));
    }
    for (const double of_wall : wall_accelerations(s)) a.push_back(of_wall);
    return a;
  }

  /// A contact that carries force at one time of the span and none at the other is no smooth path.
  void mark_changes(const std::vector<SlotForce<D>>& force, std::vector<std::uint8_t>& rough) const {
    for (std::size_t p = 0; p < s.list.size(); ++p) {
      const bool before = acts(force[p]), now = acts(s.list.force[p]);
      if (before == now) continue;
      rough[s.list.i[p]] = 1;
      if (s.list.owner[p] >= 0) rough[s.list.owner[p]] = 1;
    }
  }

  void store() {
    const double c3 = s.dt * s.dt * s.dt / 6, c4 = c3 * s.dt / 4, c5 = c4 * s.dt / 5;
    for (std::size_t k = 0; k < s.count; ++k)
      for (std::size_t way = 0; way < ways; ++way) {
        const Path& p = path[ways * k + way];
        (way < D ? s.acceleration.along[way] : s.alpha.along[way - D])[k] = p.bend;
        s.higher[way].put(k, Vec3{c3 * p.jerk, c4 * p.snap, c5 * p.crackle});
      }
    for (int side = 0; side < sides_in<D>; ++side) {
      const Path& p = path[ways * s.count + side];
      s.wall[side].acceleration = p.bend;
      s.wall[side].higher = {c3 * p.jerk, c4 * p.snap, c5 * p.crackle, 0.0};
    }
  }

  SampleIn<D>& s;
  const DomainIn<D> here;
  std::vector<Path> path;
};

}  // namespace

template <int D> void predict_walls(SampleIn<D>& s, double /*kick*/, double /*ahead*/) {
  const double dt = s.dt, half = 0.5 * dt * dt;
  const auto accelerations = wall_accelerations(s);
  for (int side = 0; side < sides_in<D>; ++side) {
    WallBodyIn<D>& body = s.wall[side];
    WallIn<D>& wall = s.domain.wall[side];
    const double a = accelerations[side];
    Nordsieck<double> q{wall.position,  dt * body.rate, half * body.acceleration,
                        body.higher[0], body.higher[1], body.higher[2]};
    q.correct(half * (a - body.acceleration));
    q.predict();
    wall.position = q.q0;
    wall.velocity = body.rate = q.q1 / dt;
    body.acceleration = q.q2 / half;
    body.higher = {q.q3, q.q4, q.q5, 0.0};
  }
}

template <int D> void find_derivatives(SampleIn<D>& s) {
  if (s.settled) return;
  for (auto& higher : s.higher) higher.assign(s.count);
  Start<D>(s).run();
  s.settled = true;
}

template void predict_walls(SampleIn<2>&, double, double);
template void predict_walls(SampleIn<3>&, double, double);
template void find_derivatives(SampleIn<2>&);
template void find_derivatives(SampleIn<3>&);

}  // namespace arenite::dem
