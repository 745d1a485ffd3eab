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
#include "recipe/given.hpp"

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
  bool is_number = false;  ///< a text whose value is to be a finite number

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

/// Options that stand for declared keys: name apart, all that help says of one and all that is wrong with its value is
/// the declaration's. It must outlive the reading of the command line.
class KeyOptions {
 public:
  explicit KeyOptions(recipe::RecordTable keys) : keys_(std::move(keys)) {}
  /// An option for a key; that of a section takes its keys, "matrix=1 GPa,particle=4 GPa". A number without unit is
  /// read in `bare_unit` where that is given.
  Option& add(Options& to, std::string_view name, std::string_view key, std::string_view bare_unit = {});
  /// A flag that gives a choice one of its words.
  Option& add_word(Options& to, std::string_view name, std::string_view key, std::string_view word);
  /// What the command line gives, under the names of its options; a length without unit is in `bare_length` where that
  /// is given.
  std::vector<recipe::Given> given(std::string_view bare_length = {}) const;
  /// What is given for a key, as it was typed; empty if it was not.
  std::string text(std::string_view key) const;
  /// The same as overrides of a recipe that has these keys.
  std::vector<std::string> overrides() const;
  const recipe::Record& at(std::string_view key) const { return recipe::record_at(keys_, key); }

 private:
  struct Slot {
    std::string name, key, bare_unit;
    const recipe::Record* record;
    std::string text, word;  ///< `word`: that a flag stands for
    bool on = false;
  };
  void add_section(const Slot& slot, std::vector<recipe::Given>& given) const;
  recipe::RecordTable keys_;
  std::deque<Slot> slots_;
};

/// --threads, alike in every command that computes.
Option& add_threads(Options& to, int& threads);
/// --checkpoint-every and --jobs, likewise.
Option& add_checkpoints(Options& to, double& seconds);
Option& add_jobs(Options& to, std::uint64_t& jobs);
/// --retry and --keep of a command that does the runs of studies.
Option& add_retry(Options& to, bool& retry);
Option& add_keep(Options& to, std::string& what);
/// --quiet of a command with progress, --json of one that prints a result's numbers.
Option& add_quiet(Options& to, bool& quiet);
Option& add_json(Options& to, bool& json);

/// "--max-strain" of "max_strain".
std::string option_name(std::string_view key);

/// Reads what options give over what a declared struct holds, and prints what has no effect. Throws InputError that
/// names the options.
void read_options(const std::vector<recipe::Given>& given, const Visit& declare);
template <class T> void read_options(T& to, const std::vector<recipe::Given>& given) {
  read_options(given, [&](ParameterVisitor& visitor) { declare(visitor, to); });
}

/// Reads the command line into the tables of all commands, in their order. The table of the command that it names,
/// whose work is then to be done; null where nothing is left to do (help, version, overview), or with its status and a
/// sentence on stderr where it is not understood.
const Options* read_command_line(int argc, char** argv, const std::deque<Options>& tables, int& status);

/// What `read` gives; an error of a value, which has no place, as one of its option.
template <class Read> auto option_value(const char* option, Read read) {
  try {
    return read();
  } catch (const InputError& error) { throw InputError(std::string(option) + ": " + error.problems().front().message); }
}

}  // namespace arenite::app
