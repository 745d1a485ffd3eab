#pragma once
#include "core/parameters.hpp"

namespace arenite::workflow {

/// How often what takes long is kept on its way.
struct Checkpoints {
  double every = 30;  ///< s
  static constexpr Range allowed = range::between(0, 1e9);
};
inline void declare(ParameterVisitor& visitor, Checkpoints& of) {
  visitor.number({"checkpoint_every", "Seconds between two checkpoints of a run."}, of.every, "", Checkpoints::allowed);
}

}  // namespace arenite::workflow
