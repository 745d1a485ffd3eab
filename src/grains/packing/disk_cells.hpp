#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "core/vec2.hpp"
#include "geometry/box.hpp"

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
  DiskCells(const geometry::Box& box, double size);

  void add(const Disk& disk);
  double largest() const { return largest_; }

  /// Whether `holds(image)` is true for any disk whose image may lie nearer to `point` than `reach`, centre to centre.
  template <class Predicate>
  bool any_near(Vec2 point, double reach, Predicate holds) const {
    int row0 = row(point.y - reach), row1 = row(point.y + reach), column0 = column(point.x - reach), column1 = column(point.x + reach);
    if (!box_.periodic_y) row0 = std::max(row0, 0), row1 = std::min(row1, rows_ - 1);
    if (!box_.periodic_x) column0 = std::max(column0, 0), column1 = std::min(column1, columns_ - 1);
    for (int r = row0; r <= row1; ++r) {
      const int turns_y = floor_divide(r, rows_), cell_row = r - turns_y * rows_;
      for (int c = column0; c <= column1; ++c) {
        const int turns_x = floor_divide(c, columns_), cell = cell_row * columns_ + c - turns_x * columns_;
        for (std::int32_t k = first_[static_cast<std::size_t>(cell)]; k >= 0; k = member_[static_cast<std::size_t>(k)].next) {
          const Disk& disk = member_[static_cast<std::size_t>(k)].disk;
          if (holds(Disk{{disk.centre.x + turns_x * box_.width, disk.centre.y + turns_y * box_.height}, disk.radius})) return true;
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
  int column(double x) const { return static_cast<int>(std::floor((x - box_.x0) * per_width_)); }
  int row(double y) const { return static_cast<int>(std::floor((y - box_.y0) * per_height_)); }

  geometry::Box box_;
  int columns_, rows_;
  double per_width_, per_height_, largest_ = 0;
  std::vector<std::int32_t> first_;
  std::vector<Member> member_;
};

}  // namespace arenite::packing
