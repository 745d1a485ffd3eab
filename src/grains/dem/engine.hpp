#pragma once
#include <cstdint>
#include <memory>

#include "grains/dem/advance.hpp"
#include "grains/dem/boundaries/set_boundaries.hpp"
#include "grains/dem/bounds.hpp"
#include "grains/dem/conditions.hpp"
#include "grains/dem/glue.hpp"
#include "grains/dem/masses.hpp"
#include "grains/dem/measure.hpp"
#include "grains/dem/sample.hpp"
#include "grains/dem/save.hpp"
#include "grains/dem/stage.hpp"
#include "grains/dem/walls.hpp"

namespace arenite::dem {

/// A sample that moves, with the threads that move it. Inside, disks are sorted by place and their contacts listed;
/// what is measured has the caller's order. Same input, same kernel: same bits for any thread count. All else that is
/// done with a sample are functions of it: packing_of, energies_of, set_drives, save_sample and the like.
template <int D> class EngineIn : public SampleIn<D> {
 public:
  /// Throws InputError for a step beyond the bounds, naming the step that would do.
  EngineIn(const PackingIn<D>& start, const ContactParameters& contact, const IntegrationParameters& integration);

  /// Sets all that a stage says of the whole sample, in the order in which it takes effect: gravity, friction, masses,
  /// drag, glue, bonds, open walls, boundaries, rough walls, shear, programmes and exchange of grains. What drives the
  /// sides changes from leg to leg (drives_for).
  void begin(const Stage& stage);

  /// From one way to drive the stage under way to another: gravity, friction, drag, boundaries and shear, as far as
  /// they differ.
  void change(const Stage& before, const Stage& after);

  /// Goes on by so many steps.
  void advance(std::int64_t steps);
  const ThreadPool& pool() const { return *pool_; }

  /// Inserts and removes the grains that are due, `since` so many s.
  void exchange(const Exchange& exchange, double since);

 private:
  std::unique_ptr<ThreadPool> pool_;
};
using Engine = EngineIn<2>;

}  // namespace arenite::dem
