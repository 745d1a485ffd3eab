#pragma once
#include <string>
#include <vector>

#include "core/problems.hpp"
#include "io/sample/formats.hpp"
#include "io/table/table.hpp"

// Grains and contacts of tables whose columns have names, which several formats are.
namespace arenite::io {

/// The note that a unit was assumed: of "length" m, unless the option `other` or the header of a column says otherwise.
std::string assumed_unit(const SampleOptions& options, const char* what, const char* si, const char* other,
                         const char* column = "");

/// Adds it where the column is there without a unit and no option was chosen, since a factor of 1000 is easily
/// overlooked.
void note_assumed_unit(const SampleOptions& options, const Table& table, const char* column, bool chosen,
                       const char* what, const char* si, const char* other, std::vector<std::string>& notes);

/// The rows of a table with columns x, y, radius (or diameter) and perhaps z, id, material and zone; without ids grains
/// are numbered from 0. In space (`SampleOptions::dimension`) z is needed, too. `needed` goes on in the problem of a
/// column that lacks. A column's own unit wins over that of the options.
RawGrains grains_in(const Table& table, const char* needed, const SampleOptions& options, Problems& problems);

/// The rows of a table with columns i, j and fn, ft, or the components of the force on j, and perhaps those of the
/// normal, of the contact point and the overlap; likewise.
RawContacts contacts_in(const Table& table, const Reading& reading, const RawGrains& grains);

}  // namespace arenite::io
