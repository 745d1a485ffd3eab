#pragma once
#include <string>
#include <string_view>

#include "core/problems.hpp"
#include "io/raw_sample.hpp"

namespace arenite::io {

/// The last snapshot of a LAMMPS `dump custom` with columns id, type, x, y (or xu, yu; xs, ys) and radius (or diameter),
/// with its box, periodic sides and tilt.
RawGrains read_lammps_atoms(std::string_view text, const UnitFactors& units, Problems& problems);

/// The last snapshot of a LAMMPS `dump local` of `property/local patom1 patom2` and `pair/local fx fy [fz] p1 p2 [p3]`
/// of a granular pair style: (fx, fy) is the normal and (p1, p2) the tangential force, both on atom 1. Columns are known
/// by these names, or by `columns`, or where LAMMPS names them c_ID[n], by this order.
RawContacts read_lammps_pairs(std::string_view text, const std::string& columns, const UnitFactors& units, Problems& problems);

}  // namespace arenite::io
