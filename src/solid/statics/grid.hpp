#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "core/pages.hpp"
#include "core/vec.hpp"

namespace arenite::statics {

/// How nodes lie in memory while they are worked on: rows padded with empty nodes on every side, so that no loop asks
/// where the sample ends, and to whole vectors of 16 nodes, so that loops run in full lanes. In the plane there is one
/// layer of rows. A level is what the clamps lie across: a row in the plane, a layer in space.
struct Grid {
  static constexpr int lanes = 8;    ///< nodes of a group
  static constexpr int vector = 16;  ///< nodes of the widest vector
  int width = 0, height = 0;         ///< nodes of the sample
  int depth = 1;                     ///< its layers
  int margin = 3;                    ///< empty rows on either side of a layer: a horizon
  bool periodic = false;             ///< the first node of every axis follows upon the last
  int groups = 0;                    ///< groups of 8 nodes a row
  std::ptrdiff_t stride = 0;         ///< nodes from one row to the next
  std::ptrdiff_t layer = 0;          ///< nodes from one layer to the next; 0 in the plane

  Grid() = default;
  Grid(int w, int h) : width(w), height(h), groups((w + lanes - 1) / lanes), stride(row_vectors() * vector + vector) {
    if (stride % 128 == 0) stride += vector;  // rows a power of two apart share cache sets
  }
  /// In space, with as many empty rows and layers on every side as nodes reach.
  Grid(int w, int h, int d, int reach = 1) : Grid(w, h) {
    depth = d;
    margin = reach;
    layer = (h + 2 * reach) * stride;
  }
  bool in_space() const { return layer > 0; }
  std::array<int, 3> size() const { return {width, height, depth}; }
  int levels() const { return in_space() ? depth : height; }
  int row_vectors() const { return (width + vector - 1) / vector; }
  std::ptrdiff_t row(int y) const { return (in_space() ? margin : 0) * layer + (y + margin) * stride + vector; }
  std::ptrdiff_t row(int y, int z) const { return z * layer + row(y); }
  std::ptrdiff_t index(int x, int y) const { return row(y) + x; }
  std::ptrdiff_t index(int x, int y, int z) const { return row(y, z) + x; }
  /// Every node of the sample in the map's order, with its level: visit(i, level).
  template <class Visit> void each(const Visit& visit) const {
    for (int z = 0; z < depth; ++z)
      for (int y = 0; y < height; ++y)
        for (std::ptrdiff_t i = row(y, z), end = i + width; i < end; ++i) visit(i, in_space() ? z : y);
  }
  /// Those of one level.
  template <class Visit> void each_at(int level, const Visit& visit) const {
    const int first = in_space() ? 0 : level, end = in_space() ? height : level + 1;
    for (int y = first; y < end; ++y)
      for (std::ptrdiff_t i = row(y, in_space() ? level : 0), last = i + width; i < last; ++i) visit(i, level);
  }
  std::size_t padded_size() const {
    return static_cast<std::size_t>((in_space() ? (depth + 2 * margin) * layer : (height + 2 * margin) * stride) +
                                    3 * vector);
  }
};

/// A vector of the plane or of space at every node of a grid.
template <int D, class T> struct FieldIn;
template <class T> struct FieldIn<2, T> {
  Buffer<T> x, y;
  FieldIn() = default;
  explicit FieldIn(std::size_t padded_size) : x(padded_size), y(padded_size) {}
  Buffer<T>& operator[](int axis) { return axis == 0 ? x : y; }
  const Buffer<T>& operator[](int axis) const { return axis == 0 ? x : y; }
  Vec2 at(std::ptrdiff_t i) const { return {static_cast<double>(x[i]), static_cast<double>(y[i])}; }
  void set(std::ptrdiff_t i, Vec2 v) { x[i] = static_cast<T>(v.x), y[i] = static_cast<T>(v.y); }
};
template <class T> struct FieldIn<3, T> {
  Buffer<T> x, y, z;
  FieldIn() = default;
  explicit FieldIn(std::size_t padded_size) : x(padded_size), y(padded_size), z(padded_size) {}
  Buffer<T>& operator[](int axis) { return axis == 0 ? x : axis == 1 ? y : z; }
  const Buffer<T>& operator[](int axis) const { return axis == 0 ? x : axis == 1 ? y : z; }
  Vec3 at(std::ptrdiff_t i) const {
    return {static_cast<double>(x[i]), static_cast<double>(y[i]), static_cast<double>(z[i])};
  }
  void set(std::ptrdiff_t i, Vec3 v) {
    x[i] = static_cast<T>(v.x), y[i] = static_cast<T>(v.y), z[i] = static_cast<T>(v.z);
  }
};
template <class T> using Field = FieldIn<2, T>;

template <int D, class T> void set_zero(FieldIn<D, T>& a) {
  for (int c = 0; c < D; ++c) std::fill_n(a[c].data(), a[c].size(), T(0));
}

/// Plain pointers to one padded field.
template <int D, class T> struct PointersIn;
template <class T> struct PointersIn<2, T> {
  T *x, *y;
  constexpr T* operator[](int axis) const { return axis == 0 ? x : y; }
  operator PointersIn<2, const T>() const requires(!std::is_const_v<T>) { return {x, y}; }
};
template <class T> struct PointersIn<3, T> {
  T *x, *y, *z;
  constexpr T* operator[](int axis) const { return axis == 0 ? x : axis == 1 ? y : z; }
  operator PointersIn<3, const T>() const requires(!std::is_const_v<T>) { return {x, y, z}; }
};
template <class T> using Plane = PointersIn<2, T>;

template <class T> PointersIn<2, T> pointers(FieldIn<2, T>& f) { return {f.x.data(), f.y.data()}; }
template <class T> PointersIn<2, const T> pointers(const FieldIn<2, T>& f) { return {f.x.data(), f.y.data()}; }
template <class T> PointersIn<3, T> pointers(FieldIn<3, T>& f) { return {f.x.data(), f.y.data(), f.z.data()}; }
template <class T> PointersIn<3, const T> pointers(const FieldIn<3, T>& f) {
  return {f.x.data(), f.y.data(), f.z.data()};
}

/// What is prescribed at a level of nodes, as bits: one for each component.
enum Prescribed : std::uint8_t {
  nothing_prescribed = 0,
  x_prescribed = 1,
  y_prescribed = 2,
  both_prescribed = 3,
  z_prescribed = 4,
  all_prescribed = 7
};
template <int D> inline constexpr std::uint8_t every_component = (1 << D) - 1;
/// Across the clamps: what stays prescribed where an edge may slide.
template <int D> inline constexpr std::uint8_t normal_component = 1 << (D - 1);

/// From where to where something lies, along each axis.
struct Extent {
  std::array<int, 3> first{}, last{};
  bool met = false;

  void meet(const std::array<int, 3>& at) {
    for (std::size_t k = 0; k < 3; ++k) {
      first[k] = met ? std::min(first[k], at[k]) : at[k];
      last[k] = met ? std::max(last[k], at[k]) : at[k];
    }
    met = true;
  }
};

}  // namespace arenite::statics
