#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "core/pages.hpp"
#include "core/vec.hpp"

namespace arenite::statics {

/// How nodes lie in memory while they are worked on: rows padded with empty nodes by at least a horizon on every side,
/// so that no loop asks where the sample ends, and to whole vectors of 16 nodes, so that loops run in full lanes.
struct Grid {
  static constexpr int lanes = 8;    ///< nodes of a group
  static constexpr int vector = 16;  ///< nodes of the widest vector
  int width = 0, height = 0;         ///< nodes of the sample
  int groups = 0;                    ///< groups of 8 nodes a row
  std::ptrdiff_t stride = 0;         ///< nodes from one row to the next

  Grid() = default;
  Grid(int w, int h) : width(w), height(h), groups((w + lanes - 1) / lanes), stride(row_vectors() * vector + vector) {
    if (stride % 128 == 0) stride += vector;  // rows a power of two apart share cache sets
  }
  int row_vectors() const { return (width + vector - 1) / vector; }
  std::ptrdiff_t row(int y) const { return (y + 3) * stride + vector; }
  std::ptrdiff_t index(int x, int y) const { return row(y) + x; }
  /// Every node of the sample in the map's order: visit(i, y).
  template <class Visit> void each(const Visit& visit) const {
    for (int y = 0; y < height; ++y)
      for (std::ptrdiff_t i = row(y), end = i + width; i < end; ++i) visit(i, y);
  }
  std::size_t padded_size() const { return static_cast<std::size_t>((height + 6) * stride + 3 * vector); }
};

/// A plane vector at every node of a grid.
template <class T> struct Field {
  Buffer<T> x, y;
  Field() = default;
  explicit Field(std::size_t padded_size) : x(padded_size), y(padded_size) {}
  Vec2 at(std::ptrdiff_t i) const { return {static_cast<double>(x[i]), static_cast<double>(y[i])}; }
  void set(std::ptrdiff_t i, Vec2 v) { x[i] = static_cast<T>(v.x), y[i] = static_cast<T>(v.y); }
};

template <class T> void set_zero(Field<T>& a) {
  std::fill_n(a.x.data(), a.x.size(), T(0));
  std::fill_n(a.y.data(), a.y.size(), T(0));
}

/// Plain pointers to one padded plane field.
template <class T> struct Plane {
  T *x, *y;
  operator Plane<const T>() const requires(!std::is_const_v<T>) { return {x, y}; }
};

template <class T> Plane<T> plane(Field<T>& f) { return {f.x.data(), f.y.data()}; }
template <class T> Plane<const T> plane(const Field<T>& f) { return {f.x.data(), f.y.data()}; }

/// What is prescribed in a row of nodes, as bits.
enum Prescribed : std::uint8_t { nothing_prescribed = 0, x_prescribed = 1, y_prescribed = 2, both_prescribed = 3 };

}  // namespace arenite::statics
