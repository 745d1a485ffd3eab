// Spheres in lasting contact: springs that turn with it, a wall that slides, rolling resistance, against closed forms.
#include "spheres.hpp"

namespace arenite::verification {
namespace {

/// Two spheres in touch with a spring between them, placed and turned by the test, which asks for their forces step by
/// step.
struct Held : Collision {
  double kt = 0.5 * 1e12, distance = 0.999 * 0.023;
  Vec3 aside;  ///< at right angles to n and t
  SampleIn<3> s;
  std::size_t a = 0, b = 1;  ///< inner numbers

  explicit Held(Vec3 spring) {
    contact.friction_law = CundallStrack{};
    contact.friction = 1e9;
    contact.tangential_stiffness_ratio = 0.5;
    approach();
    s = sample();
    if (s.record[0].grain != 0) std::swap(a, b);
    aside = cross(t, n);
    put(n, 0, {});
    s.list.memory.put(0, spring);
  }
  void put(Vec3 normal, double spin, Vec3 rest) {
    s.record[a].place = s.record[b].place + distance * normal;
    for (auto& sphere : s.record) sphere.velocity = rest, sphere.omega = spin * normal;
  }
  /// On the first sphere.
  Vec3 force() {
    compute_forces(s);
    return (s.list.i[0] == static_cast<std::int32_t>(a) ? 1.0 : -1.0) * s.list.force[0].on_i;
  }
};

/// A pair that turns as one body slides nowhere, and the force of its spring turns with it.
TEST(ThirdDimension, ASpringGoesAlongWithAContactThatTurns) {
  const Collision of;
  const double along = 1e-5, across = 2e-5, turn = 1.5;
  Held h(along * of.t + across * cross(of.t, of.n));
  constexpr int steps = 3000;
  Vec3 n, force;
  for (int step = 0; step <= steps; ++step) {
    const double angle = turn * step / steps;
    n = std::cos(angle) * h.n + std::sin(angle) * h.aside;
    h.put(n, 0, {});
    force = h.force();
  }
  const Vec3 sideways = std::cos(turn) * h.aside - std::sin(turn) * h.n;
  const Vec3 tangential = force - dot(force, n) * n;
  expect_near(tangential, -h.kt * cross(along * h.t + across * sideways, n),
              5e-4 * h.kt * across);  // laid down step by step, of first order in its turn
}

/// Spheres that spin about the normal as one take the force of the spring around with them; those that spin against
/// each other do not.
TEST(ThirdDimension, ASpringTurnsWithTheTwistThatBothSpheresHave) {
  const Collision of;
  const double length = 2e-5, turn = 1.5;
  constexpr int steps = 3000;
  Held h(length * of.t), against(length * of.t);
  const double spin = turn / (steps * h.s.dt);
  Vec3 force, still;
  for (int step = 0; step < steps; ++step) {
    h.put(h.n, spin, {});
    force = h.force();
    against.put(h.n, spin, {});
    against.s.record[against.b].omega = -spin * h.n;
    still = against.force();
  }
  const double last = turn * (1 - 0.5 / steps);  // the spring turns on by half a step after the force
  const Vec3 spring = std::cos(last) * h.t + std::sin(last) * cross(h.n, h.t);
  expect_near(force - dot(force, h.n) * h.n, -h.kt * length * cross(spring, h.n), 1e-6 * h.kt * length);
  expect_near(still - dot(still, h.n) * h.n, -h.kt * length * cross(h.t, h.n), 1e-9 * h.kt * length);
}

/// A sphere on the lowest wall, under its weight.
struct OnWall : Spheres {
  static constexpr double g = 9.81, radius = 0.01;
  SampleIn<3> s;

  OnWall() : Spheres(1e7) {
    contact.friction_law = CundallStrack{};
    contact.friction = 0.3;
    add(radius, {0.02, 0.03, radius});
    start.grains.position[0].z -= mass(0) * g / 1e7;
  }
  void begin(Vec3 velocity = {}, Vec3 omega = {}) {
    start.grains.velocity[0] = velocity;
    start.grains.omega[0] = omega;
    s = sample();
    s.gravity = {0, 0, -g};
  }
  void go_on(double time) { advance(s, ThreadPool(), static_cast<std::int64_t>(time / s.dt)); }
};

/// It slides and is carried along, until it rolls: with 2/7 of the wall's velocity.
TEST(ThirdDimension, AWallThatSlidesCarriesASphereAlong) {
  OnWall c;
  c.begin();
  const Vec3 slide{0.12, 0.05, 0};
  c.s.wall[low_z].drive.slide = slide;
  const double push = c.contact.friction * c.mass(0) * OnWall::g,
               until = 2 * norm(slide) / (7 * c.contact.friction * OnWall::g);
  c.go_on(0.5 * until);
  expect_near(c.s.domain.wall[low_z].shear_force, -push / norm(slide) * slide, 1e-3 * push);
  EXPECT_NEAR(c.s.domain.wall[low_z].force, c.mass(0) * OnWall::g, 1e-6 * c.mass(0) * OnWall::g);
  expect_near(packing_of(c.s).grains.velocity[0], 1.0 / 7 * slide, 1e-3 * norm(slide));
  c.go_on(1.5 * until);
  const GrainsIn<3> end = packing_of(c.s).grains;
  expect_near(end.velocity[0], 2.0 / 7 * slide, 1e-3 * norm(slide));
  expect_near(end.omega[0], 5.0 / 7 / OnWall::radius * cross(slide, {0, 0, 1}), 1e-3 * norm(slide) / OnWall::radius);
}

/// Rolling resistance of mu_r r F_n takes 5/7 mu_r g of its speed; a spin about the normal is none that it resists.
TEST(ThirdDimension, RollingResistanceBrakesASphere) {
  for (const bool elastic : {false, true}) {
    OnWall c;
    c.contact.rolling = ConstantTorque{0.02};
    if (elastic) c.contact.rolling = ElasticPlasticRolling{0.02};
    const Vec3 velocity{0.06, 0.08, 0}, twist{0, 0, 5};
    c.begin(velocity, twist + 1 / OnWall::radius * cross({0, 0, 1}, velocity));
    c.go_on(0.2);
    const double time = static_cast<double>(c.s.step) * c.s.dt, left = 0.1 - 5.0 / 7 * 0.02 * OnWall::g * time;
    const GrainsIn<3> end = packing_of(c.s).grains;
    expect_near(end.velocity[0], left / 0.1 * velocity, 3e-3 * left);
    EXPECT_NEAR(end.omega[0].z, twist.z, 1e-9);
  }
}

/// Resistance to twisting of mu_t r F_n stops a spin about the normal in 2/5 r omega/(mu_t g); a spring of it then
/// holds the sphere, and lets it swing back where the spin was within its limit.
TEST(ThirdDimension, TwistingResistanceStopsASpinAboutTheNormal) {
  for (const bool elastic : {false, true}) {
    OnWall c;
    c.contact.rolling = ConstantTorque{0.02, 0.05};
    if (elastic) c.contact.rolling = ElasticPlasticRolling{0.02, 0.3, 0.05};
    const double spin = 20, stops = 0.4 * OnWall::radius * spin / (0.05 * OnWall::g);
    c.begin({}, {0, 0, spin});
    c.go_on(0.5 * stops);
    const double time = static_cast<double>(c.s.step) * c.s.dt;
    EXPECT_NEAR(packing_of(c.s).grains.omega[0].z, spin * (1 - time / stops), 2e-3 * spin);
    c.go_on(0.52 * stops);
    EXPECT_NEAR(packing_of(c.s).grains.omega[0].z, 0, 2e-3 * spin);
  }
}

}  // namespace
}  // namespace arenite::verification
