#pragma once
#include <pybind11/pybind11.h>
#include <pybind11/stl/filesystem.h>

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/units.hpp"

/// What functions take where a plain type would refuse too much, or say too little of itself in a docstring.
namespace arenite::python {

namespace py = pybind11;
using Path = std::filesystem::path;

inline bool is_anything(PyObject*) { return true; }
inline bool is_callable_or_none(PyObject* object) { return object == Py_None || PyCallable_Check(object) != 0; }

/// 0.3, or text with a unit: "0.3 mm".
class Quantity : public py::object {
 public:
  PYBIND11_OBJECT_DEFAULT(Quantity, py::object, is_anything)
  /// In SI. Throws InputError, which calls it `name`, for what is no finite number or has another dimension.
  double si(Dimension wanted, const std::string& name) const;
};

/// The value in SI of a quantity that need not be given.
std::optional<double> si(const std::optional<Quantity>& quantity, Dimension wanted, const std::string& name);

/// Every one of a list.
std::vector<double> si(const std::vector<Quantity>& quantities, Dimension wanted, const std::string& name);

/// Anything that NumPy makes an array of.
class ArrayLike : public py::object {
 public:
  PYBIND11_OBJECT_DEFAULT(ArrayLike, py::object, is_anything)
};

/// A film: a file, a folder or pattern of files, or its frames as an array.
class FilmLike : public py::object {
 public:
  PYBIND11_OBJECT_DEFAULT(FilmLike, py::object, is_anything)
};

/// A value, perhaps with its standard error: 5.0, "5 mm", (5.0, 0.1).
class MeasuredLike : public py::object {
 public:
  PYBIND11_OBJECT_DEFAULT(MeasuredLike, py::object, is_anything)
};

/// progress(share, name), or None.
class Progress : public py::object {
 public:
  PYBIND11_OBJECT_DEFAULT(Progress, py::object, is_callable_or_none)
};

/// on_step(stage), or None.
class OnStep : public py::object {
 public:
  PYBIND11_OBJECT_DEFAULT(OnStep, py::object, is_callable_or_none)
};

/// A Packing or a SpherePacking.
class OnePacking : public py::object {
 public:
  PYBIND11_OBJECT_DEFAULT(OnePacking, py::object, is_anything)
};

/// "", "x", "y" or "xy": which directions are periodic. Throws InputError for another word.
std::pair<bool, bool> periodic_directions(const std::string& word);

}  // namespace arenite::python

namespace pybind11::detail {
template <> struct handle_type_name<arenite::python::Quantity> {
  static constexpr auto name = const_name("Union[float, str]");
};
template <> struct handle_type_name<arenite::python::ArrayLike> {
  static constexpr auto name = const_name("ArrayLike");
};
template <> struct handle_type_name<arenite::python::FilmLike> {
  static constexpr auto name = const_name("Union[str, os.PathLike, ArrayLike]");
};
template <> struct handle_type_name<arenite::python::MeasuredLike> {
  static constexpr auto name = const_name("Union[float, str, Tuple[float, float]]");
};
template <> struct handle_type_name<arenite::python::Progress> {
  static constexpr auto name = const_name("Optional[Callable[[float, str], Any]]");
};
template <> struct handle_type_name<arenite::python::OnePacking> {
  static constexpr auto name = const_name("Union[arenite._core.Packing, arenite._core.SpherePacking]");
};
template <> struct handle_type_name<arenite::python::OnStep> {
  static constexpr auto name = const_name("Optional[Callable[[RunningStage], Any]]");
};
}  // namespace pybind11::detail
