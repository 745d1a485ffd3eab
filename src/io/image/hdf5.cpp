#include "core/problems.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "io/hdf5/axes.hpp"
#include "io/hdf5/dataset_search.hpp"
#include "io/hdf5/foreign.hpp"
#include "io/hdf5/netcdf.hpp"
#include "io/hdf5/sandbox.hpp"
#include "io/image/image.hpp"
#include "io/image/orientation.hpp"

namespace arenite::io {
namespace {

bool has_rank(hid_t set) {
  const std::size_t rank = shape_of(set).size();
  return rank == 2 || rank == 3;
}

bool is_of_class(hid_t set, std::initializer_list<H5T_class_t> classes) {
  const auto type = own(H5Dget_type(set), H5Tclose);
  return type && std::ranges::count(classes, H5Tget_class(*type)) > 0;
}

bool of_whole_numbers(hid_t set) { return has_rank(set) && is_of_class(set, {H5T_INTEGER, H5T_ENUM}); }
bool of_numbers(hid_t set) { return has_rank(set) && is_of_class(set, {H5T_INTEGER, H5T_ENUM, H5T_FLOAT}); }

/// Floating numbers are looked at where the file has no whole ones, or they are asked for by name.
FoundDataset find_picture(hid_t file, const std::string& file_name, const std::string& wanted) {
  const bool only_whole = wanted.empty() && !datasets_in(file, of_whole_numbers).empty();
  return find_dataset(file, file_name, wanted, only_whole ? of_whole_numbers : of_numbers,
                      "whole numbers with two or three dimensions");
}

/// The whole number that a stored one stands for. InputError for one that stands for none, as its file states.
template <class T>
std::int32_t value_of(T stored, const NumbersStated& stated, const std::string& file, std::size_t x, std::size_t row) {
  const auto number = static_cast<double>(stored);
  if (!std::isnan(number) && stated.is_missing(number))
    refuse(file,
           "holds {:g} at pixel {}, {}, which stands for no number by its _FillValue, missing_value or valid range; "
           "save whole numbers, one value per phase",
           number, x, row);
  if constexpr (std::is_integral_v<T>) {
    if (stated.scale == 1 && stated.offset == 0) {
      if (!std::in_range<std::int32_t>(stored))
        refuse(file, "holds the value {}; values go from -2147483648 to 2147483647", stored);
      return static_cast<std::int32_t>(stored);
    }
  }
  return whole_value(stated.scale * number + stated.offset, file, x, row);
}

Image decode(const std::string& bytes, const std::string& file, const ImageChoice& choice) {
  const auto id = open_in_memory(bytes, file);
  const auto [name, set] = find_picture(*id, file, choice.dataset);
  const auto shape = shape_of(*set);
  const bool stack = shape.size() == 3;
  const auto axis = order_by_names(names_of_axes(*set), file, name).axis;
  if (stack && axis[0] != 0)
    refuse(file, "holds a dataset \"{}\" whose slices are not its first axis; store it as slices x rows x columns",
           name);
  const std::int64_t slice = chosen_slice(file, stack ? shape[0] : 1, choice);
  const std::int64_t rows = shape[stack ? 1 : 0], columns = shape[stack ? 2 : 1];
  check_size(file, columns, rows, choice);
  Hdf5Numbers numbers(set, name, bytes_kept(bytes, file), std::max(2.0 * static_cast<double>(choice.most_pixels), 1e6));
  std::string stored;
  numbers.read(stack ? static_cast<hsize_t>(slice) : 0, stack ? 1 : static_cast<hsize_t>(rows), stored);
  Image image{static_cast<int>(columns), static_cast<int>(rows), {}};
  image.value.resize(image.size());
  const NumbersStated stated = numbers_stated(*set, numbers.number().type);
  const auto width = static_cast<std::size_t>(columns);
  each_number(numbers.number().type, numbers.number().big_endian, stored.data(), image.size(),
              [&](std::size_t i, auto v) { image.value[i] = value_of(v, stated, file, i % width, i / width); });
  constexpr int rows_are_columns = 5;
  const bool by_columns = is_of_matlab(*set) || axis[axis.size() - 2] > axis.back();
  return by_columns ? upright(std::move(image), rows_are_columns) : image;
}

/// HDF5 trusts what it reads: it is used in a process of its own, which a damaged file may bring down.
Image decode_hdf5(const std::string& bytes, const std::string& file, const ImageChoice& choice) {
  prepare_hdf5();
  const auto most = static_cast<std::size_t>(choice.most_pixels);
  const auto transfer = [](auto& archive, Image& image) {
    archive(image.width), archive(image.height), archive(image.value);
  };
  const auto work = [&] { return decode(bytes, file, choice); };
  Image image = record_from_sandbox<Image>(file, work, transfer, 16 + 4 * most, 24 * most + 3 * bytes.size());
  if (image.width <= 0 || image.height <= 0 || image.value.size() != image.size())
    refuse(file, "is an HDF5 file that is damaged; copy it again");
  return image;
}

}  // namespace

/// A two-dimensional dataset of whole numbers, or a slice along the first axis of a three-dimensional one; rows point
/// down, as NumPy and HDF5 viewers store and show pictures. MATLAB lists axes from the last to the first: its slices
/// are along the third.
const PictureFormat pictures::hdf5{
    .name = "hdf5",
    .sentence = "HDF5",
    .states =
        {{"MATLAB_class (MATLAB, save -v7.3)", "axes are taken as height x width x slices"},
         {"floating numbers", "taken where all are whole"},
         {"scale_factor, add_offset of netCDF", "used"},
         {"_FillValue, missing_value, what lies beyond valid_min, valid_max or valid_range",
          "refused where a pixel holds it"},
         {"names of axes (axistags of ilastik, DIMENSION_LABELS, dimension scales of netCDF and xarray)",
          "y, x and the like say which axis is which; slices that are not the first axis are refused"},
         {"size of a pixel (element_size_um of ImageJ, Fiji, ilastik and the like; coordinates of the axes with a "
          "unit of length)",
          "told where dx is not given, or differs; pixels that are no squares are then refused"}},
    .has_datasets = true,
    .is = is_hdf5,
    .read = decode_hdf5};

}  // namespace arenite::io
