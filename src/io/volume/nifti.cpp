#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "core/option.hpp"
#include "core/problems.hpp"
#include "core/vec.hpp"
#include "io/disk/file.hpp"
#include "io/volume/header.hpp"
#include "io/volume/volume.hpp"

namespace arenite::io {
namespace {

constexpr std::size_t nifti_header_size = 348;

std::optional<NumberType> nifti_type(int code) {
  using enum NumberType;
  switch (code) {
    case 2: return u8;
    case 4: return i16;
    case 8: return i32;
    case 16: return f32;
    case 64: return f64;
    case 256: return i8;
    case 512: return u16;
    case 768: return u32;
    case 1024: return i64;
    case 1280: return u64;
    default: return std::nullopt;
  }
}

const char* nifti_unit(int code) { return code == 1 ? "m" : code == 2 ? "mm" : code == 3 ? "um" : ""; }

/// The members of the header, in the file's byte order.
class NiftiHeader {
 public:
  explicit NiftiHeader(std::string bytes)
      : bytes_(std::move(bytes)),
        big_endian_(number_at<std::int32_t>(bytes_, 0) != 348) {}
  bool big_endian() const { return big_endian_; }
  bool is_sound() const { return get<std::int32_t>(0) == 348; }
  template <class T> T get(std::size_t at) const {
    const T value = number_at<T>(bytes_, at);
    return big_endian_ ? swapped(value) : value;
  }
  std::string_view magic() const { return std::string_view(bytes_).substr(344, 4); }

 private:
  std::string bytes_;
  bool big_endian_;
};

using Steps = std::array<Vec3, 3>;  ///< from voxel to voxel along the axes of the file, in its unit

/// Of sform, which is stated where its code is above 0.
std::optional<Steps> steps_of_sform(const NiftiHeader& header) {
  if (header.get<std::int16_t>(254) <= 0) return std::nullopt;
  Steps along;
  for (std::size_t row = 0; row < 3; ++row)
    for (std::size_t axis = 0; axis < 3; ++axis)
      along[axis][static_cast<int>(row)] = static_cast<double>(header.get<float>(280 + 16 * row + 4 * axis));
  return along;
}

/// Of qform, a rotation as a quaternion of which three numbers are stated, and a mirrored third axis.
std::optional<Steps> steps_of_qform(const NiftiHeader& header) {
  if (header.get<std::int16_t>(252) <= 0) return std::nullopt;
  const auto number = [&](std::size_t at) { return static_cast<double>(header.get<float>(at)); };
  const double b = number(256), c = number(260), d = number(264),
               a = std::sqrt(std::max(0.0, 1 - (b * b + c * c + d * d)));
  const double side = number(76) < 0 ? -1 : 1;
  return Steps{Vec3{a * a + b * b - c * c - d * d, 2 * (b * c + a * d), 2 * (b * d - a * c)},
               {2 * (b * c - a * d), a * a + c * c - b * b - d * d, 2 * (c * d + a * b)},
               {side * 2 * (b * d + a * c), side * 2 * (c * d - a * b), side * (a * a + d * d - b * b - c * c)}};
}

/// What sform, or else qform, says beside the spacing: another spacing is refused, unless that of a voxel is given.
void take_place(VolumeFacts& facts, const NiftiHeader& header, const std::array<double, 3>& spacing, bool dx_given,
                const std::string& file) {
  const auto number = [&](std::size_t at) { return static_cast<double>(header.get<float>(at)); };
  if (const auto along = steps_of_sform(header)) {
    tell_turned(facts, *along, "the steps of its sform", file);
    for (std::size_t k = 0; k < 3 && !dx_given; ++k)
      if (const double side = norm((*along)[k]); !(std::abs(side / spacing[k] - 1) <= 1e-3))
        refuse(file,
               "states voxels of {:.6g} along axis {} by its sform and of {:.6g} by its pixdim; save it with the right "
               "one in both, or give the side of a voxel ({})",
               side, k + 1, spacing[k], option("dx"));
    tell_origin(facts, {number(292), number(308), number(324)}, "the offset of its sform");
  } else if (const auto turned = steps_of_qform(header)) {
    tell_turned(facts, *turned, "the steps of its qform", file);
    tell_origin(facts, {number(268), number(272), number(276)}, "the offset of its qform");
  }
}

VolumePointer open_nifti(const Bytes& stored, const VolumeChoice& choice) {
  const std::string& file = stored->name();
  const bool packed = is_gzip(stored->text(0, 2));
  const std::string all = packed ? stored->text(0, static_cast<std::size_t>(stored->size())) : std::string{};
  const NiftiHeader header(packed ? unpacked(all, nifti_header_size, file) : stored->text(0, nifti_header_size));
  if (packed && !header.is_sound()) refuse_compressed(all, file);
  if (!header.is_sound() || !header.magic().starts_with("n+1"))
    refuse(file, "is no NIfTI-1 file with its numbers in it; save it as .nii or .nii.gz");
  const int dimensions = header.get<std::int16_t>(40);
  bool flat = dimensions >= 3 && dimensions <= 7;
  for (int k = 4; flat && k <= dimensions; ++k)
    flat = header.get<std::int16_t>(40 + 2 * static_cast<std::size_t>(k)) == 1;
  if (!flat) refuse(file, "has {} dimensions; save a volume of three", dimensions);
  const auto type = nifti_type(header.get<std::int16_t>(70));
  if (!type) refuse(file, "has voxels of type {}; save whole numbers of up to 64 bits", header.get<std::int16_t>(70));
  VolumeFacts facts =
      sized({header.get<std::int16_t>(42), header.get<std::int16_t>(44), header.get<std::int16_t>(46)}, file);
  const auto spacing = [&](std::size_t k) { return static_cast<double>(header.get<float>(76 + 4 * k)); };
  const std::array<double, 3> sides{spacing(1), spacing(2), spacing(3)};
  take_side(facts, side_of(sides, file), nifti_unit(header.get<std::uint8_t>(123) & 7), choice.dx_given);
  take_place(facts, header, sides, choice.dx_given, file);
  VoxelLayout layout{.type = *type, .big_endian = header.big_endian()};
  const auto slope = static_cast<double>(header.get<float>(112));
  if (slope != 0 && std::isfinite(slope)) layout.slope = slope, layout.intercept = header.get<float>(116);
  const auto start = static_cast<double>(header.get<float>(108));
  if (!(start >= nifti_header_size && start < 1e9))
    refuse(file, "says that its numbers start at byte {:g}; save it again", start);
  if (!packed) return header_and_numbers(stored, static_cast<std::size_t>(start), false, 0, facts, layout);
  return header_and_numbers(stored, 0, true, static_cast<std::int64_t>(start), facts, layout);
}

}  // namespace

constinit const VolumeFormat volumes::nifti{
    .name = "nifti",
    .sentence = "NIfTI-1 (.nii, .nii.gz)",
    .states = {{"dim", "used: x fastest, z slowest; further axes of one are left aside, longer ones refused"},
               {"pixdim, xyzt_units",
                "used; refused where voxels are no cubes, without a unit left aside, and told; told where --dx is "
                "given and differs"},
               {"scl_slope, scl_inter", "used; what is no whole number then is refused"},
               {"more numbers than dim says", "left aside, and told"},
               {"sform of another spacing than pixdim, or whose axes lean",
                "refused; the spacing not where --dx is given"},
               {"sform, without it qform",
                "left aside, and told where they turn or mirror the axes or move the first voxel"}},
    .is =
        [](std::string_view head) {
          return (head.size() >= nifti_header_size && head.substr(344, 3) == "n+1") || is_gzip(head);
        },
    .open = open_nifti};

}  // namespace arenite::io
