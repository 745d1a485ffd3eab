#include <fmt/format.h>

#include "solid/peridynamics/damage.hpp"

namespace arenite::peridynamics {

std::string sentence_of(const DamageResult& r) {
  using Ending = DamageResult::Ending;
  const std::string so_far =
      fmt::format("strength {:.6g} Pa, {} bonds broken in {} solves", r.strength, r.broken.size(), r.solves);
  switch (r.ending) {
    case Ending::severed: return "the sample came apart; " + so_far;
    case Ending::dropped: return "the stress fell to the share at which the pull ends; " + so_far;
    case Ending::strain_reached: return "the largest strain was reached; " + so_far;
    case Ending::events_reached: return "the largest number of rounds was reached; " + so_far;
    case Ending::not_converged: return "a static solve did not converge; " + so_far;
    case Ending::stopped: return "stopped; " + so_far;
    case Ending::no_path: break;
  }
  return "nothing ties the bottom row to the top row";
}

}  // namespace arenite::peridynamics
