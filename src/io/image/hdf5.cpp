#include "core/problems.hpp"
#include "io/image/image.hpp"

#include <algorithm>
#include <vector>

#include "io/hdf5/foreign.hpp"

namespace arenite::io {
namespace {

bool can_be_picture(hid_t set) {
  const auto type = own(H5Dget_type(set), H5Tclose);
  const bool whole = type && (H5Tget_class(*type) == H5T_INTEGER || H5Tget_class(*type) == H5T_ENUM);
  const std::size_t rank = shape_of(set).size();
  return whole && (rank == 2 || rank == 3);
}

Image decode(const std::string& bytes, const std::string& file, const ImageChoice& choice) {
  const auto id = open_in_memory(bytes, file);
  const auto [name, set] = find_dataset(*id, file, choice.dataset, can_be_picture, "whole numbers with two or three dimensions");
  const auto shape = shape_of(*set);
  const bool stack = shape.size() == 3;
  const std::int64_t slice = chosen_slice(file, stack ? shape[0] : 1, choice);
  const std::int64_t height = shape[stack ? 1 : 0], width = shape[stack ? 2 : 1];
  check_size(file, width, height, choice);
  Hdf5Numbers numbers(set, name, bytes_kept(bytes, file), std::max(2.0 * static_cast<double>(choice.most_pixels), 1e6));
  std::string stored;
  numbers.read(stack ? static_cast<hsize_t>(slice) : 0, stack ? 1 : static_cast<hsize_t>(height), stored);
  Image image{static_cast<int>(width), static_cast<int>(height), {}};
  image.value.resize(image.size());
  each_number(numbers.number().type, numbers.number().big_endian, stored.data(), image.size(), [&](std::size_t i, auto v) {
    if constexpr (std::is_integral_v<decltype(v)>) {
      if (!std::in_range<std::int32_t>(v)) refuse(file, "holds the value {}; values go from -2147483648 to 2147483647", v);
      image.value[i] = static_cast<std::int32_t>(v);
    }
  });
  return image;
}

/// HDF5 trusts what it reads: it is used in a process of its own, which a damaged file may bring down.
Image decode_hdf5(const std::string& bytes, const std::string& file, const ImageChoice& choice) {
  prepare_hdf5();
  const auto most = static_cast<std::size_t>(choice.most_pixels);
  const auto transfer = [](auto& archive, Image& image) { archive(image.width), archive(image.height), archive(image.value); };
  const auto work = [&] { return decode(bytes, file, choice); };
  Image image = record_from_sandbox<Image>(file, work, transfer, 16 + 4 * most, 24 * most + 3 * bytes.size());
  if (image.width <= 0 || image.height <= 0 || image.value.size() != image.size()) refuse(file, "is an HDF5 file that is damaged; copy it again");
  return image;
}

}  // namespace

/// A two-dimensional dataset of whole numbers, or a slice along the first axis of a three-dimensional one; rows point down, as NumPy and HDF5 viewers
/// store and show pictures.
const PictureFormat pictures::hdf5{.name = "hdf5", .sentence = "HDF5", .has_datasets = true, .is = is_hdf5, .read = decode_hdf5};

}  // namespace arenite::io
