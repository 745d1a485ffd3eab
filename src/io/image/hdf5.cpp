#include "core/problems.hpp"
#include "io/image/image.hpp"

#include <algorithm>
#include <utility>

#include "core/mapped.hpp"
#include "io/hdf5/foreign.hpp"

namespace arenite::io {
namespace {

constexpr ForeignKind pictures{[](hid_t set) {
                                 const std::size_t rank = shape_of(set).size();
                                 return (rank == 2 || rank == 3) && holds(set, {H5T_INTEGER, H5T_ENUM});
                               },
                               "dataset of whole numbers with two or three dimensions"};

Image decode(const std::string& bytes, const std::string& file, const ImageChoice& choice) {
  const Bytes source = bytes_kept(bytes, file);
  const auto id = open_foreign(source);
  const std::string name = meant_dataset(*id, file, choice.dataset, pictures);
  const auto shape = shape_of(*own(H5Dopen2(*id, name.c_str(), H5P_DEFAULT), H5Dclose));
  const bool stack = shape.size() == 3;
  const std::int64_t slice = chosen_slice(file, stack ? shape[0] : 1, choice);
  const std::int64_t height = shape[stack ? 1 : 0], width = shape[stack ? 2 : 1];
  check_size(file, width, height, choice);
  const ForeignDataset numbers(id, source, name, std::max(2.0 * static_cast<double>(choice.most_pixels), 1e6));
  Image image{static_cast<int>(width), static_cast<int>(height), {}};
  image.value = mapped(numbers.read<std::int64_t>(stack ? slice : 0, stack ? 1 : height), [&](std::int64_t v) {
    if (!std::in_range<std::int32_t>(v)) refuse(file, "holds the value {}; values go from -2147483648 to 2147483647", v);
    return static_cast<std::int32_t>(v);
  });
  return image;
}

struct Decoded {
  Image image;

  template <class Archive> void transfer(Archive& a) { a(image.width), a(image.height), a(image.value); }
};

}  // namespace

Image read_hdf5_image(const std::string& bytes, const std::string& file, const ImageChoice& choice) {
  const auto pixels = static_cast<std::size_t>(choice.most_pixels);
  auto [image] = from_sandbox<Decoded>(
      file, [&] { return Decoded{decode(bytes, file, choice)}; }, 64 + 4 * pixels, 24 * pixels + 3 * bytes.size());
  if (image.width <= 0 || image.height <= 0 || image.value.size() != image.size()) refuse(file, "is an HDF5 file that is damaged; copy it again");
  return image;
}

}  // namespace arenite::io
