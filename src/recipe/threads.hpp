#pragma once
#include <cstdint>

#include "core/parameters.hpp"

namespace arenite::recipe {

/// What every computation may be given beside its recipe.
struct Threads {
  std::int64_t threads = 1;
};
inline void declare(ParameterVisitor& visitor, Threads& of) {
  visitor.integer({"threads", "Threads, in each run of a study; the results do not depend on their number."},
                  of.threads, {1, 1024});
}

}  // namespace arenite::recipe
