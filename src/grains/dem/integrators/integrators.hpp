#pragma once
#include <array>
#include <string>
#include <string_view>

#include "grains/dem/integrators/gear.hpp"
#include "grains/dem/integrators/verlet.hpp"

namespace arenite::dem {

/// In the order of IntegratorKind.
#define ARENITE_ADDRESS(name) &name,
inline constexpr std::array integrators{ARENITE_INTEGRATORS(ARENITE_ADDRESS)};
#undef ARENITE_ADDRESS
inline const Integrator& integrator_of(IntegratorKind kind) { return *integrators[static_cast<std::size_t>(kind)]; }

/// Those that move bodies, for sentences: a, b or c, each in `quotes`.
std::string integrators_of_bodies(std::string_view quotes = "\"");

}  // namespace arenite::dem
