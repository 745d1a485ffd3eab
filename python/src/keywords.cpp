#include "keywords.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "core/error.hpp"
#include "core/text.hpp"
#include "core/thread_count.hpp"

namespace arenite::python {
namespace {

using recipe::Node;
using recipe::Record;

Node text_node(const py::handle& value) {
  return {.kind = Node::Kind::text, .text = py::cast<std::string>(value), .entries = {}};
}

Node node_of(const char* name, const py::handle& value);

Node list_node(const char* name, const py::handle& values) {
  Node list{.kind = Node::Kind::array, .entries = {}};
  for (const py::handle item : values) list.items.push_back(node_of(name, item));
  return list;
}

bool is_truth(const py::handle& value) {
  return PyBool_Check(value.ptr()) != 0 || std::string(Py_TYPE(value.ptr())->tp_name) == "numpy.bool_";
}

/// As a recipe would have it: a text, a number, true or false, a list of these.
Node node_of(const char* name, const py::handle& value) {
  if (py::isinstance<py::str>(value)) return text_node(value);
  if (is_truth(value)) return {.kind = Node::Kind::flag, .flag = PyObject_IsTrue(value.ptr()) == 1, .entries = {}};
  if (PyIndex_Check(value.ptr()) != 0) {
    const auto whole = py::reinterpret_steal<py::object>(PyNumber_Index(value.ptr()));
    int overflow = 0;
    const long long integer = whole ? PyLong_AsLongLongAndOverflow(whole.ptr(), &overflow) : 0;
    if (whole && overflow == 0) return {.kind = Node::Kind::integer, .integer = integer, .entries = {}};
    PyErr_Clear();
  }
  if (py::isinstance<py::list>(value) || py::isinstance<py::tuple>(value)) return list_node(name, value);
  if (py::hasattr(value, "__fspath__")) return text_node(value.attr("__fspath__")());
  const double real = PyFloat_AsDouble(value.ptr());
  if (PyErr_Occurred() == nullptr) return {.kind = Node::Kind::real, .real = real, .entries = {}};
  PyErr_Clear();
  throw InputError(
      fmt::format("{}: is of type {}; give a number, or text with a unit", name, Py_TYPE(value.ptr())->tp_name));
}

/// `text` with the quotes of Python.
std::string as_python(std::string text) {
  if (text == "true" || text == "false") text.front() = static_cast<char>(text.front() - 'a' + 'A');
  std::ranges::replace(text, '"', '\'');
  return text;
}

std::string type_of(const Record& record) {
  switch (record.type) {
    case Record::Type::integer: return "int";
    case Record::Type::flag: return "bool";
    case Record::Type::numbers: return "Union[float, str, Sequence[Union[float, str]]]";
    case Record::Type::number: return "Union[float, str]";
    default: return "str";
  }
}

std::string with_default(const char* name, const Record& record) {
  const std::string type = type_of(record);
  if (record.literal && !record.key.required) return fmt::format("{}: {} = {}", name, type, as_python(*record.literal));
  if (record.type == Record::Type::text) return fmt::format("{}: {} = ''", name, type);
  return fmt::format("{}: Optional[{}] = None", name, type);
}

/// The two sides of "key=word".
struct KeyAndWord {
  std::string key, word;
  explicit KeyAndWord(std::string_view of)
      : key(of.substr(0, of.find('='))),
        word(of.substr(std::min(key.size() + 1, of.size()))) {}
};

}  // namespace

const Keyword* Keywords::find(const std::string& name) const {
  const auto at = std::ranges::find_if(list_, [&](const Keyword& each) { return name == each.name; });
  return at == list_.end() ? nullptr : &*at;
}

recipe::Given Keywords::given(const char* name, const py::handle& value) const {
  const Keyword& keyword = *find(name);
  Node node = node_of(name, value);
  const auto [key, word] = KeyAndWord(keyword.key);
  const Record& record = recipe::record_at(keys_, key);
  if (!word.empty()) {
    if (node.kind != Node::Kind::flag) throw InputError(fmt::format("{}: must be True or False", name));
    return {name, key, recipe::value_of(record, word)};
  }
  if (record.type == Record::Type::numbers && node.kind == Node::Kind::text) node = recipe::value_of(record, node.text);
  else if (record.type == Record::Type::numbers && node.kind != Node::Kind::array)
    node = {.kind = Node::Kind::array, .items = {std::move(node)}, .entries = {}};
  const bool is_bare = node.kind == Node::Kind::integer || node.kind == Node::Kind::real;
  if (is_bare && *keyword.bare_unit != '\0')
    node = recipe::parse_value(fmt::format(
        "\"{} {}\"", node.kind == Node::Kind::real ? node.real : static_cast<double>(node.integer), keyword.bare_unit));
  return {name, key, std::move(node)};
}

std::vector<recipe::Given> Keywords::given(const char* function, const py::kwargs& values) const {
  std::vector<recipe::Given> given;
  for (const auto& [key, value] : values) {
    const auto name = py::cast<std::string>(key);
    const Keyword* const keyword = find(name);
    if (!keyword || keyword->is_own)
      throw py::type_error(fmt::format("{}() got an unexpected keyword argument '{}'", function, name));
    const bool is_off = value.ptr() == Py_False && !KeyAndWord(keyword->key).word.empty();
    if (!value.is_none() && !is_off) given.push_back(this->given(keyword->name, value));
  }
  return given;
}

std::string Keywords::docstring(const std::string& own, const std::string& sentence) const {
  std::vector<std::string> in_signature, meanings;
  for (const auto& [name, of, bare_unit, is_own] : list_) {
    const auto [key, word] = KeyAndWord(of);
    const Record& record = recipe::record_at(keys_, key);
    if (!word.empty()) {
      in_signature.push_back(fmt::format("{}: bool = False", name));
      meanings.push_back(fmt::format("`{}`: {}.", name, recipe::help_of(record, word)));
      continue;
    }
    if (!is_own) in_signature.push_back(with_default(name, record));
    meanings.push_back(fmt::format("`{}`: {}.", name, recipe::help_of(record)));
    if (*bare_unit != '\0') meanings.back() += fmt::format(" A number is in {}.", bare_unit);
  }
  std::string signature = own.substr(0, own.find('\n'));
  const std::string_view rest = in_signature.empty() ? ", **kwargs" : "**kwargs";
  const bool is_first = !in_signature.empty() && signature.find("*, ") == std::string::npos;
  signature.replace(signature.find(rest), rest.size(), (is_first ? "*, " : "") + list_of(in_signature));
  return fmt::format("{}\n\n{}\n\n{}", signature, sentence, list_of(meanings, "\n"));
}

py::arg_v threads_argument() { return py::arg("threads") = Threads{}.threads; }

int threads_given(int threads) {
  Threads read;
  recipe::read_given_into(read,
                          {{"threads", "threads", {.kind = Node::Kind::integer, .integer = threads, .entries = {}}}});
  return read.threads;
}

void warn_of_idle(const std::vector<std::string>& sentences) {
  for (const std::string& sentence : sentences)
    if (PyErr_WarnEx(PyExc_UserWarning, sentence.c_str(), 1) != 0) throw py::error_already_set();
}

}  // namespace arenite::python
