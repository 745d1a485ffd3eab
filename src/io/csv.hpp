#pragma once
#include <string>
#include <string_view>

#include "core/problems.hpp"
#include "io/raw_sample.hpp"

namespace arenite::io {

/// Grains from a table with columns id, x, y, radius (or diameter) and perhaps material and zone. Units in the header win over
/// `units`. `columns` stands for a missing header. What is wrong goes to `problems`.
RawGrains read_grains_csv(std::string_view text, const std::string& columns, const UnitFactors& units, Problems& problems);

/// Contacts from a table with columns i, j and fn, ft (or fx, fy: the force on j) and perhaps nx, ny. j may name a wall:
/// left, right, bottom, top.
RawContacts read_contacts_csv(std::string_view text, const std::string& columns, const UnitFactors& units, Problems& problems);

}  // namespace arenite::io
