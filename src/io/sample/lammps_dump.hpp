#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/sample/formats.hpp"

// What dumps of atoms and of pairs share: items, snapshots, box and units.
namespace arenite::io {

/// One "ITEM: name" and the lines below it.
struct DumpItem {
  std::string_view title;
  Table table;
};

/// One snapshot of a dump.
struct DumpSnapshot {
  std::vector<DumpItem> items;
  std::string_view system;           ///< of units, that the whole file names
  std::optional<StatedUnits> units;  ///< those of the system
  std::optional<RawCell> cell;       ///< in the file's unit of length

  DumpItem* find(std::string_view title);
};

/// The unit system of that name, of the command `units`; none of "lj", whose units have no size. A name that is not
/// LAMMPS's, and units given by options that are others, are problems.
std::optional<StatedUnits> unit_system(std::string_view name, const SampleOptions& options, Problems& problems);

/// What is taken where a file names no system of units, or one whose units have no size.
std::string assumed_unit_of(const SampleOptions& options, std::string_view system, const char* what, const char* si,
                            const char* other);

/// The name of the units that a dump states; empty without.
std::string_view dump_units(std::string_view text);

/// Steps and times of all snapshots. The time stands before the step, the units once at the beginning.
std::vector<Moment> dump_moments(std::string_view text, const std::string&);

/// The snapshot that is to be read; what is no dump, and units that contradict the options, are problems.
DumpSnapshot read_dump(const Reading& reading);

/// Names the columns of an item.
void name_columns(Table& table, const std::vector<std::string_view>& names);
/// Rows that have not as many cells as there are columns, and a number of rows other than was announced, are problems.
void check_rows(const Table& table, Problems& problems);
/// What a file is whose rows are not as many as it announces.
inline std::string_view is_cut_off(std::int64_t announced, std::size_t rows) {
  return static_cast<std::int64_t>(rows) < announced ? "it is cut off" : "its number is not that of its rows";
}
void check_count(DumpSnapshot& dump, const Table& table, std::string_view title, Problems& problems);

}  // namespace arenite::io
