#pragma once
#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/problems.hpp"
#include "io/hdf5/handle.hpp"

// HDF5 trusts what it reads. Of files of other programs it is asked little, in a process of its own.
namespace arenite::io {

/// A file of anybody's, which is not locked: it may lie on a disk that only lets itself be read, and the one that is
/// written is locked already. InputError for a damaged one.
Hdf5Handle open_foreign(const Bytes& bytes);

/// Whether a dataset is of whole or floating numbers.
bool holds_numbers(hid_t set);

/// The dataset of the name that is wanted, or without one the only dataset of the file that `fits` takes. InputError
/// with those that can be meant where there is none or are several; `kind` is what it must be.
struct FoundDataset {
  std::string name;
  Hdf5Handle set;
};
FoundDataset find_dataset(hid_t file, const std::string& file_name, const std::string& wanted, bool (*fits)(hid_t set),
                          const char* kind);

/// What a chunk of an HDF5 table was passed through before it was stored, in this order.
struct Hdf5Filter {
  enum class Kind { deflate, shuffle, checksum } kind = Kind::deflate;
  std::size_t element = 1;  ///< bytes of a number that is shuffled
};

/// The bytes of a chunk as they were before these filters, without those whose bit is set in `skipped`. Nothing unless
/// this is exactly `size` bytes and a checksum is right.
std::optional<std::string> unpack_chunk(std::string stored, const std::vector<Hdf5Filter>& filters, unsigned skipped,
                                        std::size_t size);

/// A table of numbers in an HDF5 file of anybody's. HDF5's own copying of numbers trusts sizes that a damaged file may
/// have wrong, so HDF5 is asked only what the table is and where its chunks are; their bytes are checked, unpacked and
/// put in place here.
class Hdf5Numbers {
 public:
  /// Rank 1 to 3. InputError for a table that is damaged or stored in a way that is not read; `most` numbers a chunk.
  Hdf5Numbers(Hdf5Handle set, const std::string& name, Bytes file, double most);

  const std::vector<hsize_t>& shape() const { return shape_; }
  const Hdf5Number& number() const { return number_; }
  /// Bytes of slabs first .. first + count - 1 along the first axis, as they are stored. InputError for damage.
  void read(hsize_t first, hsize_t count, std::string& to);

 private:
  using Place = std::array<hsize_t, 3>;
  [[noreturn]] void refuse(const std::string& what) const;
  void look_at_piece(double bytes);
  void look_at_chunks(hid_t creation, double most);
  void look_at_filters(hid_t creation);
  void take_no_number();  ///< for what was never written
  void read_compact();
  void read_chunks(hsize_t first, hsize_t count, std::string& to);
  const std::string& chunk_at(const Place& at);
  void copy_chunk(const Place& at, hsize_t first, hsize_t count, std::string& to);
  std::size_t size_of_number() const { return bytes_of(number_.type); }
  std::size_t slab() const { return static_cast<std::size_t>(extent_[1] * extent_[2]) * size_of_number(); }

  Hdf5Handle set_;
  std::string name_;
  Bytes file_;
  std::vector<hsize_t> shape_;
  Place extent_{1, 1, 1};  ///< the shape, filled up with 1 at the end
  Hdf5Number number_;
  H5D_layout_t layout_ = H5D_CONTIGUOUS;
  std::uint64_t begin_ = 0;  ///< of a table in one piece
  std::string compact_;      ///< a table that is kept beside its description
  Place chunk_{1, 1, 1};
  std::size_t chunk_bytes_ = 0;
  bool whole_at_edges_ = true;  ///< chunks that reach over the edge are packed as others
  std::vector<Hdf5Filter> filters_;
  std::string fill_;  ///< the number in what was never written: the file's own, or none where a type has one, or 0
  Place held_at_{};
  bool held_ = false;
  std::string chunk_held_;  ///< the chunk that was read last
};

}  // namespace arenite::io
