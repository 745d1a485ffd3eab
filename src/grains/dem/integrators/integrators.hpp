#pragma once
#include <array>
#include <string>
#include <string_view>

#include "core/parameters.hpp"
#include "core/threads.hpp"
#include "grains/dem/sample.hpp"

namespace arenite::dem {

/// One scheme for Newton's equations: a file beside this one, and its name in ARENITE_INTEGRATORS (parameters.hpp).
struct Integrator {
  Word word;
  /// Takes the forces at t_n in the sample to positions and seen velocities at t_{n+1}; walls and affine motion too. False if the contact list has
  /// become stale.
  bool (*sweep)(Sample&, const ThreadPool&);
  /// Finds starting values from a state whose velocities are those of its places; null where none are needed.
  void (*start)(Sample&);
  /// Between steps a predictor and corrector holds a predicted state, whose rates lack this share of the change of acceleration times dt/2, and its
  /// places this share of that times dt^2/2; 0 and 0 of other schemes.
  double velocity_share, position_share;
  /// Share of a step by which the places are ahead of the velocities that memories of friction are fed with.
  double lead;
  /// The stable step: p (omega dt)^2 + q lambda dt = 1 with damping lambda, and omega dt = undamped without.
  double p, q, undamped;
  /// Moves grains that are no disks, and boundaries that have a mass, too.
  bool moves_bodies;

  bool corrects() const { return velocity_share > 0; }
};

#define ARENITE_DECLARATION(name) extern const Integrator name;
ARENITE_INTEGRATORS(ARENITE_DECLARATION)
#undef ARENITE_DECLARATION

/// In the order of IntegratorKind.
#define ARENITE_ADDRESS(name) &name,
inline const std::array integrators{ARENITE_INTEGRATORS(ARENITE_ADDRESS)};
#undef ARENITE_ADDRESS
inline const Integrator& integrator_of(IntegratorKind kind) { return *integrators[static_cast<std::size_t>(kind)]; }
inline const Integrator& integrator_of(const Sample& s) { return integrator_of(s.integration.integrator); }

/// Those that move bodies, for sentences: a, b or c, each in `quotes`.
std::string integrators_of_bodies(std::string_view quotes = "\"");

/// A step that kicks the integrated velocities on by the accelerations, and then drifts with them. They are then behind the places by `lag`, and the
/// velocities that forces see are `ahead` of them, s. False if the contact list has become stale.
bool kick_and_drift(Sample& sample, const ThreadPool& pool, double lag, double ahead);

/// A step of all disks in one sweep of the kernel. To be made before the walls move, run after.
class DiskSweep {
 public:
  explicit DiskSweep(Sample& sample);
  /// Moves the disks and what goes with the cell. False if the contact list has become stale.
  bool run(Kernel::Sweep loop, const ThreadPool& pool);

  SweepTask task{};  ///< `kick` and `ahead` are the integrator's to fill in

 private:
  Sample& sample_;
  CellFrame<2> before_;
};

}  // namespace arenite::dem
