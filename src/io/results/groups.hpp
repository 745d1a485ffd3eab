#pragma once
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <concepts>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "io/disk/store_file.hpp"
#include "io/hdf5/group.hpp"
#include "model/result.hpp"

namespace arenite::io {

using Shape = Hdf5Writer::Shape;

/// One member of a record, as an array of all records: name, place and SI unit.
template <class T, class Member> struct Named {
  const char* name;
  Member T::*member;
  const char* unit = "1";
};
template <class T, class Member> Named(const char*, Member T::*, const char* = "1") -> Named<T, Member>;

/// A part of a result as a group of a file that is written or read. It is transferred by one function, which names its members in their order: so one
/// list serves both ways. What is written is not changed.
struct ResultPart {
  std::optional<Hdf5Writer> put;   ///< a group that is written, or
  std::optional<Hdf5Reader> take;  ///< one that is read

  explicit ResultPart(Hdf5Writer to) : put(std::move(to)) {}
  explicit ResultPart(Hdf5Reader from) : take(std::move(from)) {}
  bool reads() const { return take.has_value(); }
  ResultPart group(const std::string& name) const { return reads() ? ResultPart(take->group(name)) : ResultPart(put->create_group(name)); }

  /// An attribute: real or whole number, truth or text.
  void operator()(const std::string& name, double& value) const { reads() ? void(value = take->number(name)) : put->set(name, value); }
  void operator()(const std::string& name, std::string& text) const { reads() ? void(text = take->label(name)) : put->set(name, text); }
  template <std::integral T> void operator()(const std::string& name, T& value) const {
    if (!reads()) return put->set(name, static_cast<std::int64_t>(value));
    const std::int64_t stored = take->integer(name);
    if constexpr (std::is_same_v<T, bool>) {
      value = stored != 0;
    } else {
      if (!std::in_range<T>(stored)) take->refuse(fmt::format("holds a number \"{}\" that makes no sense", name));
      value = static_cast<T>(stored);
    }
  }
  void seed(const char* name, std::uint64_t& value) const { reads() ? void(value = take->natural(name)) : put->set(name, value); }
  /// A text that tells a person what lies there.
  void note(const char* name, std::string_view text) const {
    if (put) put->set(name, text);
  }
  /// One of two words.
  template <class T> void choice(const char* name, T& value, T one, const char* word, T other, const char* other_word) const {
    if (reads()) value = take->label(name) == word ? one : other;
    else put->set(name, std::string_view(value == one ? word : other_word));
  }
  template <class T> void array(const char* name, std::vector<T>& values, const char* unit = "1") const {
    reads() ? void(values = take->array<T>(name)) : put->write(name, values, unit);
  }
  template <class T> void image(const char* name, std::vector<T>& values, Shape shape, const char* unit = "1") const {
    reads() ? void(values = take->image<T>(name, shape.rows, shape.columns)) : put->write_image(name, values, shape, unit);
  }
  /// One that need not be there.
  template <class T> void optional_image(const char* name, std::vector<T>& values, Shape shape, const char* unit = "1") const {
    if (reads() ? take->has(name) : !values.empty()) image(name, values, shape, unit);
  }
  /// A numbered group for each item.
  template <class T, class Use> void each(const char* name, std::vector<T>& items, int digits, Use use) const {
    const auto all = group(name);
    if (reads())
      for (const auto& own : all.take->names()) use(all.group(own), items.emplace_back());
    else
      for (std::size_t i = 0; i < items.size(); ++i) use(all.group(fmt::format("{:0{}}", i, digits)), items[i]);
  }
  /// Members of all records, each as an array; single precision is kept in double.
  template <class T, class... Members> void records(std::vector<T>& items, const Named<T, Members>&... members) const {
    bool first = true;
    const auto transfer = [&]<class Member>(const Named<T, Member>& of) {
      std::vector<std::conditional_t<std::is_same_v<Member, float>, double, Member>> values;
      for (const T& item : items) values.push_back(item.*of.member);
      array(of.name, values, of.unit);
      if (!reads()) return;
      if (std::exchange(first, false)) items.resize(values.size());
      same_length({items.size(), values.size()});
      for (std::size_t i = 0; i < items.size(); ++i) items[i].*of.member = static_cast<Member>(values[i]);
    };
    (transfer(members), ...);
  }
  /// Refuses arrays that were read and do not go together.
  void same_length(std::initializer_list<std::size_t> sizes) const {
    if (reads() && std::any_of(sizes.begin(), sizes.end(), [&](std::size_t size) { return size != *sizes.begin(); }))
      take->refuse("holds arrays of different lengths");
  }
};

/// The result of a whole file of that kind, by the function that transfers it.
template <class Result>
void write_result_file(const std::filesystem::path& path, std::string_view kind, void (*transfer)(const ResultPart&, Result&), const Result& result) {
  const Hdf5Writer file;
  transfer(ResultPart(file), const_cast<Result&>(result));  // which does not change what it writes
  write_checksummed(path, kind, file.bytes());
}
template <class Result> Result read_result_file(const std::filesystem::path& path, std::string_view kind, void (*transfer)(const ResultPart&, Result&)) {
  Result result;
  transfer(ResultPart(Hdf5Reader(read_checksummed(path, kind), path.string())), result);
  return result;
}

/// A column of real numbers: name, SI unit ("1" if it has none) and where it lives. Every format takes its columns here.
template <class Owner, class Value = double> struct Column {
  const char* name;
  const char* unit;
  std::vector<Value> Owner::*member;
};

/// What changes from frame to frame; radius, id, material and zone do not.
inline constexpr Column<Grains> grain_state_columns[] = {{"x", "m", &Grains::x},     {"y", "m", &Grains::y},     {"angle", "rad", &Grains::angle},
                                                         {"vx", "m/s", &Grains::vx}, {"vy", "m/s", &Grains::vy}, {"omega", "rad/s", &Grains::omega}};

inline constexpr Column<Contacts> contact_columns[] = {{"nx", "1", &Contacts::nx},           {"ny", "1", &Contacts::ny},
                                                       {"fn", "N", &Contacts::fn},           {"ft", "N", &Contacts::ft},
                                                       {"arm_i", "m", &Contacts::arm_i},     {"arm_j", "m", &Contacts::arm_j},
                                                       {"overlap", "m", &Contacts::overlap}, {"sliding_velocity", "m/s", &Contacts::sliding_velocity}};

/// Of contacts of grains that are no disks; files of disks have none.
inline constexpr std::array<Column<Contacts>, 4> lever_columns{
    {{"off_i_x", "m", &Contacts::off_i_x}, {"off_i_y", "m", &Contacts::off_i_y}, {"off_j_x", "m", &Contacts::off_j_x}, {"off_j_y", "m", &Contacts::off_j_y}}};

/// Displacements and stresses of a field's nodes.
inline constexpr Column<StressField> field_columns[] = {{"ux", "m", &StressField::ux},
                                                        {"uy", "m", &StressField::uy},
                                                        {"sigma_xx", "Pa", &StressField::xx},
                                                        {"sigma_yy", "Pa", &StressField::yy},
                                                        {"sigma_xy", "Pa", &StressField::xy}};

/// All columns of an owner, of which each has `size` values, or none where it may lack them.
template <class Owner, class Columns>
void transfer_columns(const ResultPart& at, Owner& owner, const Columns& columns, std::size_t size, bool may_lack = false) {
  for (const auto& c : columns) {
    at.array(c.name, owner.*c.member, c.unit);
    if (const std::size_t count = (owner.*c.member).size(); count > 0 || !may_lack) at.same_length({count, size});
  }
}

/// What made a result, its name and how it ended, as the groups "provenance" and "outcome"; the file itself says in its attributes what it is.
void transfer_provenance(const ResultPart& at, Provenance& provenance);
template <class Result> void transfer_origin(const ResultPart& at, Result& result) {
  at.note("source", "Arenite " + result.provenance.version);
  at.note("stage", result.name);
  at.note("layout", "docs/hdf5.md of Arenite says what lies where; `arenite export --to netcdf` writes arrays over (time, grain)");
  transfer_provenance(at.group("provenance"), result.provenance);
  const auto outcome = at.group("outcome");
  outcome("name", result.name);
  outcome("converged", result.converged);
  outcome("outcome", result.outcome);
}

void transfer_materials(const ResultPart& at, Materials& materials);
bool same(const Materials& a, const Materials& b);

void transfer_domain(const ResultPart& at, Domain& domain);

/// Grains. What does not change while they move is not written where the sample (or null) has the same, and then read from there. Grains of materials
/// that do not exist are refused.
void transfer_grains(const ResultPart& at, Packing& packing, const Grains* sample);
void transfer_names(const ResultPart& grains_at, Grains& grains, const Grains* sample);

/// Contacts; those of grains, or of elements of boundaries, that do not exist are refused.
void transfer_contacts(const ResultPart& at, Contacts& contacts, std::size_t grains, int elements);

/// Bonds, of which most packings have none: files without them have no such group. Those of grains that do not exist are refused.
void transfer_bonds(const ResultPart& at, std::vector<Bond>& bonds, std::size_t grains);

/// The same of pairs that a cohesion joins.
void transfer_cohesive(const ResultPart& at, std::vector<CohesivePair>& pairs, std::size_t grains);

/// A whole packing as the group "packing".
void transfer_packing(const ResultPart& at, Packing& packing);

void transfer_history(const ResultPart& at, const char* name, History& history);

/// A tree of numbers as a table in a group: a row a node, parents before what they hold, with `name` (path with dots), `depth`, `kind`
/// (Numbers::Kind), `value` (NaN where it is no number) and `text`. Reads also what version 0.1 wrote, which was JSON.
void write_numbers(const Hdf5Writer& at, const std::string& name, const Numbers& numbers);
Numbers read_numbers(const Hdf5Reader& at, const std::string& name);
inline void transfer_numbers(const ResultPart& at, const char* name, Numbers& numbers) {
  at.reads() ? void(numbers = read_numbers(*at.take, name)) : write_numbers(*at.put, name, numbers);
}

}  // namespace arenite::io
