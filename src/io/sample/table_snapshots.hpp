#pragma once
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "io/sample/formats.hpp"

namespace arenite::io {

/// Names of columns of which two rows have all in common only where they are of two snapshots.
using OwnColumns = std::span<const std::string_view>;

/// Which snapshot each row of a table belongs to, where a column says it: step, timestep or frame, or time.
struct SnapshotsOfRows {
  std::vector<Moment> moments;      ///< in the order in which the rows name them
  std::vector<std::size_t> of_row;  ///< empty where the table has no such column

  SnapshotsOfRows() = default;
  SnapshotsOfRows(const Table& table, OwnColumns own);
  /// How many rows those of the snapshots are.
  std::vector<std::size_t> sizes() const;
  /// Leaves the rows of one snapshot.
  void keep(std::size_t snapshot, Table& table) const;
};

/// Those moments of a text; `columns` are the names of one without header.
std::vector<Moment> moments_of_rows(std::string_view text, const std::string& columns, OwnColumns own);

}  // namespace arenite::io
