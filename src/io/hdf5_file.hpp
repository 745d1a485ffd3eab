#pragma once
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace arenite::io {

/// An HDF5 identifier that closes itself; hid_t is a 64-bit integer, and no other file of ours includes hdf5.h.
using Hdf5Handle = std::shared_ptr<const std::int64_t>;

/// A group of an HDF5 file: arrays, texts, numbers and groups by name. Reading what is not there, or is of another
/// shape, throws InputError naming the file and the place in it.
class Hdf5Group {
 public:
  Hdf5Group(Hdf5Handle id, std::string file, std::string place, bool compress = false);

  Hdf5Group create_group(const std::string& name) const;
  /// One-dimensional array with its SI unit as the attribute "unit". Bytes and integers without unit give "1".
  void write(const std::string& name, const std::vector<double>& values, const std::string& unit) const;
  void write(const std::string& name, const std::vector<std::int32_t>& values, const std::string& unit = "1") const;
  void write(const std::string& name, const std::vector<std::int64_t>& values, const std::string& unit = "1") const;
  void write(const std::string& name, const std::vector<std::uint8_t>& values, const std::string& unit = "1") const;
  void write_text(const std::string& name, std::string_view text) const;   ///< any length, UTF-8
  void set(const std::string& name, double value) const;                   ///< attribute
  void set(const std::string& name, std::int64_t value) const;
  void set(const std::string& name, std::uint64_t value) const;
  void set(const std::string& name, std::string_view text) const;

  bool has(const std::string& name) const;
  Hdf5Group group(const std::string& name) const;
  std::vector<std::string> names() const;            ///< of members, in the order in which they were written
  std::vector<std::string> attribute_names() const;  ///< likewise
  std::vector<double> doubles(const std::string& name) const;
  std::vector<std::int32_t> int32s(const std::string& name) const;
  std::vector<std::int64_t> int64s(const std::string& name) const;
  std::vector<std::uint8_t> bytes(const std::string& name) const;
  std::string unit(const std::string& name) const;   ///< of an array
  std::string text(const std::string& name) const;   ///< written by write_text
  double number(const std::string& name) const;      ///< attribute
  std::int64_t integer(const std::string& name) const;
  std::uint64_t natural(const std::string& name) const;
  std::string label(const std::string& name) const;  ///< attribute that is text

  [[noreturn]] void refuse(const std::string& message) const;  ///< InputError at this place of the file

 private:
  Hdf5Handle id_;
  std::string file_, place_;
  bool compress_;
};

/// A file built in memory, so that the disk sees either all of it or nothing. No times are stored: the same content
/// gives the same bytes. Arrays of 4 kB and more are deflated unless `compress` is false.
class Hdf5Builder {
 public:
  explicit Hdf5Builder(bool compress = true);
  Hdf5Group root() const;
  std::string bytes() const;   ///< the whole file; its first 512 bytes are free (io/sealed_file.hpp)

 private:
  Hdf5Handle id_;
  bool compress_;
};

/// Opens the bytes of a file; `file` is its name, for messages. Throws InputError if they are not HDF5.
Hdf5Group open_hdf5(std::string bytes, const std::string& file);

}  // namespace arenite::io
