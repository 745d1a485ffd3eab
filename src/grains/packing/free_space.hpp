#pragma once
#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/random.hpp"
#include "core/vec.hpp"
#include "geometry/cell_grid.hpp"
#include "geometry/rectangle.hpp"

namespace arenite::packing {

struct Disk {
  Vec2 centre;
  double radius = 0;
};

/// Disks of about one size in square cells, to which more are added one by one. Along a periodic direction every image
/// that lies near is visited, also where the box is only a few disks wide.
class DiskCells {
 public:
  /// Cells about as wide as `size`, m.
  DiskCells(const geometry::Box<2>& box, double size) : box_(box), grid_(box, size, 20000), first_(grid_.size(), -1) {}

  void add(const Disk& disk);
  double largest() const { return largest_; }

  /// Whether `holds(image)` is true for any disk whose image may lie nearer to `point` than `reach`, centre to centre.
  template <class Predicate> bool any_near(Vec2 point, double reach, Predicate holds) const {
    int row0 = grid_.free_along(1, point.y - reach), row1 = grid_.free_along(1, point.y + reach);
    int column0 = grid_.free_along(0, point.x - reach), column1 = grid_.free_along(0, point.x + reach);
    if (!box_.periodic[1]) row0 = std::max(row0, 0), row1 = std::min(row1, grid_.count[1] - 1);
    if (!box_.periodic[0]) column0 = std::max(column0, 0), column1 = std::min(column1, grid_.count[0] - 1);
    for (int r = row0; r <= row1; ++r) {
      const int turns_y = floor_divide(r, grid_.count[1]), cell_row = r - turns_y * grid_.count[1];
      for (int c = column0; c <= column1; ++c) {
        const int turns_x = floor_divide(c, grid_.count[0]),
                  cell = cell_row * grid_.count[0] + c - turns_x * grid_.count[0];
        for (std::int32_t k = first_[cell]; k >= 0; k = member_[k].next) {
          const Disk& disk = member_[k].disk;
          if (holds(Disk{disk.centre + Vec2{turns_x * box_.size.x, turns_y * box_.size.y}, disk.radius})) return true;
        }
      }
    }
    return false;
  }

 private:
  struct Member {
    Disk disk;
    std::int32_t next;
  };
  static int floor_divide(int a, int b) { return a >= 0 ? a / b : -((b - 1 - a) / b); }

  geometry::Box<2> box_;
  geometry::CellGrid<2> grid_;
  double largest_ = 0;
  std::vector<std::int32_t> first_;
  std::vector<Member> member_;
};

/// The room that is left between disks in a box. A disk fits where it lies inside the walls and keeps `gap` to every
/// disk (its own periodic images too).
class FreeSpace {
 public:
  FreeSpace(const geometry::Box<2>& box, double gap) : box_(box), gap_(gap) {}

  /// Disks of different size live in cells of their own: a new store for disks about as wide as `size`, m.
  void open_store(double size) { stores_.emplace_back(box_, size); }
  /// To the newest store.
  void add(const Disk& disk) {
    stores_.back().add(disk);
    disks_.push_back(disk);
  }
  const std::vector<Disk>& disks() const { return disks_; }  ///< of all stores, as they were added
  void set_gap(double gap) { gap_ = gap; }
  double gap() const { return gap_; }
  const geometry::Box<2>& box() const { return box_; }

  bool fits(const Disk& disk) const;
  /// Centre of a disk of that radius at that angle round another, at the least distance allowed, inside the periodic
  /// cell.
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

  geometry::Box<2> box_;
  double gap_;
  std::vector<DiskCells> stores_;
  std::vector<Disk> disks_;
};

}  // namespace arenite::packing
