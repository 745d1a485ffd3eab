#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "recipe/document.hpp"
#include "recipe/record.hpp"
#include "recipe/writer.hpp"

/// Declared keys outside of recipes: options of commands and keywords of Python take names, defaults, units, ranges and
/// sentences from the declaration that recipes are read with.
namespace arenite::recipe {

/// A value for a declared key that a command line or a call gives.
struct Given {
  std::string label;  ///< the caller's name for the key, under which problems are reported: "--strain"
  std::string key;    ///< with dots within the declaration: "stiffness.matrix"
  Node value;
};

/// Every key of a declared struct.
template <class T> RecordTable every_key() {
  T with_defaults;
  return record_of([&](ParameterVisitor& visitor) { declare(visitor, with_defaults); }, true);
}

/// The declared key of that name; throws std::logic_error where there is none.
const Record& record_at(const RecordTable& keys, std::string_view key);

/// Says that a key has no effect without `condition`.
std::string left_aside(std::string_view key, std::string_view condition);

/// What help says of a key: its sentence, default and allowed values.
std::string help_of(const Record& record);
/// The same of what stands for one word of a choice, or for "false" of what is on or off.
std::string help_of(const Record& record, std::string_view word);

/// A text, as it is typed, as a value of that key: lists have commas between their items, or "+-" between a value and
/// its error, "27.35 +- 0.40 kN/mm".
Node value_of(const Record& record, const std::string& text);

/// Reads what is given over what a declared struct holds. A number without unit is in SI if `in_si`, else refused where
/// the key has a dimension. Throws InputError with every problem, each under its label. A value for a key that the
/// other values leave without effect is left aside; the sentences that say so are returned.
std::vector<std::string> read_given(const std::vector<Given>& given, const Visit& declare, bool in_si = false);
template <class T>
std::vector<std::string> read_given_into(T& to, const std::vector<Given>& given, bool in_si = false) {
  return read_given(
      given, [&](ParameterVisitor& visitor) { declare(visitor, to); }, in_si);
}

}  // namespace arenite::recipe
