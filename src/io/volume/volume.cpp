#include "io/volume/volume.hpp"

#include <fmt/core.h>
#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>
#include <type_traits>
#include <utility>

#include "core/hash.hpp"
#include "core/problems.hpp"
#include "core/text.hpp"
#include "io/disk/file.hpp"
#include "io/image/image.hpp"
#include "io/volume/stack.hpp"

namespace arenite::io {
namespace {

constexpr std::size_t volume_head = 512;

const VolumeFormat* volume_format_of(const Bytes& bytes) {
  const std::string head = bytes->text(0, volume_head);
  return first_format(volumes::all, [&](const VolumeFormat& format) { return format.is(head); });
}

class StoredVoxels : public VolumeSource {
 public:
  StoredVoxels(Bytes bytes, VolumeFacts facts, const VoxelLayout& layout)
      : bytes_(std::move(bytes)),
        facts_(std::move(facts)),
        layout_(layout) {
    if (layout_.step == std::array<std::int64_t, 3>{})
      layout_.step = {1, facts_.width, static_cast<std::int64_t>(facts_.slice())};
    const std::uint64_t wanted =
        layout_.start + bytes_of(layout_.type) * facts_.slice() * static_cast<std::uint64_t>(facts_.depth);
    if (bytes_->size() < wanted)
      refuse(bytes_->name(), "ends after {} bytes; {} x {} x {} voxels take {}: copy it again", bytes_->size(),
             facts_.width, facts_.height, facts_.depth, wanted);
    if (bytes_->size() > wanted)
      facts_.remarks.push_back(
          fmt::format("more numbers follow than {} x {} x {} voxels have, and are left aside; check these sizes",
                      facts_.width, facts_.height, facts_.depth));
  }
  const VolumeFacts& facts() const override { return facts_; }

  void read(int z, std::span<std::int32_t> layer) override {
    const auto [dx, dy, dz] = layout_.step;
    if (dx == 1 && dy == facts_.width) {
      take(static_cast<std::uint64_t>(z * dz), facts_.slice(), layer.data());
      return;
    }
    for (int y = 0; y < facts_.height; ++y)
      for (int x = 0; x < facts_.width; ++x)
        take(
            static_cast<std::uint64_t>(z * dz + y * dy + x * dx), 1,
            &layer[static_cast<std::size_t>(x) + static_cast<std::size_t>(y) * static_cast<std::size_t>(facts_.width)]);
  }

 private:
  void take(std::uint64_t from, std::size_t count, std::int32_t* to) {
    const std::size_t size = bytes_of(layout_.type);
    buffer_.resize(count * size);
    if (bytes_->read(layout_.start + from * size, buffer_.size(), buffer_.data()) != buffer_.size())
      refuse(bytes_->name(), "became shorter while it was read; read it again");
    each_number(layout_.type, layout_.big_endian, buffer_.data(), count, [&](std::size_t i, auto value) {
      const bool scaled = layout_.slope != 1 || layout_.intercept != 0;
      if constexpr (std::is_integral_v<decltype(value)>) {
        if (!scaled && std::in_range<std::int32_t>(value)) {
          to[i] = static_cast<std::int32_t>(value);
          return;
        }
      }
      const double number = layout_.slope * static_cast<double>(value) + layout_.intercept;
      to[i] = whole_value(number, bytes_->name(), i % static_cast<std::size_t>(facts_.width),
                          i / static_cast<std::size_t>(facts_.width));
    });
  }

  Bytes bytes_;
  VolumeFacts facts_;
  VoxelLayout layout_;
  std::string buffer_;
};

}  // namespace

VolumePointer voxels_in(const Bytes& bytes, const VolumeFacts& facts, const VoxelLayout& layout) {
  return std::make_unique<StoredVoxels>(bytes, facts, layout);
}

std::string unpacked(const std::string& packed, std::size_t most, const std::string& file, bool bare) {
  constexpr int any_header = 15 + 32, no_header = -15;
  z_stream stream{};
  if (inflateInit2(&stream, bare ? no_header : any_header) != Z_OK) throw std::bad_alloc();
  // Deflate packs at most a thousandfold: what says more was never written, and gets no memory.
  most = std::min(most, 1100 * packed.size() + 64);
  std::string plain(most, '\0');
  std::size_t read = 0, written = 0;
  int status = Z_OK;
  constexpr std::size_t at_once = std::size_t{1} << 30;
  while (status == Z_OK) {
    stream.next_in = const_cast<Bytef*>(reinterpret_cast<const Bytef*>(packed.data() + read));
    stream.avail_in = static_cast<uInt>(std::min(at_once, packed.size() - read));
    stream.next_out = reinterpret_cast<Bytef*>(plain.data() + written);
    stream.avail_out = static_cast<uInt>(std::min(at_once, plain.size() - written));
    const uInt in = stream.avail_in, out = stream.avail_out;
    status = inflate(&stream, Z_NO_FLUSH);
    read += in - stream.avail_in;
    written += out - stream.avail_out;
    if (status == Z_STREAM_END && !bare && written < most && is_gzip(std::string_view(packed).substr(read)))
      status = inflateReset(&stream);  // members one behind the other, as bgzip and `cat` write them
    else if (in == stream.avail_in && out == stream.avail_out) break;
  }
  inflateEnd(&stream);
  if (status == Z_DATA_ERROR || (status != Z_STREAM_END && written < most))
    refuse(file, "is packed and damaged after {} bytes; copy it again", read);
  plain.resize(written);
  return plain;
}

double side_of(const std::array<double, 3>& spacing, const std::string& file) {
  const auto [least, most] = std::minmax({std::abs(spacing[0]), std::abs(spacing[1]), std::abs(spacing[2])});
  if (!(least > 0) || !std::isfinite(most) || most > 1.001 * least)
    refuse(file, "has voxels of {:g} x {:g} x {:g}, which are no cubes; resample it to cubes", spacing[0], spacing[1],
           spacing[2]);
  return least;
}

VolumeFacts sized(const std::array<std::int64_t, 3>& size, const std::string& file) {
  double all = 1;
  for (const std::int64_t n : size) {
    if (n < 1) refuse(file, "states {} x {} x {} voxels; each must be 1 or more", size[0], size[1], size[2]);
    all *= static_cast<double>(n);
  }
  if (all > std::numeric_limits<std::int32_t>::max())
    refuse(file, "states {} x {} x {} voxels, more than 2^31 - 1; cut it into parts", size[0], size[1], size[2]);
  VolumeFacts facts;
  facts.width = static_cast<int>(size[0]), facts.height = static_cast<int>(size[1]);
  facts.depth = static_cast<int>(size[2]);
  return facts;
}

bool is_volume(const std::filesystem::path& path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return false;
  const VolumeFormat* format = volume_format_of(open_bytes(path));
  return format && format->always;
}

bool are_slices(const std::filesystem::path& path) {
  std::error_code error;
  return std::filesystem::is_directory(path, error) || path.filename().string().find('*') != std::string::npos;
}

std::string hash_of_voxels_elsewhere(const std::filesystem::path& path, const VolumeChoice& choice) {
  const VolumePointer volume = open_volume(path, choice);
  const VolumeFacts& facts = volume->facts();
  if (!facts.elsewhere) return {};
  HashBuilder hash;
  hash.add("width", std::int64_t{facts.width}).add("height", std::int64_t{facts.height});
  std::vector<std::int32_t> layer(facts.slice());
  for (int z = 0; z < facts.depth; ++z) {
    volume->read(z, layer);
    hash.add("layer", content_hash({reinterpret_cast<const char*>(layer.data()), layer.size() * sizeof(std::int32_t)}));
  }
  return hash.hex();
}

std::string volume_formats() { return list_of(words_of(volumes::all, &VolumeFormat::sentence)); }

VolumePointer open_volume(const std::filesystem::path& path, const VolumeChoice& choice) {
  return are_slices(path) ? open_slices(path, choice) : open_volume(open_bytes(path), choice);
}

VolumePointer open_volume(const Bytes& bytes, const VolumeChoice& choice) {
  const VolumeFormat* format = volume_format_of(bytes);
  if (!format) refuse_compressed(bytes->text(0, volume_head), bytes->name());
  if (!format)
    refuse(bytes->name(),
           "is no volume of a known format ({}); numbers without a header need one, such as a MetaImage (.mhd) that "
           "names their file",
           volume_formats());
  return format->open(bytes, choice);
}

}  // namespace arenite::io
