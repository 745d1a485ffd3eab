#pragma once
#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/random.hpp"
#include "core/vec.hpp"
#include "geometry/ball.hpp"
#include "geometry/cell_grid.hpp"
#include "geometry/rectangle.hpp"

namespace arenite::packing {

using geometry::Ball;

/// Disks (D = 2) or spheres (3) of about one size in square or cubic cells, to which more are added one by one. Along a
/// periodic direction every image that lies near is visited, also where the box is only a few of them wide.
template <int D> class BallCells {
 public:
  /// Cells about as wide as `size`, m.
  BallCells(const geometry::Box<D>& box, double size) : box_(box), grid_(box, size, 20000), first_(grid_.size(), -1) {}

  void add(const Ball<D>& ball) {
    std::int32_t& first = first_[grid_.cell(ball.centre)];
    member_.push_back({ball, first});
    first = static_cast<std::int32_t>(member_.size()) - 1;
    largest_ = std::max(largest_, ball.radius);
  }
  double largest() const { return largest_; }

  /// Whether `holds(image)` is true for any whose image may lie nearer to `point` than `reach`, centre to centre.
  template <class Predicate> bool any_near(Vec<D> point, double reach, const Predicate& holds) const {
    return any_in_rows<D - 1>({point, reach}, 0, {}, holds);
  }

 private:
  struct Member {
    Ball<D> ball;
    std::int32_t next;
  };
  static int floor_divide(int a, int b) { return a >= 0 ? a / b : -((b - 1 - a) / b); }

  /// Of the cells of `row` along the axes up to `axis`, which lie `way` on, m.
  template <int axis, class Predicate>
  bool any_in_rows(const Ball<D>& near, std::int32_t row, Vec<D> way, const Predicate& holds) const {
    const std::int32_t count = grid_.count[axis];
    int from = grid_.free_along(axis, near.centre[axis] - near.radius),
        to = grid_.free_along(axis, near.centre[axis] + near.radius);
    if (!box_.periodic[axis]) from = std::max(from, 0), to = std::min(to, count - 1);
    for (int c = from; c <= to; ++c) {
      const int turns = floor_divide(c, count);
      const std::int32_t cell = row * count + c - turns * count;
      way[axis] = turns * box_.size[axis];
      if constexpr (axis > 0) {
        if (any_in_rows<axis - 1>(near, cell, way, holds)) return true;
      } else {
        for (std::int32_t k = first_[cell]; k >= 0; k = member_[k].next)
          if (holds(Ball<D>{member_[k].ball.centre + way, member_[k].ball.radius})) return true;
      }
    }
    return false;
  }

  geometry::Box<D> box_;
  geometry::CellGrid<D> grid_;
  double largest_ = 0;
  std::vector<std::int32_t> first_;
  std::vector<Member> member_;
};

/// The room that is left between disks, or spheres, in a box. One fits where it lies inside the walls and keeps `gap`
/// to every other (its own periodic images too).
template <int D> class FreeSpace {
 public:
  FreeSpace(const geometry::Box<D>& box, double gap) : box_(box), gap_(gap) {}

  /// Those of different size live in cells of their own: a new store for ones about as wide as `size`, m.
  void open_store(double size) { stores_.emplace_back(box_, size); }
  /// To the newest store.
  void add(const Ball<D>& ball) {
    stores_.back().add(ball);
    balls_.push_back(ball);
  }
  const std::vector<Ball<D>>& balls() const { return balls_; }  ///< of all stores, as they were added
  void set_gap(double gap) { gap_ = gap; }
  double gap() const { return gap_; }
  const geometry::Box<D>& box() const { return box_; }

  bool fits(const Ball<D>& ball) const;
  /// Centre of one of that radius in a direction, a unit vector, from another, at the least distance allowed, inside
  /// the periodic cell.
  Vec<D> place_beside(const Ball<D>& ball, double radius, Vec<D> direction) const;
  /// A place beside `disk` where a disk of that radius fits, each equally likely; nothing if there is none. Exact but
  /// for places narrower than 1e-9 rad: all of the circle where the new centre may lie is held against all neighbours.
  /// Where it fits nowhere beside any disk, it fits nowhere at all, and neither does a larger one.
  std::optional<Vec<D>> free_place_beside(const Ball<D>& disk, double radius, RandomStream& random) const
      requires(D == 2);

 private:
  struct Arc {
    double from, to;
  };
  std::vector<Arc> covered_arcs(const Ball<D>& disk, double radius) const;  ///< in the plane

  geometry::Box<D> box_;
  double gap_;
  std::vector<BallCells<D>> stores_;
  std::vector<Ball<D>> balls_;
};

}  // namespace arenite::packing
