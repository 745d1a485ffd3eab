#include "io/volume/stack.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <numeric>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/option.hpp"
#include "core/problems.hpp"
#include "io/film/file_names.hpp"
#include "io/film/film.hpp"
#include "io/image/image.hpp"
#include "io/image/pixel_size.hpp"
#include "io/volume/volume.hpp"

namespace arenite::io {
namespace {

/// Pictures of a stack, one upon the other: what else reads them as the frames of a film.
class Slices : public VolumeSource {
 public:
  Slices(std::unique_ptr<FilmSource> film, const std::string& file, bool elsewhere, const StatedVoxel& voxel,
         bool dx_given)
      : film_(std::move(film)),
        file_(file) {
    const FilmInfo& info = film_->info();
    facts_ = sized({info.width, info.height, info.frames}, file);
    facts_.remarks = info.remarks;
    facts_.elsewhere = elsewhere;
    take_side_of(voxel, dx_given);
  }
  const VolumeFacts& facts() const override { return facts_; }
  void add_remark(std::string remark) { facts_.remarks.push_back(std::move(remark)); }
  void read(int z, std::span<std::int32_t> layer) override {
    film_->read(z, 1, block_);
    if (!block_.level.empty()) {
      std::copy(block_.level.begin(), block_.level.end(), layer.begin());
      return;
    }
    const auto width = static_cast<std::size_t>(facts_.width);
    for (std::size_t i = 0; i < layer.size(); ++i)
      layer[i] = whole_value(static_cast<double>(block_.value[i]), file_, i % width, i / width);
  }

 private:
  /// All three sides make the side of a voxel; a pixel by itself does not.
  void take_side_of(const StatedVoxel& voxel, bool dx_given) {
    if (voxel.pixel && voxel.spacing) facts_.dx = voxel.pixel;
    if (dx_given) return;
    if (facts_.dx)
      facts_.remarks.push_back(
          fmt::format("the file states pixels of {:.6g} um and pictures as far apart{}, which is taken as the side of "
                      "a voxel; give {} where it is not",
                      1e6 * *facts_.dx, voxel.by.empty() ? "" : " (" + voxel.by + ")", option("dx")));
    else if (voxel.pixel) facts_.remarks.push_back(told_pixel(*voxel.pixel));
    else if (!voxel.remark.empty()) facts_.remarks.push_back(voxel.remark);
  }

  std::unique_ptr<FilmSource> film_;
  std::string file_;
  VolumeFacts facts_;
  FrameBlock block_;
};

/// Slices of which one is missing are no volume: what lies above it would be too low.
/// Returns by how much their numbers rise, 0 where they have none.
std::int64_t refuse_missing(const std::vector<std::filesystem::path>& files, const std::string& name) {
  const std::vector<std::int64_t> number = numbers_in_names(files);
  std::int64_t step = 0;
  for (std::size_t i = 1; i < number.size(); ++i) step = std::gcd(step, number[i] - number[i - 1]);
  if (step <= 0) return 0;
  std::int64_t missing = 0;
  std::size_t first = 0;
  for (std::size_t i = number.size(); i-- > 1;)
    if (const std::int64_t there = (number[i] - number[i - 1]) / step; there > 1) missing += there - 1, first = i;
  if (missing == 0) return step;
  refuse(name,
         "lacks {} of its slices by the numbers of its files: the first, number {}, would follow {}; add what is "
         "missing, or number the files one by one if nothing is",
         missing, number[first - 1] + step, files[first - 1].filename().string());
}

/// A picture that can be no slice is refused here: what else would speak of films.
void refuse_other_picture(const std::filesystem::path& file) {
  const std::string head = open_bytes(file)->text(0, 8);
  const PictureFormat* is = first_format(pictures::all, [&](const PictureFormat& known) { return known.is(head); });
  if (is != nullptr && (is == &pictures::png || is == &pictures::jpeg))
    refuse(file.string(),
           "is a {} picture, and slices are read from TIFF; save each as TIFF, with its values unchanged",
           is->sentence);
}

/// What the first picture states. Layers that are further apart than pixels are wide, or nearer, make no cubes, unless
/// the side of a voxel is given.
StatedVoxel voxel_of_cubes(const Bytes& picture, const VolumeChoice& choice) {
  StatedVoxel voxel = stated_voxel(picture, {choice.dataset, true, choice.dx_given});
  if (!voxel.pixel || !voxel.spacing || std::abs(*voxel.spacing / *voxel.pixel - 1) <= 1e-3) return voxel;
  if (!choice.dx_given)
    refuse(picture->name(),
           "states pixels of {:.6g} um and pictures {:.6g} um apart, so that its voxels are no cubes; resample it to "
           "cubes, or give the side of a voxel ({}) if they are cubes all the same",
           1e6 * *voxel.pixel, 1e6 * *voxel.spacing, option("dx"));
  return {};
}

VolumePointer open_stack(const Bytes& bytes, const VolumeChoice& choice) {
  return std::make_unique<Slices>(open_film(bytes, FilmChoice{.dataset = choice.dataset, .in_time = false}),
                                  bytes->name(), false, voxel_of_cubes(bytes, choice), choice.dx_given);
}

}  // namespace

VolumePointer open_slices(const std::filesystem::path& path, const VolumeChoice& choice) {
  const auto files = files_of_series(path);
  refuse_other_picture(files.front());
  const std::int64_t step = refuse_missing(files, path.string());
  auto slices = std::make_unique<Slices>(open_film(path, FilmChoice{.in_time = false}), path.string(), true,
                                         voxel_of_cubes(open_bytes(files.front()), choice), choice.dx_given);
  if (step > 1)
    slices->add_remark(fmt::format(
        "the numbers of its files rise by {}, and the slices are taken as neighbours, a voxel apart", step));
  return slices;
}

constinit const VolumeFormat volumes::stack{
    .name = "stack",
    .sentence = "a stack of pictures (TIFF, HDF5, a folder of TIFF slices)",
    .states = {{"pictures",
                "one upon the other: the first is z = 0, rows of a picture go along x, its columns along y"},
               {"numbers in the names of slices",
                "their order; refused where one is missing, which is named; told where they rise by more than 1"},
               {"size of a pixel (TIFF's resolution, unit of ImageJ, OME's PhysicalSize)",
                "used together with the way from picture to picture, and told; alone told, not used: give --dx"},
               {"way from picture to picture (ImageJ's spacing, OME's PhysicalSizeZ)",
                "refused where it is not that of a pixel, unless --dx is given; told where that differs from both"},
               {"element_size_um (HDF5 of ImageJ, Fiji, ilastik), voxel_size_um, spacing_mm and the like of a dataset",
                "used in the unit of the name, z, y, x, and told; refused where voxels are no cubes; without a unit "
                "told, not used"},
               {"coordinates of the axes of a dataset (dimension scales of netCDF and xarray)",
                "used where they lie at equal distances and state a unit of length, and told"},
               {"axes of a dataset (axistags of ilastik, DIMENSION_LABELS, dimension scales)",
                "say which axis is which, and are told where they turn the volume"}},
    .always = false,
    .is = [](std::string_view head) { return is_tiff(head) || is_hdf5(head); },
    .open = open_stack};

}  // namespace arenite::io
