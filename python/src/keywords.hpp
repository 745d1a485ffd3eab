#pragma once
#include <pybind11/pybind11.h>

#include <string>
#include <vector>

#include "recipe/given.hpp"

/// Keywords of functions that are declared keys: types, defaults, units, ranges and sentences are those of recipes.
namespace arenite::python {

namespace py = pybind11;

/// A keyword and the key that it is, or with "key=word" the word of a choice that true stands for.
struct Keyword {
  const char *name, *key;
  const char* bare_unit = "";  ///< of a number without unit; that of SI unless given
  bool is_own = false;         ///< the function takes it itself, and only its sentence is the declaration's
};

class Keywords {
 public:
  Keywords(recipe::RecordTable keys, std::vector<Keyword> list) : keys_(std::move(keys)), list_(std::move(list)) {}
  /// What is given of them; None is nothing. Throws TypeError for a keyword of another name.
  std::vector<recipe::Given> given(const char* function, const py::kwargs& values) const;
  /// A value for one of them.
  recipe::Given given(const char* name, const py::handle& value) const;
  /// The docstring of a function whose own one begins with pybind11's signature, "f(x: int, **kwargs) -> int".
  std::string docstring(const std::string& own, const std::string& sentence) const;

 private:
  const Keyword* find(const std::string& name) const;
  recipe::RecordTable keys_;
  std::vector<Keyword> list_;
};

/// The keyword `threads`, and what is given for it; throws InputError beyond its range.
py::arg_v threads_argument();
int threads_given(int threads);

/// Says what has no effect as warnings of Python.
void warn_of_idle(const std::vector<std::string>& sentences);

/// Reads into `to`, a declared struct.
template <class T> void read_keywords(T& to, const std::vector<recipe::Given>& given) {
  warn_of_idle(recipe::read_given_into(to, given, true));
}

/// `m.def` of a function whose last argument is the dict of these keywords; `own` are the other arguments.
template <class Function, class... Own>
void def_with_keywords(py::module_& m, const char* name, Function function, const Keywords& keywords,
                       const char* sentence, const Own&... own) {
  const py::object plain = py::cpp_function(function, py::name(name), own...);
  const std::string text = keywords.docstring(py::cast<std::string>(plain.attr("__doc__")), sentence);
  py::options options;
  options.disable_function_signatures();
  m.def(name, function, own..., text.c_str());
}

}  // namespace arenite::python
