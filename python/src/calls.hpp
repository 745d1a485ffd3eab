#pragma once
#include <pybind11/pybind11.h>
#include <unistd.h>

#include <functional>
#include <string>
#include <vector>

#include "arguments.hpp"
#include "model/result.hpp"
#include "statistics/numbers.hpp"

/// What calls from Python have in common.
namespace arenite::python {

/// As dicts, lists and numbers; an empty dict for what is not known.
py::dict to_python(const Numbers& numbers);

/// By what and of what a result was made.
py::dict to_python(const Provenance& provenance);

/// A tree of dicts, lists, texts and numbers. Throws InputError for anything else.
Numbers from_python(const py::handle& value);

/// The same with lists of numbers as arrays; what is not known is NaN there.
py::dict to_arrays(const Numbers& numbers);

/// {"container.width": "350 mm"} as the list of "key=value" that the library takes.
std::vector<std::string> overrides_of(const py::dict& changes);

/// Runs `work` without Python's lock. Ctrl-C in the meantime makes `asked_to_stop` true and is raised when `work` has
/// left. Processes that `work` forks have no thread of Python's, so nothing is told or asked there.
class Call {
 public:
  template <class Work> auto without_lock(Work&& work) {
    auto result = [&] {
      const py::gil_scoped_release release;
      return work();
    }();
    raise_interrupt();
    return result;
  }
  /// Calls `progress(share, text)` unless it is None, with Python's lock.
  void tell(const Progress& progress, double share, const std::string& text);
  bool asked_to_stop();
  /// A sentence that the program would print, as a warning; where warnings are errors, it is one.
  void warn(const std::string& sentence);

 private:
  void raise_interrupt() const;
  bool in_fork() const { return ::getpid() != process_; }
  bool interrupted_ = false;
  pid_t process_ = ::getpid();
};

}  // namespace arenite::python
