#pragma once
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "statistics/estimate.hpp"

namespace arenite {

/// A tree of numbers that lacks what was asked of it.
class NumbersError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// What a statistic says of a number where it puts it, so that nobody else need know it by its name.
enum class Trait : std::uint8_t {
  none = 0,
  by_forces = 1,  ///< not known where forces of contacts are not
  curve = 2,      ///< a curve, which few have use for
  detail = 4      ///< a row that tables for people leave out
};
constexpr Trait operator|(Trait a, Trait b) {
  return static_cast<Trait>(static_cast<std::uint8_t>(a) | static_cast<std::uint8_t>(b));
}

/// What a number is and its unit (empty: it has none), as its statistic declares them.
struct Meaning {
  std::string unit, sentence;
  double period = 0;  ///< of an angle, in its unit: after so much it is the same again; 0 of all other numbers
};

/// What is measured, as an ordered tree: a node is a value (truth, integer, real, text), a list of nodes, or nodes with
/// names. Braces make trees as they are written in JSON: {{"z", 3.9}, {"sectors", {1, 2, 3}}}. A number that is not
/// finite is not known. Files, tables, pages and Python are made of it (`json`, io/hdf5, report, python/src). A value
/// that a statistic declares, alone or as {"value", "error"}, has a meaning.
class Numbers {
 public:
  enum class Kind : std::uint8_t { unknown, truth, integer, natural, real, text, list, tree };
  using Items = std::vector<Numbers>;

  Numbers() = default;
  Numbers(std::nullptr_t) {}
  Numbers(bool value) : kind_(Kind::truth), integer_(value ? 1 : 0) {}
  template <std::signed_integral T> Numbers(T value) : kind_(Kind::integer), integer_(value) {}
  template <std::unsigned_integral T>
  requires(!std::same_as<T, bool>) Numbers(T value)
      : kind_(Kind::natural),
        integer_(static_cast<std::int64_t>(value)) {}
  template <std::floating_point T> Numbers(T value) : Numbers(real_of(static_cast<double>(value))) {}
  Numbers(std::string text) : kind_(Kind::text), text_(std::move(text)) {}
  Numbers(const char* text) : Numbers(std::string(text)) {}
  Numbers(std::string_view text) : Numbers(std::string(text)) {}
  Numbers(const Tensor2& t);                                        ///< {{xx, xy}, {yx, yy}}; not known where xx is not
  Numbers(const statistics::Estimate& e);                           ///< {"value", "error"}
  Numbers(const statistics::TensorEstimate& t);                     ///< likewise
  Numbers(const statistics::Curve& c);                              ///< {"x", "y", "error"}
  Numbers(const statistics::ByName<statistics::Estimate>& values);  ///< those that are known; not known if none is
  template <class T> Numbers(const std::vector<T>& values) : kind_(Kind::list), items_(values.begin(), values.end()) {}
  template <class T> Numbers(const std::map<std::string, T>& values) : kind_(Kind::tree) {
    for (const auto& [name, value] : values) (*this)[name] = value;
  }
  /// A tree if all are pairs of a name and a value, else a list.
  Numbers(std::initializer_list<Numbers> of);

  static Numbers tree(std::initializer_list<Numbers> pairs = {});
  static Numbers list(std::initializer_list<Numbers> of = {});

  Kind kind() const { return kind_; }
  bool is_known() const { return kind_ != Kind::unknown; }
  bool is_truth() const { return kind_ == Kind::truth; }
  bool is_integer() const { return kind_ == Kind::integer || kind_ == Kind::natural; }
  bool is_number() const { return is_integer() || kind_ == Kind::real; }
  bool is_real() const { return kind_ == Kind::real; }
  bool is_text() const { return kind_ == Kind::text; }
  bool is_list() const { return kind_ == Kind::list; }
  bool is_tree() const { return kind_ == Kind::tree; }

  /// Of a list or tree; 0 of what is not known, 1 of a value.
  std::size_t size() const;
  bool empty() const { return size() == 0; }
  Items::const_iterator begin() const { return items_.begin(); }
  Items::const_iterator end() const { return items_.end(); }
  Items::iterator begin() { return items_.begin(); }
  Items::iterator end() { return items_.end(); }
  const Numbers& front() const { return at(0); }
  const Numbers& back() const { return at(items_.size() - 1); }
  Numbers& back() { return items_.back(); }
  /// Names beside nodes.
  std::vector<std::pair<const std::string&, const Numbers&>> items() const;
  std::vector<std::pair<const std::string&, Numbers&>> items();

  bool contains(std::string_view name) const { return find(name) != end(); }
  Items::const_iterator find(std::string_view name) const;
  /// Throws NumbersError where there is none.
  const Numbers& at(std::string_view name) const;
  const Numbers& at(std::size_t i) const;
  const Numbers& operator[](std::string_view name) const { return at(name); }
  const Numbers& operator[](const char* name) const { return at(std::string_view(name)); }
  template <std::integral I> const Numbers& operator[](I i) const { return at(static_cast<std::size_t>(i)); }
  /// Adds it where there is none.
  Numbers& operator[](std::string_view name);
  Numbers& operator[](const char* name) { return (*this)[std::string_view(name)]; }
  template <std::integral I> Numbers& operator[](I i) { return const_cast<Numbers&>(at(static_cast<std::size_t>(i))); }
  /// What lies at "/fabric/a_c" or "/modes/2/phase"; nothing where there is none.
  const Numbers* at_path(std::string_view path) const;

  void push_back(Numbers value);
  void pop_back() { items_.pop_back(); }  ///< of a list
  void erase(std::string_view name);
  /// Takes over all of another tree's.
  void update(const Numbers& other);

  /// Nothing where none was declared.
  const Meaning* meaning() const { return meaning_.get(); }
  void means(Meaning meaning) { meaning_ = std::make_shared<const Meaning>(std::move(meaning)); }
  void means_as(const Numbers& other) { meaning_ = other.meaning_; }

  bool has(Trait trait) const { return (static_cast<std::uint8_t>(traits_) & static_cast<std::uint8_t>(trait)) != 0; }
  Trait traits() const { return traits_; }
  Numbers& mark(Trait traits) { return traits_ = traits_ | traits, *this; }

  /// As a number, truth, text or list of such; throws NumbersError if it is none.
  template <class T> T get() const {
    if constexpr (std::same_as<T, bool>) return expect(is_truth(), "neither true nor false").integer_ != 0;
    else if constexpr (std::is_arithmetic_v<T>) return as_number<T>();
    else if constexpr (std::same_as<T, std::string>) return expect(is_text(), "not a text").text_;
    else if constexpr (std::same_as<T, Numbers>) return *this;
    else {
      T values;
      for (const Numbers& item : expect(is_list(), "not a list").items_)
        values.push_back(item.get<typename T::value_type>());
      return values;
    }
  }
  template <class T> T value(std::string_view name, const T& otherwise) const {
    const auto found = find(name);
    return found == end() ? otherwise : found->template get<T>();
  }
  std::string value(std::string_view name, const char* otherwise) const { return value(name, std::string(otherwise)); }

  /// Numbers are equal by value, whatever their kind, meaning and traits.
  friend bool operator==(const Numbers& a, const Numbers& b);

 private:
  static Numbers real_of(double value);
  /// This; throws NumbersError where it is not what was asked for.
  const Numbers& expect(bool holds, const char* what) const;
  template <class T> T as_number() const {
    if (kind_ == Kind::natural) return static_cast<T>(static_cast<std::uint64_t>(integer_));
    return kind_ == Kind::real ? static_cast<T>(real_)
                               : static_cast<T>(expect(is_integer() || is_truth(), "not a number").integer_);
  }

  Kind kind_ = Kind::unknown;
  Trait traits_ = Trait::none;
  std::int64_t integer_ = 0;
  double real_ = 0;
  std::string text_;
  Items items_;
  std::vector<std::string> names_;
  std::shared_ptr<const Meaning> meaning_;
};

/// A number of a tree by its dotted name ("coordination.all"), alone or as {"value", "error"}. Its meaning is its own,
/// or that of the group it is in.
struct NamedNumber {
  std::string name;
  const Numbers* number = nullptr;
  const Meaning* meaning = nullptr;
};
/// All that the tree holds, in its order, without lists; it must outlive them.
std::vector<NamedNumber> named_numbers(const Numbers& tree);

/// Takes out the nodes, at any depth, for which `which` holds.
void erase_if(Numbers& tree, const std::function<bool(std::string_view name, const Numbers& node)>& which);
/// Those that have this trait.
void erase(Numbers& tree, Trait trait);

/// As JSON, in one line or with `indent` spaces a level. Text that is not UTF-8 is written with marks in its place. An
/// angle with an error says its period: {"value", "error", "period"}.
std::string to_json(const Numbers& numbers, int indent = -1);

}  // namespace arenite

/// What all statistics write their numbers with.
namespace arenite::statistics {

/// With its unit and what it is.
Numbers described(Numbers value, const char* unit, const char* sentence);

/// Adds a value, with its unit, what it is and its traits, unless it is not known.
void put(Numbers& to, const std::string& name, Numbers value, const char* unit, const char* sentence,
         Trait traits = Trait::none);
/// The same of an angle in degrees that is the same again after `period`: half a turn of a direction without a head.
void put_angle(Numbers& to, const std::string& name, Numbers value, double period, const char* sentence,
               Trait traits = Trait::none);
inline constexpr double half_turn = 180, whole_turn = 360;

}  // namespace arenite::statistics
