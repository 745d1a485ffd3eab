#pragma once
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "io/hdf5_turn.hpp"

namespace arenite::io {

/// A group of an HDF5 file that is built in memory, so that the disk sees either all of it or nothing. No times are
/// stored, and members keep the order in which they were written: the same content gives the same bytes. Arrays of 4 kB
/// and more are deflated unless `compress` is false. The file lives as long as one of its groups; so long HDF5 is its
/// thread's.
class Hdf5Writer {
 public:
  /// The root group of a new file.
  explicit Hdf5Writer(bool compress = true);

  Hdf5Writer create_group(const std::string& name) const;
  /// One-dimensional array with its SI unit as the attribute "unit". Bytes and integers without unit give "1".
  void write(const std::string& name, const std::vector<double>& values, const std::string& unit) const;
  void write(const std::string& name, const std::vector<std::int32_t>& values, const std::string& unit = "1") const;
  void write(const std::string& name, const std::vector<std::int64_t>& values, const std::string& unit = "1") const;
  void write(const std::string& name, const std::vector<std::uint8_t>& values, const std::string& unit = "1") const;
  /// Two-dimensional arrays, row after row. Numbers of a field are stored in single precision.
  struct Shape { int rows = 0, columns = 0; };
  void write_image(const std::string& name, const std::vector<double>& values, Shape shape, const std::string& unit) const;
  void write_image(const std::string& name, const std::vector<std::int32_t>& values, Shape shape) const;
  void write_image(const std::string& name, const std::vector<std::uint8_t>& values, Shape shape) const;
  void write_text(const std::string& name, std::string_view text) const;   ///< any length, UTF-8
  void write_texts(const std::string& name, const std::vector<std::string>& texts) const;  ///< one-dimensional array
  void set(const std::string& name, double value) const;                   ///< attribute
  void set(const std::string& name, std::int64_t value) const;
  void set(const std::string& name, std::uint64_t value) const;
  void set(const std::string& name, std::string_view text) const;

  /// The whole file as it stands; its first 512 bytes are free (io/sealed_file.hpp).
  std::string bytes() const;

 private:
  using Handle = std::shared_ptr<const std::int64_t>;
  using Turn = std::shared_ptr<const Hdf5Turn>;
  Hdf5Writer(Turn turn, bool compress);
  Hdf5Writer(Turn turn, Handle group, bool compress);
  Turn turn_;  // before the handles, which are closed while it lasts
  Handle id_;
  bool compress_;
};

}  // namespace arenite::io
