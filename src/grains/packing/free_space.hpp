#pragma once
#include <optional>
#include <vector>

#include "core/random.hpp"
#include "grains/packing/disk_cells.hpp"

namespace arenite::packing {

/// The room that is left between disks in a box. A disk fits where it lies inside the walls and keeps `gap` to every
/// disk (its own periodic images too).
class FreeSpace {
 public:
  FreeSpace(const geometry::Box& box, double gap) : box_(box), gap_(gap) {}

  /// Disks of different size live in cells of their own: a new store for disks about as wide as `size`, m.
  void open_store(double size) { stores_.emplace_back(box_, size); }
  void add(const Disk& disk) { stores_.back().add(disk); }  ///< to the newest store
  void set_gap(double gap) { gap_ = gap; }
  double gap() const { return gap_; }
  const geometry::Box& box() const { return box_; }

  bool fits(const Disk& disk) const;
  /// Centre of a disk of that radius at that angle round another, at the least distance allowed, inside the periodic cell.
  Vec2 place_beside(const Disk& disk, double radius, double angle) const;
  /// A place beside `disk` where a disk of that radius fits, each equally likely; nothing if there is none. Exact but
  /// for places narrower than 1e-9 rad: all of the circle where the new centre may lie is held against all neighbours.
  /// Where it fits nowhere beside any disk, it fits nowhere at all, and neither does a larger one.
  std::optional<Vec2> free_place_beside(const Disk& disk, double radius, RandomStream& random) const;

 private:
  struct Arc {
    double from, to;
  };
  std::vector<Arc> covered_arcs(const Disk& disk, double radius) const;
  void cover_walls(const Disk& disk, double radius, double distance, std::vector<Arc>& arcs) const;

  geometry::Box box_;
  double gap_;
  std::vector<DiskCells> stores_;
};

}  // namespace arenite::packing
