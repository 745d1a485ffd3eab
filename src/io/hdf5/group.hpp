#pragma once
#include <fmt/core.h>

#include <algorithm>
#include <concepts>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <memory>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/problems.hpp"
#include "io/disk/file.hpp"

namespace arenite::io {

class Hdf5Turn;

/// Of an array of two dimensions, or of three where it has layers.
struct Shape {
  int rows = 0, columns = 0, layers = 0;
};

/// One member of a record, as an array of all records: name, place (a member, or a function that gives a reference to
/// it) and SI unit.
template <class Place> struct Named {
  const char* name;
  Place place;
  const char* unit = "1";
};
template <class Place> Named(const char*, Place, const char* = "1") -> Named<Place>;

/// A group of an HDF5 file, which is either read or written: arrays, texts, numbers and groups by name. What it holds
/// is transferred by one function that names all of it in its order, so one list serves both ways; what is written is
/// not changed. What is not there when it is read, or is of another shape, throws InputError naming the file and the
/// place in it. As long as one lives, HDF5 is its thread's.
///
/// A file is built in memory, so that the disk sees either all of it or nothing. No times are stored, and members keep
/// the order in which they were written: the same content gives the same bytes. The file lives as long as one of its
/// groups.
class Hdf5Group {
 public:
  /// The root group of a new file. Arrays of 4 kB and more are deflated unless `compress` is false.
  explicit Hdf5Group(bool compress = true);
  /// The root group of a file that is read, given as its bytes; `file` is its name, for messages.
  Hdf5Group(std::string bytes, std::string file);

  bool reads() const { return reads_; }
  Hdf5Group group(const std::string& name) const;
  bool has(const std::string& name) const;  ///< a member
  bool has_group(const std::string& name) const;
  bool has_attribute(const std::string& name) const;
  /// Whether a member that need not be there is not: in the file that is read, or, where it is written, because it is
  /// empty.
  bool lacks(const std::string& name, bool is_empty) const { return reads() ? !has(name) : is_empty; }
  std::vector<std::string> names() const;            ///< of members, in the order in which they were written
  std::vector<std::string> attribute_names() const;  ///< likewise
  std::string unit(const std::string& name) const;   ///< of an array that is read

  /// An attribute: real or whole number, truth or text.
  void operator()(const std::string& name, double& value) const;
  void operator()(const std::string& name, std::string& text) const;
  template <std::integral T> void operator()(const std::string& name, T& value) const {
    auto stored = static_cast<std::int64_t>(value);
    integer(name, stored);
    if (!reads()) return;
    if constexpr (std::is_same_v<T, bool>) {
      value = stored != 0;
    } else {
      if (!std::in_range<T>(stored)) refuse(fmt::format("holds an invalid number \"{}\"", name));
      value = static_cast<T>(stored);
    }
  }
  void seed(const std::string& name, std::uint64_t& value) const;
  /// An attribute that tells a person what lies there; it is not read.
  void note(const std::string& name, std::string_view text) const;
  /// An attribute that is one of two words.
  template <class T>
  void choice(const std::string& name, T& value, T one, const char* word, T other, const char* other_word) const {
    std::string text = value == one ? word : other_word;
    (*this)(name, text);
    if (reads()) value = text == word ? one : other;
  }
  /// A group of attributes by their names.
  template <class ByName> void attributes(const std::string& name, ByName& values) const {
    const auto all = group(name);
    if (reads())
      for (const auto& own : all.attribute_names()) values.insert(values.end(), {own, {}});
    for (auto& [own, value] : values) all(own, value);
  }

  /// One-dimensional array with its SI unit as the attribute "unit".
  template <class T>  // double, std::int32_t, std::int64_t, std::uint8_t
  void array(const std::string& name, std::vector<T>& values, const std::string& unit = "1") const;
  /// Two-dimensional array, row after row. Numbers of a field are stored in single precision.
  template <class T>  // double, float, std::int32_t, std::uint8_t
  void image(const std::string& name, std::vector<T>& values, Shape shape, const std::string& unit = "1") const;
  /// One that need not be there.
  template <class T>
  void optional_image(const std::string& name, std::vector<T>& values, Shape shape,
                      const std::string& unit = "1") const {
    if (!lacks(name, values.empty())) image(name, values, shape, unit);
  }
  void text(const std::string& name, std::string& text) const;                 ///< any length, UTF-8
  void texts(const std::string& name, std::vector<std::string>& texts) const;  ///< one-dimensional array

  /// A numbered group for each item.
  template <class T, class Use> void each(const std::string& name, std::vector<T>& items, int digits, Use use) const {
    const auto all = group(name);
    if (reads())
      for (const auto& own : all.names()) use(all.group(own), items.emplace_back());
    else
      for (std::size_t i = 0; i < items.size(); ++i) use(all.group(fmt::format("{:0{}}", i, digits)), items[i]);
  }
  /// Members of all records, each as an array; single precision is kept in double, words of a list as their places.
  template <class T, class... Places> void records(std::vector<T>& items, const Named<Places>&... members) const {
    bool first = true;
    const auto transfer = [&](const auto& member) {
      using Member = std::decay_t<decltype(std::invoke(member.place, std::declval<T&>()))>;
      using Stored = std::conditional_t<std::is_same_v<Member, float>, double,
                                        std::conditional_t<std::is_enum_v<Member>, std::int32_t, Member>>;
      std::vector<Stored> values;
      for (T& item : items) values.push_back(static_cast<Stored>(std::invoke(member.place, item)));
      array(member.name, values, member.unit);
      if (!reads()) return;
      if (std::exchange(first, false)) items.resize(values.size());
      same_length({items.size(), values.size()});
      for (std::size_t i = 0; i < items.size(); ++i)
        std::invoke(member.place, items[i]) = static_cast<Member>(values[i]);
    };
    (transfer(members), ...);
  }
  /// Refuses arrays that were read and do not go together.
  void same_length(std::initializer_list<std::size_t> sizes) const {
    if (reads() && std::any_of(sizes.begin(), sizes.end(), [&](std::size_t size) { return size != *sizes.begin(); }))
      refuse("holds arrays of different lengths");
  }

  [[noreturn]] void refuse(const std::string& message) const;  ///< InputError at this place of the file

  /// The whole file as it stands; its first 512 bytes are free (io/disk/store_file.hpp).
  std::string bytes() const;

 private:
  using Handle = std::shared_ptr<const std::int64_t>;
  void integer(const std::string& name, std::int64_t& value) const;

  std::shared_ptr<const Hdf5Turn> turn_;  // before the handles, which are closed while it lasts
  Handle id_;
  bool reads_ = false, compress_ = true;
  std::string file_, place_;
};

}  // namespace arenite::io
