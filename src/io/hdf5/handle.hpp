#pragma once
#include <hdf5.h>

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/disk/byte_source.hpp"

// Only the files that speak HDF5 include this one.
namespace arenite::io {

/// HDF5 may be built without locks of its own: one thread at a time speaks to it, the one that has its turn. Who has it
/// may take it again, also in a process that is forked meanwhile. A fork by another thread waits for the turn to end:
/// in the new process nobody else would give it back.
class Hdf5Turn {
 public:
  Hdf5Turn();
  ~Hdf5Turn();
  Hdf5Turn(const Hdf5Turn&) = delete;
  Hdf5Turn& operator=(const Hdf5Turn&) = delete;
};

/// An HDF5 identifier that closes itself.
using Hdf5Handle = std::shared_ptr<const std::int64_t>;
static_assert(sizeof(hid_t) == sizeof(std::int64_t));

/// Takes over what HDF5 returned; a null handle if the call failed.
Hdf5Handle own(hid_t id, herr_t (*close)(hid_t));

/// The same for what we build in memory: this fails only for lack of memory or by our own fault, std::runtime_error.
Hdf5Handle made(hid_t id, herr_t (*close)(hid_t));
void done(herr_t status);

/// Starts HDF5 in this process, for all processes that are forked from it.
void prepare_hdf5();

/// For a file in memory; silences HDF5's own messages on stderr, since failures become our errors.
Hdf5Handle memory_properties();

/// HDF5 takes two open files of one name for the same file, so each file in memory has a name of its own.
std::string unused_name();

/// A file in memory as it stands, with the `before` bytes of a user block.
std::string bytes_of_file(hid_t file, std::size_t before = 0);

/// Properties of a dataset or a group that is made without a time, so that the same content gives the same bytes; of a
/// group or a file, whose members and attributes keep the order in which they are written, too.
Hdf5Handle timeless(hid_t kind);
void keep_order(hid_t properties);

/// Chunks and deflates a dataset that is made with these properties.
void pack(hid_t properties, const std::vector<hsize_t>& chunk, bool shuffle, unsigned level);

/// Writes an array of this size (one value without any) with all its values; and one value as an attribute. `type` is
/// that of the values, in the file and in memory.
Hdf5Handle write_set(hid_t group, const std::string& name, const std::vector<hsize_t>& size, hid_t type,
                     hid_t properties, const void* values);
void write_attribute(hid_t owner, const std::string& name, hid_t type, const void* value);

/// How numbers lie in the file: lowest byte first, as in memory.
template <class T> hid_t number_type();
template <> inline hid_t number_type<double>() { return H5T_IEEE_F64LE; }
template <> inline hid_t number_type<float>() { return H5T_IEEE_F32LE; }
template <> inline hid_t number_type<std::int32_t>() { return H5T_STD_I32LE; }
template <> inline hid_t number_type<std::int64_t>() { return H5T_STD_I64LE; }
template <> inline hid_t number_type<std::uint64_t>() { return H5T_STD_U64LE; }
template <> inline hid_t number_type<std::uint8_t>() { return H5T_STD_U8LE; }

/// UTF-8 text of a fixed length, of at least one byte, for HDF5 knows none of length 0; without a length, of any. And a
/// text as an attribute.
Hdf5Handle text_type(std::optional<std::size_t> length);
void write_text(hid_t owner, const std::string& name, std::string_view text);

template <class T> void write_number(hid_t owner, const std::string& name, T value) {
  write_attribute(owner, name, number_type<T>(), &value);
}

/// A file in memory that is read, whoever wrote it; `file` names it in the InputError of one that HDF5 cannot open.
Hdf5Handle open_in_memory(std::string bytes, const std::string& file,
                          const char* refusal = "is an HDF5 file that is cut short or damaged; copy it again");

/// Lengths of a dataset's axes; empty for one without.
std::vector<std::int64_t> shape_of(hid_t set);

/// How numbers of an HDF5 type lie in a file; nothing for a type that is no plain number of 1 to 8 bytes.
struct Hdf5Number {
  NumberType type = NumberType::u16;
  bool big_endian = false;
};
std::optional<Hdf5Number> number_of(hid_t type);

/// Whether MATLAB wrote an array (save -v7.3): its axes are then listed from the last to the first.
bool is_of_matlab(hid_t set);

/// An attribute that is one number; nothing without one. And the first of some that is above 0, or 0.
std::optional<double> stated_number(hid_t at, const char* name);
double number_attribute(hid_t at, std::initializer_list<const char*> names);

/// As many values as a list of names or limits has at most.
inline constexpr std::size_t most_listed = 32;

/// An attribute that is at most so many numbers; none without one.
struct StatedNumbers {
  std::vector<double> value;
  bool whole = false;  ///< stored as integers
};
StatedNumbers stated_numbers(hid_t at, const char* name, std::size_t most = most_listed);

/// An attribute that is a text; empty without one. And one that is a few texts.
std::string text_attribute(hid_t at, const char* name);
std::vector<std::string> texts_attribute(hid_t at, const char* name);

}  // namespace arenite::io
