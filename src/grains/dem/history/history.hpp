#pragma once
#include <cstdint>

#include "grains/dem/engine.hpp"
#include "grains/dem/stage.hpp"
#include "model/result.hpp"

namespace arenite::dem {

/// Adds a value to a column of that name, which is made if there is none.
void append(History& history, const char* name, const char* unit, double value);

/// A look at a stage under way.
template <int D> struct LookIn {
  const EngineIn<D>& engine;
  const Stage& stage;
  const Equilibrium& now;
  std::int64_t increment = 0;  ///< from 0
};
/// Adds what it finds as a row.
template <int D> void add_row(History& history, const LookIn<D>& look);

/// The columns that the history of such a stage will have, in a container with these boundaries, as a row of zeros.
template <int D> History history_columns(const Stage& stage, const DomainIn<D>& domain, bool bonded, bool cohesive);

}  // namespace arenite::dem
