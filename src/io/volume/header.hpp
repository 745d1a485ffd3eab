#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/vec.hpp"
#include "io/disk/byte_source.hpp"
#include "io/volume/volume.hpp"

namespace arenite::io {

/// Lines "key: value" or "key = value" before the numbers of a volume, keys in lower case.
struct TextHeader {
  std::string file;
  std::map<std::string, std::string> values;
  std::size_t size = 0;  ///< of the header, its last line included

  bool has(const std::string& key) const { return values.contains(key); }
  /// Throws InputError where the header does not say it.
  const std::string& word(const std::string& key) const;
  std::vector<double> numbers(const std::string& key, std::size_t count) const;
  std::vector<std::int64_t> whole_numbers(const std::string& key, std::size_t count) const;
};

/// Up to an empty line; or to the end of a file that names another for its numbers (`elsewhere`, keys of which one
/// does).
TextHeader header_until_blank(const Bytes& bytes, char separator, std::initializer_list<std::string> elsewhere);
/// Up to and with the line of this key.
TextHeader header_until_key(const Bytes& bytes, char separator, const std::string& key);

/// A file that a header names, beside it.
Bytes opened_beside(const Bytes& bytes, const std::string& name);

/// The side of a voxel in a unit, if it is one of length; otherwise it is left aside, with a remark unless `dx_given`.
void take_side(VolumeFacts& facts, double side, const std::string& unit, bool dx_given);

/// Says that x, y and z are the file's own axes, where the vectors along them, one after the other, turn or mirror
/// them. Throws InputError where they lean: voxels are no cubes then.
void tell_turned(VolumeFacts& facts, const std::array<Vec3, 3>& along, const char* stated, const std::string& file);

/// Says that the place of the first voxel, which a file states, is left aside; nothing where it is 0.
void tell_origin(VolumeFacts& facts, const Vec3& origin, const char* stated);

/// Numbers from `start` on, packed or not, of which `skip` bytes are left out; -1: all but those of the voxels.
VolumePointer header_and_numbers(const Bytes& data, std::size_t start, bool packed, std::int64_t skip,
                                 const VolumeFacts& facts, VoxelLayout layout);

}  // namespace arenite::io
