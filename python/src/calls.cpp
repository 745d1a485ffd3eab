#include "calls.hpp"

namespace arenite::python {

std::vector<std::string> overrides_of(const py::dict& changes) {
  std::vector<std::string> overrides;
  const auto dumps = py::module_::import("json").attr("dumps");
  for (const auto& [key, value] : changes) {
    const bool text = py::isinstance<py::str>(value);
    overrides.push_back(py::str(key).cast<std::string>() + "=" + (text ? value.cast<std::string>() : dumps(value).cast<std::string>()));
  }
  return overrides;
}

void Call::tell(const py::object& progress, double share, const std::string& text) {
  if (in_fork()) return;
  const py::gil_scoped_acquire lock;
  if (!progress.is_none() && !interrupted_) progress(share, text);
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
