#pragma once
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <string>
#include <vector>

#include "core/bytes.hpp"
#include "core/problems.hpp"
#include "io/disk/byte_source.hpp"
#include "io/hdf5/handle.hpp"

// HDF5 trusts what it reads: files of other programs are read in a process of their own, which a damaged file may bring down.
namespace arenite::io {

/// Bytes that `work` makes in a sandbox, a fork of this process that may use a gigabyte, twice `most` and `room` bytes more and a minute of the
/// processor: for libraries that a damaged file can bring down. InputErrors of `work` come through as they are; where the process ends otherwise, or
/// gives more than `most` bytes, one with `file` says that it is damaged. `work` finds all that this process has, but what it changes is lost, and it
/// must not start threads.
std::string in_sandbox(const std::string& file, const std::function<std::string()>& work, std::size_t most, std::size_t room = 0);

/// The same of a `T` that names its members in its function `transfer`, for files that HDF5 reads.
template <class T> T from_sandbox(const std::string& file, const std::function<T()>& work, std::size_t most, std::size_t room = 0) {
  prepare_hdf5();
  const auto packed = [&] {
    T made = work();
    ByteWriter write;
    made.transfer(write);
    return std::string(write.bytes.begin(), write.bytes.end());
  };
  const std::string bytes = in_sandbox(file, packed, most, room);
  T made;
  try {
    ByteReader read({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
    made.transfer(read);
    if (read.at_end()) return made;
  } catch (const InputError&) {}
  refuse(file, "is an HDF5 file that is cut short or damaged; copy it again");
}

// What follows is for `work`.

/// Lengths of a dataset's axes; empty for one without.
std::vector<std::int64_t> shape_of(hid_t set);

/// Whether what a dataset holds is of one of these classes.
bool holds(hid_t set, std::initializer_list<H5T_class_t> classes);

/// Which datasets of a file can be meant.
struct ForeignKind {
  bool (*fits)(hid_t set);
  const char* sentence;  ///< "dataset of whole numbers with two or three dimensions"
};

/// Name of the dataset that is meant in a file: `chosen`, or where that is empty the only one that fits. InputError where there is none, or several.
std::string meant_dataset(hid_t file, const std::string& file_name, const std::string& chosen, const ForeignKind& kind);

/// A dataset in an HDF5 file of anybody's, however its numbers are stored.
class ForeignDataset {
 public:
  /// InputError for one that lies in several files, announces more than its file can hold, or has chunks of more than `most` numbers.
  ForeignDataset(Hdf5Handle file, const Bytes& bytes, const std::string& name, double most);

  const std::vector<std::int64_t>& shape() const { return shape_; }
  hid_t id() const { return *set_; }
  int bits() const { return static_cast<int>(8 * H5Tget_size(*type_)); }  ///< of a number
  /// Whether its numbers are whole, of at most 16 bits and without sign.
  bool is_level() const { return bits() <= 16 && H5Tget_class(*type_) == H5T_INTEGER && H5Tget_sign(*type_) == H5T_SGN_NONE; }
  /// Slabs first .. first + count - 1 along the first axis as numbers of this type. InputError for damage.
  template <class T> std::vector<T> read(std::int64_t first, std::int64_t count) const {
    std::vector<T> numbers(static_cast<std::size_t>(count * numbers_in_slab()));
    read(first, count, number_type<T>(), numbers.data());
    return numbers;
  }

 private:
  [[noreturn]] void refuse(const std::string& what) const;
  std::int64_t numbers_in_slab() const;
  void read(std::int64_t first, std::int64_t count, hid_t type, void* to) const;

  Hdf5Handle file_, set_, type_;
  std::string file_name_, name_;
  std::vector<std::int64_t> shape_;
};

/// The first of these attributes that is one number above 0, or 0.
double number_attribute(hid_t at, std::initializer_list<const char*> names);

/// An attribute that is a text of fixed length; empty without one.
std::string text_attribute(hid_t at, const char* name);

/// A file of anybody's that is only read.
Hdf5Handle open_foreign(const Bytes& bytes);

}  // namespace arenite::io
