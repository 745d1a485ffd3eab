#include "solid/peridynamics/damage.hpp"

#include <fmt/format.h>

#include <cmath>

#include "core/error.hpp"
#include "solid/peridynamics/pull.hpp"

namespace arenite::peridynamics {

namespace {

void check(const DamageOptions& o) {
  const auto positive = [](double value, const char* what) {
    if (!(value > 0) || !std::isfinite(value))
      throw InputError(fmt::format("the {} of a pull to failure is {:g}; give a positive one", what, value));
  };
  positive(o.tolerance, "tolerance");
  positive(o.max_strain, "largest strain");
  if (!(o.end_stress >= 0) || !(o.end_stress < 1))
    throw InputError(fmt::format("the share of the strength at which a pull ends is {:g}; give one from 0 to below 1",
                                 o.end_stress));
  if (!(o.band >= 0) || !(o.band < 1))
    throw InputError(fmt::format("the band of bonds that break together is {:g}; give one from 0 to below 1", o.band));
}

}  // namespace

DamageResult pull_to_failure(const PhaseMap& map, const DamageOptions& options) {
  check(options);
  Pull pull(map, options);
  if (options.resume) pull.resume(*options.resume);
  pull.run();
  return pull.finish();
}

}  // namespace arenite::peridynamics
