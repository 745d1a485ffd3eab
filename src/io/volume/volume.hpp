#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "io/disk/byte_source.hpp"
#include "io/formats.hpp"

namespace arenite::io {

/// What a file says about its voxels.
struct VolumeFacts {
  int width = 0, height = 0, depth = 0;  ///< along x (fastest in the file), y and z (slowest)
  std::optional<double> dx;              ///< side of a voxel, m, where the file states it with its unit
  std::vector<std::string> remarks;      ///< what a user should know about this file, each a sentence
  bool elsewhere = false;  ///< the voxels lie in other files than the one named: beside their header, or in slices
  std::size_t slice() const { return static_cast<std::size_t>(width) * static_cast<std::size_t>(height); }
};

/// Voxels that are read layer by layer: all of them need never be in memory as numbers.
class VolumeSource {
 public:
  virtual ~VolumeSource() = default;
  virtual const VolumeFacts& facts() const = 0;
  /// Layer z, row by row, into facts().slice() numbers. Throws InputError for a damaged file, and for numbers that are
  /// not whole ones of 32 bits.
  virtual void read(int z, std::span<std::int32_t> layer) = 0;
};
using VolumePointer = std::unique_ptr<VolumeSource>;

/// Which array of a file is meant.
struct VolumeChoice {
  std::string dataset = {};  ///< of a .npz or HDF5 file; empty: the only one that can be meant
  bool dx_given = false;     ///< the side of a voxel is known: what the file states of it does not count
};

/// How a format of volumes is known and read.
struct VolumeFormat {
  std::string_view name, sentence;
  Statements states = {};
  bool always = true;  ///< holds nothing but volumes; otherwise it must be said that a stack is one
  bool (*is)(std::string_view head);
  VolumePointer (*open)(const Bytes& bytes, const VolumeChoice& choice);
};
namespace volumes {
ARENITE_FAMILY(VolumeFormat, ARENITE_VOLUME_FORMATS)
}

/// Whether a file, by its content, holds nothing but a volume.
bool is_volume(const std::filesystem::path& path);

/// The voxels of a file, of a folder of pictures, or of a name with * (slices in the order of the numbers in their
/// names). Throws InputError for what is none, damaged, or has voxels that are not cubes.
VolumePointer open_volume(const std::filesystem::path& path, const VolumeChoice& choice = {});

/// The same from bytes.
VolumePointer open_volume(const Bytes& bytes, const VolumeChoice& choice = {});

/// Whether a folder, or a name with *, is to be read as slices.
bool are_slices(const std::filesystem::path& path);

/// Hash of the voxels that lie in other files than the one that is named; empty where this one holds them.
std::string hash_of_voxels_elsewhere(const std::filesystem::path& path, const VolumeChoice& choice);

/// The formats that can be read, for a sentence.
std::string volume_formats();

/// How numbers lie in some bytes: number (x, y, z) at `start` + its place by the steps, in numbers.
struct VoxelLayout {
  NumberType type = NumberType::u8;
  bool big_endian = false;
  std::uint64_t start = 0;
  std::array<std::int64_t, 3> step{};  ///< all 0: x fastest, z slowest
  double slope = 1, intercept = 0;     ///< of what is stored
};

/// Voxels that lie in some bytes. Throws InputError where these are too few.
VolumePointer voxels_in(const Bytes& bytes, const VolumeFacts& facts, const VoxelLayout& layout);

inline bool is_gzip(std::string_view bytes) { return bytes.starts_with("\x1f\x8b"); }

/// The first `most` bytes of what zlib or gzip packed (all members of it), or of a member of a zip archive (`bare`:
/// without a header). Throws InputError where it is damaged.
std::string unpacked(const std::string& packed, std::size_t most, const std::string& file, bool bare = false);

/// The side of voxels with these spacings. Throws InputError where they differ by more than one part in a thousand.
double side_of(const std::array<double, 3>& spacing, const std::string& file);

/// Throws InputError where a size is not positive or their product beyond 2^31 - 1.
VolumeFacts sized(const std::array<std::int64_t, 3>& size, const std::string& file);

}  // namespace arenite::io
