#pragma once
#include <pybind11/numpy.h>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "core/error.hpp"

/// NumPy arrays that look into vectors of the library, which stay alive as long as the array does.
namespace arenite::python {

namespace py = pybind11;

/// An array of this shape over `values`, which `owner` holds. It cannot be written to: results are what was computed.
template <class T, std::size_t N>
py::array_t<T> shaped_view(const std::vector<T>& values, const std::array<py::ssize_t, N>& shape, const py::object& owner) {
  py::array_t<T> array(std::vector<py::ssize_t>(shape.begin(), shape.end()), values.data(), owner);
  array.attr("setflags")(py::arg("write") = false);
  return array;
}

template <class T>
py::array_t<T> view(const std::vector<T>& values, const py::object& owner) {
  return shaped_view<T, 1>(values, {static_cast<py::ssize_t>(values.size())}, owner);
}

/// Rows x columns; an empty vector gives an array without rows.
template <class T>
py::array_t<T> image_view(const std::vector<T>& values, int rows, int columns, const py::object& owner) {
  return shaped_view<T, 2>(values, {values.empty() ? 0 : rows, columns}, owner);
}

/// Adds a read-only property `name` that looks into the vector `member` of the object that `part` finds in Owner.
template <class Class, class Part>
void array_property(Class& c, const char* name, Part part, const char* doc) {
  using Owner = typename Class::type;
  c.def_property_readonly(name, [part](const py::object& self) { return view(part(self.cast<const Owner&>()), self); }, doc);
}

/// The numbers of any array-like thing, one dimension.
template <class T>
std::vector<T> to_vector(const py::object& values) {
  const auto array = py::array_t<T, py::array::c_style | py::array::forcecast>::ensure(values);
  if (!array || array.ndim() != 1) throw InputError("give a list or an array of numbers with one dimension");
  return std::vector<T>(array.data(), array.data() + array.size());
}

}  // namespace arenite::python
