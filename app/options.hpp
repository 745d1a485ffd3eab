#pragma once
#include <cstdint>
#include <deque>
#include <functional>
#include <initializer_list>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "core/error.hpp"

namespace arenite::app {

/// One argument of a command: its name ("result" takes its place in the line, "--out" is named; "--periodic{xy}" means
/// xy where nothing follows it), what it sets, and its sentence in the help. What is no `bool` takes a value.
struct Option {
  using Target = std::variant<bool*, std::string*, std::vector<std::string>*, int*, unsigned*, std::int64_t*,
                              std::uint64_t*, double*, std::optional<int>*, std::optional<std::int64_t>*,
                              std::optional<std::uint64_t>*, std::optional<double>*>;

  std::string name;
  Target to;
  std::string sentence, value;                        ///< `value` is what the help calls what follows, "DIR"
  std::vector<std::string> choices;                   ///< words that are allowed; all, if empty
  std::vector<std::string> without;                   ///< names of options that it cannot stand with
  std::vector<std::string> former_names;              ///< still read, in no help
  std::map<std::string, std::string> former_choices;  ///< words that are read as others
  std::optional<std::pair<double, double>> range;
  bool is_required = false, one_at_a_time = false;

  bool is_named() const { return name.starts_with('-'); }
  bool is_flag() const { return std::holds_alternative<bool*>(to) || name.ends_with('}'); }
  /// Whether its value is a real number; such a value is finite, whatever its range.
  bool is_real() const {
    return std::holds_alternative<double*>(to) || std::holds_alternative<std::optional<double>*>(to);
  }
  bool repeats() const { return std::holds_alternative<std::vector<std::string>*>(to); }

  // What a table says of an option; none is inline, for each of the many calls would compile it again.
  Option& required();
  Option& type(std::string_view text);
  Option& among(const std::vector<std::string>& words);
  Option& among(std::initializer_list<const char*> words);
  Option& between(double low, double high);
  Option& formerly(std::string_view former);
  Option& formerly(std::string_view word, std::string_view now);
  Option& not_with(std::string_view other);
  /// Of a list: each value has the name before it.
  Option& each();
};

/// The table of a command's arguments, and its work.
struct Options {
  std::deque<Option> table;
  std::string footer;
  std::function<void()> work;

  Option& add(std::string_view name, Option::Target to, std::string_view sentence);
  template <class T> Option& add(std::string_view name, T& to, std::string_view sentence) {
    return add(name, Option::Target(&to), sentence);
  }
};

/// Reads the command line and does the work of the command that it names; exit status, with a sentence on stderr where
/// it is not understood.
int read_command_line(int argc, char** argv);

/// What `read` gives; an error of a value, which has no place, as one of its option.
template <class Read> auto option_value(const char* option, Read read) {
  try {
    return read();
  } catch (const InputError& error) { throw InputError(std::string(option) + ": " + error.problems().front().message); }
}

/// Without spaces at both ends.
std::string trimmed(const std::string& text);

/// "a, b" as a and b.
std::vector<std::string> parts_of(const std::string& text);

}  // namespace arenite::app
