#pragma once
#include "core/parameters.hpp"

namespace arenite {

/// What every computation may be given beside its recipe.
struct Threads {
  int threads = 1;
};
inline void declare(ParameterVisitor& visitor, Threads& of) {
  visitor.integer({"threads", "Threads, in each run of a study; the results do not depend on their number."},
                  of.threads, {1, 1024});
}

}  // namespace arenite
