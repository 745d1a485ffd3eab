#pragma once
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <concepts>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "io/hdf5/group.hpp"
#include "model/packing.hpp"
#include "model/result.hpp"

// A result's parts as groups of a file. A part is transferred by one function, called with a group that is written (PutGroup) or one that is read
// (TakeGroup), which names its members in their order: so one list serves both ways.
namespace arenite::io {

using Shape = Hdf5Writer::Shape;

struct PutGroup {
  static constexpr bool reads = false;
  Hdf5Writer at;

  PutGroup group(const char* name) const { return {at.create_group(name)}; }
  /// An attribute: real or whole number, truth or text.
  void operator()(const char* name, double value) const { at.set(name, value); }
  void operator()(const char* name, const std::string& text) const { at.set(name, text); }
  template <std::integral T>
  void operator()(const char* name, T value) const { at.set(name, static_cast<std::int64_t>(value)); }
  void seed(const char* name, std::uint64_t value) const { at.set(name, value); }
  /// A text that tells a person what lies there.
  void note(const char* name, std::string_view text) const { at.set(name, text); }
  /// One of two words.
  template <class T>
  void choice(const char* name, T value, T one, const char* word, T, const char* other) const { at.set(name, std::string_view(value == one ? word : other)); }
  template <class T>
  void array(const char* name, const std::vector<T>& values, const char* unit = "1") const { at.write(name, values, unit); }
  template <class T>
  void image(const char* name, const std::vector<T>& values, Shape shape, const char* unit = "1") const { at.write_image(name, values, shape, unit); }
  /// One that need not be there.
  template <class T>
  void optional_image(const char* name, const std::vector<T>& values, Shape shape, const char* unit = "1") const {
    if (!values.empty()) image(name, values, shape, unit);
  }
  /// A numbered group for each item.
  template <class T, class Use>
  void each(const char* name, const std::vector<T>& items, int digits, Use use) const {
    const auto all = group(name);
    for (std::size_t i = 0; i < items.size(); ++i) use(all.group(fmt::format("{:0{}}", i, digits).c_str()), items[i]);
  }
  /// One member of all items as an array.
  template <class T, class Value, class Member>
  void member(const char* name, const std::vector<T>& items, Member Value::*of, const char* unit = "1") const {
    std::vector<std::conditional_t<std::is_same_v<Member, float>, double, Member>> values;
    for (const T& item : items) values.push_back(item.*of);
    array(name, values, unit);
  }
  template <class First, class T>
  void size(const char*, const std::vector<T>&) const {}
  void same_length(std::initializer_list<std::size_t>) const {}
};

struct TakeGroup {
  static constexpr bool reads = true;
  Hdf5Reader at;

  TakeGroup group(const char* name) const { return {at.group(name)}; }
  void operator()(const char* name, double& value) const { value = at.number(name); }
  void operator()(const char* name, std::string& text) const { text = at.label(name); }
  template <std::integral T>
  void operator()(const char* name, T& value) const {
    const std::int64_t stored = at.integer(name);
    if constexpr (std::is_same_v<T, bool>) {
      value = stored != 0;
    } else {
      if (!std::in_range<T>(stored)) at.refuse(fmt::format("holds a number \"{}\" that makes no sense", name));
      value = static_cast<T>(stored);
    }
  }
  void seed(const char* name, std::uint64_t& value) const { value = at.natural(name); }
  void note(const char*, std::string_view) const {}
  template <class T>
  void choice(const char* name, T& value, T one, const char* word, T other, const char*) const { value = at.label(name) == word ? one : other; }
  template <class T>
  void array(const char* name, std::vector<T>& values, const char* = "1") const { values = at.array<T>(name); }
  template <class T>
  void image(const char* name, std::vector<T>& values, Shape shape, const char* = "1") const { values = at.image<T>(name, shape.rows, shape.columns); }
  template <class T>
  void optional_image(const char* name, std::vector<T>& values, Shape shape, const char* = "1") const {
    if (at.has(name)) image(name, values, shape);
  }
  template <class T, class Use>
  void each(const char* name, std::vector<T>& items, int, Use use) const {
    const auto all = group(name);
    for (const auto& own : all.at.names()) use(all.group(own.c_str()), items.emplace_back());
  }
  template <class T, class Value, class Member>
  void member(const char* name, std::vector<T>& items, Member Value::*of, const char* = "1") const {
    const auto values = at.array<std::conditional_t<std::is_same_v<Member, float>, double, Member>>(name);
    same_length({items.size(), values.size()});
    for (std::size_t i = 0; i < items.size(); ++i) items[i].*of = static_cast<Member>(values[i]);
  }
  /// Makes as many items as this array has numbers, before their members are taken.
  template <class First, class T>
  void size(const char* name, std::vector<T>& items) const { items.resize(at.array<First>(name).size()); }
  void same_length(std::initializer_list<std::size_t> sizes) const {
    if (std::any_of(sizes.begin(), sizes.end(), [&](std::size_t size) { return size != *sizes.begin(); })) at.refuse("holds arrays of different lengths");
  }
};

/// A column of real numbers: name, SI unit ("1" if it has none) and where it lives. Every format takes its columns here.
template <class Owner, class Value = double>
struct Column {
  const char* name;
  const char* unit;
  std::vector<Value> Owner::*member;
};

/// What changes from frame to frame; radius, id, material and zone do not.
inline constexpr std::array<Column<Grains>, 6> grain_state_columns{{{"x", "m", &Grains::x},
                                                                    {"y", "m", &Grains::y},
                                                                    {"angle", "rad", &Grains::angle},
                                                                    {"vx", "m/s", &Grains::vx},
                                                                    {"vy", "m/s", &Grains::vy},
                                                                    {"omega", "rad/s", &Grains::omega}}};

inline constexpr std::array<Column<Contacts>, 8> contact_columns{{{"nx", "1", &Contacts::nx},
                                                                  {"ny", "1", &Contacts::ny},
                                                                  {"fn", "N", &Contacts::fn},
                                                                  {"ft", "N", &Contacts::ft},
                                                                  {"arm_i", "m", &Contacts::arm_i},
                                                                  {"arm_j", "m", &Contacts::arm_j},
                                                                  {"overlap", "m", &Contacts::overlap},
                                                                  {"sliding_velocity", "m/s", &Contacts::sliding_velocity}}};

/// All columns of an owner, of which each has `size` values.
template <class At, class Owner, class Columns>
void transfer_columns(const At& at, Owner& owner, const Columns& columns, std::size_t size) {
  for (const auto& c : columns) {
    at.array(c.name, owner.*c.member, c.unit);
    at.same_length({(owner.*c.member).size(), size});
  }
}

/// What made a result, its name and how it ended, as the groups "provenance" and "outcome"; the file itself says in its attributes what it is.
template <class At, class P>
void transfer_provenance(const At& at, P& provenance);
template <class At, class Result>
void transfer_origin(const At& at, Result& result) {
  at.note("source", "Arenite " + result.provenance.version);
  at.note("stage", result.name);
  at.note("layout", "docs/hdf5.md of Arenite says what lies where; `arenite export --to netcdf` writes arrays over (time, grain)");
  transfer_provenance(at.group("provenance"), result.provenance);
  const auto outcome = at.group("outcome");
  outcome("name", result.name);
  outcome("converged", result.converged);
  outcome("outcome", result.outcome);
}

template <class At, class M>
void transfer_materials(const At& at, M& materials);
bool same(const Materials& a, const Materials& b);

template <class At, class D>
void transfer_domain(const At& at, D& domain);

/// What does not change while grains move, unless the sample says the same (or null); and back, where a group lacks it from the sample.
void put_names(const Hdf5Writer& group, const Grains& grains, const Grains* sample);
void take_names(const Hdf5Reader& group, const Hdf5Reader& sample, Grains& grains);

/// Contacts; those of grains that do not exist are refused.
template <class At, class C>
void transfer_contacts(const At& at, C& contacts, std::size_t grains);

/// Refuses grains of materials that do not exist.
void check_materials(const Hdf5Reader& at, const Packing& packing);

/// A whole packing as the group "packing".
template <class At, class P>
void transfer_packing(const At& at, P& packing);

void transfer_history(const PutGroup& at, const char* name, const History& history);
void transfer_history(const TakeGroup& at, const char* name, History& history);

/// A tree of numbers as a table in a group: a row a node, parents before what they hold, with `name` (path with dots), `depth`, `kind`
/// (Numbers::Kind), `value` (NaN where it is no number) and `text`. Reads also what version 0.1 wrote, which was JSON.
void write_numbers(const Hdf5Writer& at, const std::string& name, const Numbers& numbers);
Numbers read_numbers(const Hdf5Reader& at, const std::string& name);
inline void transfer_numbers(const PutGroup& at, const char* name, const Numbers& numbers) { write_numbers(at.at, name, numbers); }
inline void transfer_numbers(const TakeGroup& at, const char* name, Numbers& numbers) { numbers = read_numbers(at.at, name); }

}  // namespace arenite::io
