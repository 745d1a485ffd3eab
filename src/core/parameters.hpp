#pragma once
#include <concepts>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "core/vec.hpp"

namespace arenite {

/// Name and meaning of one parameter.
struct Key {
  std::string_view name;
  std::string_view sentence;
  bool required = false;
  std::string_view former = {};  ///< name of before, which is still read
};

/// Allowed values, SI.
struct Range {
  double min = -std::numeric_limits<double>::infinity(), max = std::numeric_limits<double>::infinity();
  bool min_excluded = false;
  bool contains(double value) const { return (min_excluded ? value > min : value >= min) && value <= max; }
};
namespace range {
inline constexpr Range any{};
inline constexpr Range positive{0, std::numeric_limits<double>::infinity(), true};
inline constexpr Range not_negative{0, std::numeric_limits<double>::infinity(), false};
constexpr Range between(double min, double max) { return {min, max, false}; }
constexpr Range above(double min, double max) { return {min, max, true}; }
}  // namespace range

/// "above 0 mm", "between 0 and 1"; empty for any value.
std::string to_string(const Range& range, std::string_view unit);

struct IntegerRange {
  std::int64_t min = std::numeric_limits<std::int64_t>::min(), max = std::numeric_limits<std::int64_t>::max();
};
std::string to_string(const IntegerRange& range);

/// One word that a choice can take, with what it means.
struct Word {
  std::string_view word, sentence;
  std::string_view former = {};  ///< the same of before
};

/// One form of a tagged value: a bare word ("fixed"), or, with a unit, `{ force = "50 kN" }`.
struct Form {
  std::string_view word, unit, sentence;
  Range range;
};

/// What keys of another table must hold, each one of its values as they are written, texts without quotes.
using Wanted = std::vector<std::pair<std::string, std::vector<std::string>>>;

class ParameterVisitor;

/// What is done with a visitor, handed down for one call. Unlike std::function it refers to what it is made of and
/// copies nothing, for the hundreds of sections and conditions of a recipe would each compile a copy.
class Visit {
 public:
  template <class F>
  requires(!std::is_same_v<F, Visit>) Visit(const F& f)
      : what_(&f),
        call_([](const void* what, ParameterVisitor& v) { (*static_cast<const F*>(what))(v); }) {}
  void operator()(ParameterVisitor& visitor) const { call_(what_, visitor); }

 private:
  const void* what_;
  void (*call_)(const void*, ParameterVisitor&);
};

/// A list or a table of named sections, whatever holds it.
struct Elements {
  std::function<std::size_t()> size;
  std::function<void(std::size_t)> resize;
  std::function<void(ParameterVisitor&, std::size_t)> visit;
  std::function<std::string&(std::size_t)> name;  ///< empty for a list
};

/// Declares parameters: a struct's declaration calls one function a key, and what that does is up to the visitor: read
/// a recipe, print the resolved one, document the keys. Each key is thus declared once. Values are in SI; `unit` is how
/// the value is written and says its dimension.
class ParameterVisitor {
 public:
  virtual ~ParameterVisitor() = default;

  virtual void number(const Key& key, std::optional<double>& value, std::string_view unit, const Range& range) = 0;
  virtual void integer(const Key& key, std::optional<std::int64_t>& value, const IntegerRange& range) = 0;
  virtual void flag(const Key& key, bool& value) = 0;
  virtual void text(const Key& key, std::string& value) = 0;
  /// A text that names a file; relative to the folder of the recipe.
  virtual void file(const Key& key, std::string& value) = 0;
  virtual void numbers(const Key& key, std::vector<double>& values, std::string_view unit, const Range& range) = 0;
  virtual void texts(const Key& key, std::vector<std::string>& values) = 0;
  /// Keys of other tables, each with a value or a list of these.
  virtual void wanted(const Key& key, Wanted& values) = 0;
  virtual void pairs(const Key& key, std::vector<std::pair<std::int32_t, std::int32_t>>& values) = 0;
  /// Places, each two numbers with units, in space three.
  virtual void points(const Key& key, std::vector<Vec2>& values, std::string_view unit) = 0;
  virtual void points(const Key& key, std::vector<Vec3>& values, std::string_view unit) = 0;
  /// A quantity over time: pairs of a time (x, s) and a value (y), or the name of a CSV file of two such columns.
  virtual void series(const Key& key, std::vector<Vec2>& values, std::string_view unit) = 0;
  virtual void choice(const Key& key, int& index, const std::vector<Word>& words) = 0;
  /// One of several forms, some with a quantity: "fixed" or { force = "50 kN" }.
  virtual void tagged(const Key& key, int& form, double& value, const std::vector<Form>& forms) = 0;

  /// A sub-table. `inside` is called on it if it is there (reading), or if `present` (writing).
  virtual void section(const Key& key, bool& present, const Visit& inside) = 0;
  /// A list of sub-tables ([[key]]), or sub-tables with names ([key.NAME]).
  virtual void sections(const Key& key, const Elements& elements) = 0;

  /// Keys that exist only if `active`; documentation shows them all, and reading says why one does not belong.
  virtual void when(bool active, std::string_view condition, const Visit& inside) = 0;

  /// A check over several keys of the table at hand: false is a problem of the first of `keys`, placed at the first
  /// that is there. Keys that were wrong by themselves silence it.
  virtual void require(bool, std::initializer_list<std::string_view>, std::string_view) {}

  void number(const Key& key, double& value, std::string_view unit, const Range& range) {
    std::optional<double> holder = value;
    number(key, holder, unit, range);
    if (holder) value = *holder;
  }
  /// A number that is not given where it is not above 0.
  void number_above_0(const Key& key, double& value, std::string_view unit) {
    std::optional<double> holder = value > 0 ? std::optional(value) : std::nullopt;
    number(key, holder, unit, range::positive);
    value = holder.value_or(0);
  }
  template <std::integral T> void integer(const Key& key, T& value, const IntegerRange& range) {
    std::optional<std::int64_t> holder = static_cast<std::int64_t>(value);
    integer(key, holder, range);
    if (holder) value = static_cast<T>(*holder);
  }
  /// The words stand in the order of the enumeration.
  template <class Enum>
  requires std::is_enum_v<Enum>
  void choice(const Key& key, Enum& value, const std::vector<Word>& words) {
    int index = static_cast<int>(value);
    choice(key, index, words);
    value = static_cast<Enum>(index);
  }
  /// One member of a family of types. Each has its `word` and declares its own parameters, which exist only where it is
  /// chosen.
  template <class... Member> void member(const Key& key, std::variant<Member...>& value) {
    int index = static_cast<int>(value.index());
    choice(key, index, {Member::word...});
    std::variant<Member...> members[] = {Member{}...};
    auto& chosen = members[index];
    if (value.index() == chosen.index()) chosen = value;
    for (auto& each : members)
      std::visit(
          [&](auto& it) {
            when(&each == &chosen, std::string(key.name) + " = \"" + std::string(it.word.word) + "\"",
                 [&](ParameterVisitor& visitor) { it.declare(visitor); });
          },
          each);
    value = chosen;
  }
  void section(const Key& key, const Visit& inside) {
    bool present = true;
    section(key, present, inside);
  }
  template <class T>
  void optional_section(const Key& key, std::optional<T>& value,
                        const std::function<void(ParameterVisitor&, T&)>& inside) {
    T holder = value.value_or(T{});
    bool present = value.has_value();
    section(key, present, [&](ParameterVisitor& visitor) { inside(visitor, holder); });
    value = present ? std::optional<T>(std::move(holder)) : std::nullopt;
  }
  /// A section without which its defaults hold: one that holds just these is as none, and nothing is named by it.
  template <class T>
  void defaulted_section(const Key& key, std::optional<T>& value,
                         const std::function<void(ParameterVisitor&, T&)>& inside) {
    if (value == T{}) value.reset();
    optional_section(key, value, inside);
    if (value == T{}) value.reset();
  }
  template <class T>
  void list(const Key& key, std::vector<T>& values, const std::function<void(ParameterVisitor&, T&)>& inside) {
    sections(key, {[&] { return values.size(); },
                   [&](std::size_t n) { values.resize(n); },
                   [&](ParameterVisitor& visitor, std::size_t i) { inside(visitor, values[i]); },
                   {}});
  }
};

}  // namespace arenite
