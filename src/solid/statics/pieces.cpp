#include "solid/statics/pieces.hpp"

#include <algorithm>
#include <cstddef>

#include "geometry/label_cells.hpp"
#include "solid/statics/grid.hpp"

namespace arenite::statics {
namespace {

constexpr int far = 32;  ///< voxels

/// Berea sandstone, 128 voxels a side: 27 iterations; 37 with 1, 28 with 0.3 (twice the pieces), 65 uncut.
constexpr geometry::LabelOptions at_necks{geometry::Labelling::watershed, 0.4};

/// The box that a label lies in.
struct Room : Extent {
  int extent(std::size_t k) const { return last[k] - first[k] + 1; }
  bool reaches_far() const { return met && std::max({extent(0), extent(1), extent(2)}) > far; }
  /// Calls see(voxel of the sample, cell of the room).
  template <class See> void each(const std::array<int, 3>& count, const See& see) const {
    std::size_t cell = 0;
    for (int z = first[2]; z <= last[2]; ++z)
      for (int y = first[1]; y <= last[1]; ++y) {
        const std::size_t row =
            (static_cast<std::size_t>(z) * static_cast<std::size_t>(count[1]) + static_cast<std::size_t>(y)) *
            static_cast<std::size_t>(count[0]);
        for (int x = first[0]; x <= last[0]; ++x) see(row + static_cast<std::size_t>(x), cell++);
      }
  }
};

std::vector<Room> rooms_of(const std::vector<std::int32_t>& label, const std::array<int, 3>& count, std::int32_t first,
                           std::int32_t end) {
  std::vector<Room> rooms(static_cast<std::size_t>(end - first));
  std::size_t k = 0;
  for (int z = 0; z < count[2]; ++z)
    for (int y = 0; y < count[1]; ++y)
      for (int x = 0; x < count[0]; ++x, ++k)
        if (label[k] >= first && label[k] < end) rooms[static_cast<std::size_t>(label[k] - first)].meet({x, y, z});
  return rooms;
}

}  // namespace

std::int32_t cut_at_necks(std::vector<std::int32_t>& label, const std::array<int, 3>& count, std::int32_t first,
                          std::int32_t end) {
  std::int32_t next = end;
  const std::vector<Room> rooms = rooms_of(label, count, first, end);
  for (std::size_t n = 0; n < rooms.size(); ++n) {
    const Room& room = rooms[n];
    if (!room.reaches_far()) continue;
    const geometry::Cells cells{room.extent(0), room.extent(1), room.extent(2)};
    std::vector<std::uint8_t> inside(cells.size());
    const std::int32_t whole = first + static_cast<std::int32_t>(n);
    room.each(count, [&](std::size_t k, std::size_t cell) { inside[cell] = label[k] == whole; });
    const geometry::CellLabels part = geometry::label_cells(cells, inside, at_necks);
    room.each(count, [&](std::size_t k, std::size_t cell) {
      if (part.label[cell] > 0) label[k] = next + part.label[cell] - 1;
    });
    next += std::max(0, part.count - 1);
  }
  return next;
}

}  // namespace arenite::statics
