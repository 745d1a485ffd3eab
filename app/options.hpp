#pragma once
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "core/error.hpp"

namespace arenite::app {

/// One argument of a command: its name ("result" takes its place in the line, "--out" is named; "--periodic{xy}" means xy where nothing
/// follows it), what it sets, and its sentence in the help. What is no `bool` takes a value.
struct Option {
  using Target = std::variant<bool*, std::string*, std::vector<std::string>*, int*, unsigned*, std::int64_t*, std::uint64_t*, double*, std::optional<int>*,
                              std::optional<std::int64_t>*, std::optional<std::uint64_t>*, std::optional<double>*>;

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
  bool repeats() const { return std::holds_alternative<std::vector<std::string>*>(to); }

  Option& required() { return is_required = true, *this; }
  Option& type(std::string text) { return value = std::move(text), *this; }
  Option& among(std::vector<std::string> words) { return choices = std::move(words), *this; }
  Option& between(double low, double high) { return range = {low, high}, *this; }
  Option& formerly(std::string former) { return former_names.push_back(std::move(former)), *this; }
  Option& formerly(std::string word, std::string now) { return former_choices.emplace(std::move(word), std::move(now)), *this; }
  Option& not_with(std::string other) { return without.push_back(std::move(other)), *this; }
  /// Of a list: each value has the name before it.
  Option& each() { return one_at_a_time = true, *this; }
};

/// The table of a command's arguments, and its work.
struct Options {
  std::deque<Option> table;
  std::string footer;
  std::function<void()> work;

  template <class T> Option& add(std::string name, T& to, std::string sentence) {
    return table.emplace_back(Option{std::move(name), &to, std::move(sentence), {}, {}, {}, {}, {}, {}});
  }
};

/// Reads the command line and does the work of the command that it names; exit status, with a sentence on stderr where it is not understood.
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
