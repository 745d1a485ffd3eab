#pragma once
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "io/disk/refuse.hpp"

namespace arenite::io {

class Hdf5Turn;

/// A group of an HDF5 file: arrays, texts, numbers and groups by name. What is not there, or is of another shape, throws InputError naming the file
/// and the place in it. As long as one lives, HDF5 is its thread's.
class Hdf5Reader {
 public:
  /// The root group of a file, given as its bytes; `file` is its name, for messages.
  Hdf5Reader(std::string bytes, std::string file);

  bool has(const std::string& name) const;  ///< a member
  bool has_group(const std::string& name) const;
  bool has_attribute(const std::string& name) const;
  Hdf5Reader group(const std::string& name) const;
  std::vector<std::string> names() const;            ///< of members, in the order in which they were written
  std::vector<std::string> attribute_names() const;  ///< likewise
  template <class T>                                 // double, std::int32_t, std::int64_t, std::uint8_t
  std::vector<T> array(const std::string& name) const;
  /// Two-dimensional arrays of this shape, row after row.
  template <class T>  // double, float, std::int32_t, std::uint8_t
  std::vector<T> image(const std::string& name, int rows, int columns) const;
  std::string unit(const std::string& name) const;                ///< of an array
  std::string text(const std::string& name) const;                ///< written by write_text
  std::vector<std::string> texts(const std::string& name) const;  ///< written by write_texts
  double number(const std::string& name) const;                   ///< attribute
  std::int64_t integer(const std::string& name) const;
  std::uint64_t natural(const std::string& name) const;
  std::string label(const std::string& name) const;  ///< attribute that is text

  [[noreturn]] void refuse(const std::string& message) const;  ///< InputError at this place of the file

 private:
  using Handle = std::shared_ptr<const std::int64_t>;
  using Turn = std::shared_ptr<const Hdf5Turn>;
  Hdf5Reader(Turn turn, Handle group, std::string file, std::string place);
  Turn turn_;  // before the handles, which are closed while it lasts
  Handle id_;
  std::string file_, place_;
};

/// A group of an HDF5 file that is built in memory, so that the disk sees either all of it or nothing. No times are stored, and members keep the
/// order in which they were written: the same content gives the same bytes. Arrays of 4 kB and more are deflated unless `compress` is false. The file
/// lives as long as one of its groups; so long HDF5 is its thread's.
class Hdf5Writer {
 public:
  /// The root group of a new file.
  explicit Hdf5Writer(bool compress = true);

  Hdf5Writer create_group(const std::string& name) const;
  /// One-dimensional array with its SI unit as the attribute "unit".
  template <class T>  // double, std::int32_t, std::int64_t, std::uint8_t
  void write(const std::string& name, const std::vector<T>& values, const std::string& unit = "1") const;
  /// Two-dimensional arrays, row after row. Numbers of a field are stored in single precision.
  struct Shape {
    int rows = 0, columns = 0;
  };
  template <class T>  // double, float, std::int32_t, std::uint8_t
  void write_image(const std::string& name, const std::vector<T>& values, Shape shape, const std::string& unit = "1") const;
  void write_text(const std::string& name, std::string_view text) const;                   ///< any length, UTF-8
  void write_texts(const std::string& name, const std::vector<std::string>& texts) const;  ///< one-dimensional array
  void set(const std::string& name, double value) const;                                   ///< attribute
  void set(const std::string& name, std::int64_t value) const;
  void set(const std::string& name, std::uint64_t value) const;
  void set(const std::string& name, std::string_view text) const;

  /// The whole file as it stands; its first 512 bytes are free (io/disk/store_file.hpp).
  std::string bytes() const;

 private:
  using Handle = std::shared_ptr<const std::int64_t>;
  using Turn = std::shared_ptr<const Hdf5Turn>;
  Hdf5Writer(Turn turn, Handle group, bool compress);
  Turn turn_;  // before the handles, which are closed while it lasts
  Handle id_;
  bool compress_;
};

}  // namespace arenite::io
