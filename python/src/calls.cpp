#include "calls.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "core/error.hpp"

namespace arenite::python {
namespace {

/// What json does not know by itself: scalars and arrays of NumPy, paths.
py::object as_plain(const py::object& value) {
  if (py::hasattr(value, "tolist")) return value.attr("tolist")();
  return py::module_::import("os").attr("fspath")(value);
}

std::string literal_of(const std::string& key, const py::handle& value) {
  if (py::isinstance<py::str>(value)) return value.cast<std::string>();
  try {
    const auto json = py::module_::import("json");
    return json.attr("dumps")(value, py::arg("default") = py::cpp_function(&as_plain)).cast<std::string>();
  } catch (const py::error_already_set&) {
    throw InputError(
        fmt::format("changes: {} is of type {}; give a number, text with a unit, True or False, or a list of these",
                    key, Py_TYPE(value.ptr())->tp_name));
  }
}

py::object value_of(const Numbers& n) {
  switch (n.kind()) {
    case Numbers::Kind::unknown: return py::none();
    case Numbers::Kind::truth: return py::bool_(n.get<bool>());
    case Numbers::Kind::integer: return py::int_(n.get<std::int64_t>());
    case Numbers::Kind::natural: return py::int_(n.get<std::uint64_t>());
    case Numbers::Kind::real: return py::float_(n.get<double>());
    case Numbers::Kind::text: return py::str(n.get<std::string>());
    case Numbers::Kind::list: break;
    case Numbers::Kind::tree: {
      py::dict d;
      for (const auto& [name, value] : n.items()) d[py::str(name)] = value_of(value);
      return d;
    }
  }
  py::list list;
  for (const Numbers& item : n) list.append(value_of(item));
  return list;
}

bool holds_numbers(const py::handle& value) {
  if (py::isinstance<py::list>(value))
    return py::len(value) > 0 && std::all_of(value.begin(), value.end(), holds_numbers);
  return value.is_none() || PyFloat_Check(value.ptr()) != 0 || PyLong_Check(value.ptr()) != 0;
}

py::object with_arrays(const py::object& value) {
  if (py::isinstance<py::list>(value))
    return holds_numbers(value) ? py::module_::import("numpy").attr("array")(value, py::arg("dtype") = "float64")
                                : value;
  if (!py::isinstance<py::dict>(value)) return value;
  const py::dict d(value);
  for (const auto& item : d) d[item.first] = with_arrays(py::reinterpret_borrow<py::object>(item.second));
  return d;
}

}  // namespace

py::dict to_python(const Numbers& numbers) { return numbers.is_known() ? py::dict(value_of(numbers)) : py::dict(); }

py::dict to_python(const Provenance& p) {
  py::dict d;
  d["title"] = p.title;
  d["version"] = p.version;
  d["stage"] = p.stage;
  d["input_hash"] = p.input_hash;
  d["recipe"] = p.recipe;
  d["seed"] = p.seed;
  d["kernel"] = p.kernel;
  d["options"] = p.options;
  return d;
}

Numbers from_python(const py::handle& value) {
  if (value.is_none()) return {};
  if (py::isinstance<py::bool_>(value)) return value.cast<bool>();
  if (py::isinstance<py::str>(value)) return value.cast<std::string>();
  if (py::isinstance<py::dict>(value)) {
    Numbers tree = Numbers::tree();
    for (const auto& [key, item] : value.cast<py::dict>()) tree[py::str(key).cast<std::string>()] = from_python(item);
    return tree;
  }
  if (py::isinstance<py::list>(value) || py::isinstance<py::tuple>(value)) {
    Numbers list = Numbers::list();
    for (const auto& item : value) list.push_back(from_python(item));
    return list;
  }
  if (PyLong_Check(value.ptr()) != 0) return value.cast<std::int64_t>();
  try {
    return value.cast<double>();
  } catch (const py::cast_error&) {
    throw InputError(
        fmt::format("numbers hold a {}; give dicts, lists, texts and numbers", Py_TYPE(value.ptr())->tp_name));
  }
}

py::dict to_arrays(const Numbers& numbers) { return with_arrays(to_python(numbers)); }

std::vector<std::string> overrides_of(const py::dict& changes) {
  std::vector<std::string> overrides;
  for (const auto& [key, value] : changes) {
    const auto name = py::str(key).cast<std::string>();
    overrides.push_back(name + "=" + literal_of(name, value));
  }
  return overrides;
}

void Call::tell(const Progress& progress, double share, const std::string& text) {
  if (in_fork()) return;
  const py::gil_scoped_acquire lock;
  if (!progress.is_none() && !interrupted_) progress(share, text);
}

void Call::warn(const std::string& sentence) {
  if (in_fork()) return;
  const py::gil_scoped_acquire lock;
  if (PyErr_WarnEx(PyExc_UserWarning, sentence.c_str(), 1) != 0) throw py::error_already_set();
}

bool Call::asked_to_stop() {
  if (in_fork()) return false;
  const py::gil_scoped_acquire lock;
  if (!interrupted_ && PyErr_CheckSignals() != 0) {
    PyErr_Clear();
    interrupted_ = true;
  }
  return interrupted_;
}

void Call::raise_interrupt() const {
  if (!interrupted_) return;
  PyErr_SetNone(PyExc_KeyboardInterrupt);
  throw py::error_already_set();
}

}  // namespace arenite::python
