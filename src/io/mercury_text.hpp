#pragma once
#include <string_view>

#include "core/problems.hpp"
#include "io/raw_sample.hpp"

namespace arenite::io {

/// The last time step of a MercuryDPM .data file of a plane simulation: a line "N time xmin ymin xmax ymax", then N
/// lines "x y vx vy radius angle omega info"; info is the species. Grains are numbered from 0 in their order.
RawGrains read_mercury_data(std::string_view text, const UnitFactors& units, Problems& problems);

/// The last time step of a MercuryDPM .fstat file: lines "time i j x y z overlap tangential_overlap fn ft nx ny nz tx ty
/// tz", n pointing to grain i; j < 0 is a wall. Contacts of two grains are listed once for each of them.
RawContacts read_mercury_fstat(std::string_view text, const UnitFactors& units, Problems& problems);

}  // namespace arenite::io
