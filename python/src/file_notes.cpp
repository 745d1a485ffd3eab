#include "file_notes.hpp"

#include <pybind11/stl.h>

namespace arenite::python {
namespace {

namespace py = pybind11;

/// Lives as long as the module, which Python never unloads.
PyObject* file_warning = nullptr;

}  // namespace

void bind_file_notes(py::module_& m) {
  file_warning = PyErr_NewExceptionWithDoc(
      "arenite.FileWarning",
      "What a file does not say and is taken for granted (units, say), or what of it was left aside.",
      PyExc_UserWarning, nullptr);
  if (file_warning == nullptr) throw py::error_already_set();
  m.attr("FileWarning") = py::reinterpret_borrow<py::object>(file_warning);
}

void warn_of_notes(const std::vector<std::string>& sentences) {
  for (const std::string& sentence : sentences)
    if (PyErr_WarnEx(file_warning, sentence.c_str(), 1) != 0) throw py::error_already_set();
}

void keep_notes(const py::object& packing, const std::vector<std::string>& sentences) {
  packing.attr("_notes") = sentences;
}

py::list notes_kept(const py::object& packing) {
  return packing.attr("__dict__").attr("get")("_notes", py::list()).cast<py::list>();
}

}  // namespace arenite::python
