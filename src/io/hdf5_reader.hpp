#pragma once
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "io/hdf5_turn.hpp"

namespace arenite::io {

/// A group of an HDF5 file: arrays, texts, numbers and groups by name. What is not there, or is of another shape, throws
/// InputError naming the file and the place in it. As long as one lives, HDF5 is its thread's.
class Hdf5Reader {
 public:
  /// The root group of a file, given as its bytes; `file` is its name, for messages.
  Hdf5Reader(std::string bytes, std::string file);

  bool has(const std::string& name) const;           ///< a member
  bool has_group(const std::string& name) const;
  bool has_attribute(const std::string& name) const;
  Hdf5Reader group(const std::string& name) const;
  std::vector<std::string> names() const;            ///< of members, in the order in which they were written
  std::vector<std::string> attribute_names() const;  ///< likewise
  std::vector<double> doubles(const std::string& name) const;
  std::vector<std::int32_t> int32s(const std::string& name) const;
  std::vector<std::int64_t> int64s(const std::string& name) const;
  std::vector<std::uint8_t> bytes(const std::string& name) const;
  /// Two-dimensional arrays of this shape, row after row.
  std::vector<double> image(const std::string& name, int rows, int columns) const;
  std::vector<std::int32_t> image_of_int32s(const std::string& name, int rows, int columns) const;
  std::vector<std::uint8_t> image_of_bytes(const std::string& name, int rows, int columns) const;
  std::string unit(const std::string& name) const;   ///< of an array
  std::string text(const std::string& name) const;   ///< written by write_text
  std::vector<std::string> texts(const std::string& name) const;  ///< written by write_texts
  double number(const std::string& name) const;      ///< attribute
  std::int64_t integer(const std::string& name) const;
  std::uint64_t natural(const std::string& name) const;
  std::string label(const std::string& name) const;  ///< attribute that is text

  [[noreturn]] void refuse(const std::string& message) const;  ///< InputError at this place of the file

 private:
  using Handle = std::shared_ptr<const std::int64_t>;
  using Turn = std::shared_ptr<const Hdf5Turn>;
  Hdf5Reader(Turn turn, std::string bytes, const std::string& file);
  Hdf5Reader(Turn turn, Handle group, std::string file, std::string place);
  Turn turn_;  // before the handles, which are closed while it lasts
  Handle id_;
  std::string file_, place_;
};

}  // namespace arenite::io
