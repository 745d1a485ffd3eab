#pragma once
#include <pybind11/numpy.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "arguments.hpp"
#include "core/vec.hpp"

/// NumPy arrays that look into vectors of the library, and vectors made of anything that NumPy reads.
namespace arenite::python {

/// An array of this shape over `values`, which `owner` holds. It cannot be written to: results are what was computed.
template <class T, std::size_t N>
py::array_t<T> shaped_view(const std::vector<T>& values, const std::array<py::ssize_t, N>& shape,
                           const py::object& owner) {
  py::array_t<T> array(std::vector<py::ssize_t>(shape.begin(), shape.end()), values.data(), owner);
  array.attr("setflags")(py::arg("write") = false);
  return array;
}

template <class T> py::array_t<T> view(const std::vector<T>& values, const py::object& owner) {
  return shaped_view<T, 1>(values, {static_cast<py::ssize_t>(values.size())}, owner);
}

/// Rows x columns; an empty vector gives an array without rows.
template <class T>
py::array_t<T> image_view(const std::vector<T>& values, int rows, int columns, const py::object& owner) {
  return shaped_view<T, 2>(values, {values.empty() ? 0 : rows, columns}, owner);
}

/// One member of every record of a vector, which `owner` holds.
template <class T, class Record>
py::array_t<T> member_view(const std::vector<Record>& records, T Record::*member, const py::object& owner) {
  const T* first = records.empty() ? nullptr : &(records.front().*member);
  py::array_t<T> array({static_cast<py::ssize_t>(records.size())}, {static_cast<py::ssize_t>(sizeof(Record))}, first,
                       owner);
  array.attr("setflags")(py::arg("write") = false);
  return array;
}

/// An array that takes the vector over, to be changed at will: nobody else has it.
template <class T> py::array_t<T> taken_over(std::vector<T> values, std::vector<py::ssize_t> shape = {}) {
  if (shape.empty()) shape.push_back(static_cast<py::ssize_t>(values.size()));
  auto held = std::make_unique<std::vector<T>>(std::move(values));
  const T* data = held->data();
  const py::capsule owner(held.release(), [](void* vector) { delete static_cast<std::vector<T>*>(vector); });
  return py::array_t<T>(std::move(shape), data, owner);
}

/// The same for bytes that are 0 or 1, as bool.
inline py::array_t<bool> taken_over_as_bool(std::vector<std::uint8_t> values, std::vector<py::ssize_t> shape = {}) {
  return taken_over(std::move(values), std::move(shape)).attr("view")("bool");
}

/// Points as rows of an array of their own.
template <int D> py::array_t<double> rows_of_points(const std::vector<Vec<D>>& points) {
  std::vector<double> places;
  for (const Vec<D>& point : points)
    for (int axis = 0; axis < D; ++axis) places.push_back(point[axis]);
  return taken_over(std::move(places), {static_cast<py::ssize_t>(points.size()), D});
}

/// Adds a read-only property `name` that looks into the vector `member` of the object that `part` finds in Owner.
template <class Class, class Part> void array_property(Class& c, const char* name, Part part, const char* doc) {
  using Owner = typename Class::type;
  c.def_property_readonly(
      name, [part](const py::object& self) { return view(part(self.cast<const Owner&>()), self); }, doc);
}

/// The same, one coordinate of vectors.
template <class Class, class Part>
void coordinate_property(Class& c, const char* name, Part part, double Vec2::*axis, const char* doc) {
  using Owner = typename Class::type;
  c.def_property_readonly(
      name, [part, axis](const py::object& self) { return member_view(part(self.cast<const Owner&>()), axis, self); },
      doc);
}

using Doubles = py::array_t<double, py::array::c_style | py::array::forcecast>;
using Floats = py::array_t<float, py::array::c_style | py::array::forcecast>;

/// What `numpy.ma` masks is no number: it becomes NaN, and whole numbers then become floating. Anything else is as it
/// was.
py::object unmasked(const py::object& values);

/// Numbers of `dimensions` dimensions, those that are masked as NaN. Throws InputError, which calls them `name`, for
/// anything else.
Doubles doubles(const ArrayLike& values, int dimensions, const std::string& name);
Floats floats(const ArrayLike& values, int dimensions, const std::string& name);

/// The numbers of any array-like thing, one dimension.
std::vector<double> to_vector(const ArrayLike& values, const std::string& name);
/// The same, every number finite.
std::vector<double> finite_numbers(const ArrayLike& values, const std::string& name);
/// The same, every number whole and from `least` to `most`; `dimensions` as they are said, values in C order.
std::vector<std::int32_t> whole_numbers(const ArrayLike& values, std::int32_t least, std::int32_t most,
                                        const std::string& name, int dimensions = 1);

}  // namespace arenite::python
