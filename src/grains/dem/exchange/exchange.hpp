#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/vec.hpp"
#include "grains/packing/population.hpp"

namespace arenite::dem {

/// A part of the plane with upright edges, m; without one it goes on to the side of the container, or for ever.
struct Area {
  std::optional<double> left, right, bottom, top;
  bool operator==(const Area&) const = default;

  bool holds(Vec2 place) const {
    return !(left && place.x < *left) && !(right && place.x > *right) && !(bottom && place.y < *bottom) &&
           !(top && place.y > *top);
  }
  bool is_bounded() const { return left || right || bottom || top; }
  void declare(ParameterVisitor& visitor);
};

/// Where grains come in during a stage, not turning.
struct Inflow {
  Area area;  ///< they lie within it as far as they fit; else in its middle, so that it may be a line
  std::optional<double> rate, mass_rate;  ///< one of them: grains per s, or kg/s
  Vec2 velocity;                          ///< m/s
  std::string material;                   ///< of the populations that they are drawn from; empty: any
  std::optional<std::int64_t> count;      ///< no more than so many in the stage
  std::vector<packing::Population> of;    ///< these populations, in the shares of their numbers
  bool operator==(const Inflow&) const = default;
  void declare(ParameterVisitor& visitor);
};

/// Where grains leave: one whose centre is in the area when it is looked at is taken out, or put back elsewhere once
/// there is room for it.
struct Outlet {
  Area area;
  std::optional<Area> recycle_to;
  Vec2 velocity;  ///< of grains put back, m/s
  bool operator==(const Outlet&) const = default;
  void declare(ParameterVisitor& visitor);
};

/// How grains are inserted and removed in a stage.
struct Exchange {
  std::vector<Inflow> inflow;
  std::vector<Outlet> outlets;
  std::uint64_t seed = 1;  ///< of sizes and places
  bool operator==(const Exchange&) const = default;

  bool is_none() const { return inflow.empty() && outlets.empty(); }
};

/// Grains and their mass, kg.
struct Batch {
  std::int64_t grains = 0;
  double mass = 0;
  void add(double m) {
    ++grains;
    mass += m;
  }
};

/// What came into a sample and left it.
struct ExchangeAccount {
  bool kept = false;           ///< some stage exchanges grains, so that states have them all and this account
  std::int64_t next_id = 0;    ///< of the grain that comes next; ids are never used again
  std::int64_t first_id = 0;   ///< the same as the stage under way began
  std::int64_t tries = 0;      ///< places looked at so far
  Batch inserted, removed;     ///< in the stage under way; grains put back count as both
  std::int64_t waiting = 0;    ///< grains for which there was no room at the last look
  std::vector<Batch> through;  ///< each inflow of the stage
};

}  // namespace arenite::dem
