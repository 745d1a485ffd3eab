#include "io/image/image.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <string_view>
#include <utility>

#include "core/option.hpp"
#include "core/problems.hpp"
#include "core/text.hpp"

namespace arenite::io {
namespace {

/// The value of a pixel of these colours.
std::int64_t seen(const PixelLayout& layout, std::int64_t red, std::int64_t green, std::int64_t blue, std::size_t x,
                  std::size_t row) {
  if (red == green && green == blue) return red;
  switch (layout.channel) {
    case Channel::red: return red;
    case Channel::green: return green;
    case Channel::blue: return blue;
    case Channel::mean: return (red + green + blue + 1) / 3;
    case Channel::grey: return (299 * red + 587 * green + 114 * blue + 500) / 1000;
    case Channel::none: break;
  }
  refuse(layout.file,
         "is in colour (pixel {}, {}), and colours are not phases; save it as greyscale with one value per phase", x,
         row);
}

bool is_clear(const PixelLayout& layout, const std::int64_t* sample) {
  return std::ranges::any_of(layout.clear, [&](const auto& of) {
    return sample[0] == of[0] && (!layout.colour || (sample[1] == of[1] && sample[2] == of[2]));
  });
}

std::int64_t shown(const PixelLayout& layout, std::int64_t index, std::size_t x, std::size_t row) {
  if (index < 0 || index >= static_cast<std::int64_t>(layout.palette.size()))
    refuse(layout.file, "is damaged: pixel {}, {} is not in its palette; copy it again", x, row);
  const auto& entry = layout.palette[static_cast<std::size_t>(index)];
  return seen(layout, entry[0], entry[1], entry[2], x, row);
}

}  // namespace

std::string picture_formats(bool exact) {
  return list_of(words_of(pictures::all, &PictureFormat::sentence,
                          [&](const PictureFormat& format) { return !(exact && format.blurs); }));
}

Image decode_image(const std::string& bytes, const std::string& file, const ImageChoice& choice) {
  if (bytes.empty()) refuse(file, "is empty; copy it again");
  const PictureFormat* format =
      first_format(pictures::all, [&](const PictureFormat& known) { return known.is(bytes); });
  if (format == nullptr) refuse_compressed(bytes, file);
  if (format == nullptr) refuse(file, "is no picture in a known format; save it as one of {}", picture_formats());
  if (!choice.dataset.empty() && !format->has_datasets)
    refuse(file, "is {}, which holds no datasets; leave out the dataset \"{}\"", format->sentence, choice.dataset);
  if (format->blurs && choice.channel == Channel::none)
    refuse(file, "is a {} picture, which blurs values across edges; save the phases as one of {}", format->sentence,
           picture_formats(true));
  return format->read(bytes, file, choice);
}

Image read_image(const std::filesystem::path& path, const ImageChoice& choice) {
  return decode_image(read_file(path), path.string(), choice);
}

void check_size(const std::string& file, std::int64_t width, std::int64_t height, const ImageChoice& choice) {
  if (width <= 0 || height <= 0)
    refuse(file, "holds a picture of {} x {} pixels; give one with at least one in each direction", width, height);
  constexpr auto most = std::int64_t{std::numeric_limits<std::int32_t>::max()};
  if (width > most || height > most || width > choice.most_pixels / height)
    refuse(file, "holds a picture of {} x {} pixels, but at most {} million can be read; crop it", width, height,
           static_cast<double>(choice.most_pixels) / 1e6);
}

std::int64_t chosen_slice(const std::string& file, std::int64_t count, const ImageChoice& choice) {
  if (count <= 0) refuse(file, "holds no picture; give a file with at least one");
  if (!choice.slice && count > 1)
    refuse(file, "is a stack of {} slices; choose one with {} 0 to {}, or for a load take all as voxels with {} 3",
           count, option("slice"), count - 1, option("dimension"));
  const std::int64_t slice = choice.slice.value_or(0);
  if (slice < 0 || slice >= count)
    refuse(file, "has no slice {}; its slices are numbered from 0 to {}", slice, count - 1);
  return slice;
}

Image empty_image(const PixelLayout& layout) {
  Image image{layout.width, layout.height, {}};
  image.value.resize(image.size());
  return image;
}

Image image_of(const PixelLayout& layout, const std::vector<std::uint8_t>& samples, std::size_t stride) {
  Image image = empty_image(layout);
  const auto width = static_cast<std::size_t>(layout.width), height = static_cast<std::size_t>(layout.height);
  for (std::size_t y = 0; y < height; ++y) take_row(layout, samples.data() + stride * y, 0, y, width, image);
  return image;
}

std::int32_t whole_value(double value, const std::string& file, std::size_t x, std::size_t row) {
  if (!(std::trunc(value) == value)) {
    if (std::isnan(value))
      refuse(file, "holds no number at pixel {}, {}; save whole numbers, one value per phase", x, row);
    refuse(
        file,
        "holds floating-point numbers with fractions ({:g} at pixel {}, {}); save whole numbers, one value per phase",
        value, x, row);
  }
  if (!(std::abs(value) <= std::numeric_limits<std::int32_t>::max()))
    refuse(file, "holds the value {:g} at pixel {}, {}; values go from -2147483647 to 2147483647", value, x, row);
  return static_cast<std::int32_t>(value);
}

void take_floating_row(const PixelLayout& layout, const std::uint8_t* samples, std::size_t x, std::size_t row,
                       std::size_t count, Image& image) {
  const NumberType type = layout.bits == 64 ? NumberType::f64 : NumberType::f32;
  std::int32_t* const to = image.value.data() + row * static_cast<std::size_t>(image.width);
  each_number(type, false, reinterpret_cast<const char*>(samples), count,
              [&](std::size_t i, auto v) { to[x + i] = whole_value(static_cast<double>(v), layout.file, x + i, row); });
}

void take_row(const PixelLayout& layout, const std::uint8_t* samples, std::size_t x, std::size_t row, std::size_t count,
              Image& image) {
  const auto per_pixel = static_cast<std::size_t>(layout.samples);
  const auto bytes = static_cast<unsigned>(std::max(layout.bits / 8, 1));
  const auto type = static_cast<NumberType>(2 * std::countr_zero(bytes) + (layout.is_signed ? 1 : 0));
  const std::int64_t most = (std::int64_t{1} << (layout.is_signed ? layout.bits - 1 : layout.bits)) - 1;
  std::vector<std::int64_t> sample(count * per_pixel);
  each_number(type, false, reinterpret_cast<const char*>(samples), sample.size(),
              [&](std::size_t i, auto v) { sample[i] = static_cast<std::int64_t>(v); });
  std::int32_t* const to = image.value.data() + row * static_cast<std::size_t>(image.width);
  for (std::size_t k = 0; k < count; ++k, ++x) {
    const std::int64_t* const here = sample.data() + k * per_pixel;
    std::int64_t value = here[0];
    if (layout.colour) value = seen(layout, value, here[1], here[2], x, row);
    if ((layout.opacity && here[per_pixel - 1] != most) || is_clear(layout, here))
      refuse(layout.file, "is transparent at pixel {}, {}; save it without transparency", x, row);
    if (!layout.palette.empty()) value = shown(layout, value, x, row);
    if (layout.inverted) value = most - value;
    if (value > std::numeric_limits<std::int32_t>::max())
      refuse(layout.file, "holds the value {} at pixel {}, {}; values go up to 2147483647", value, x, row);
    to[x] = static_cast<std::int32_t>(value);
  }
}

}  // namespace arenite::io
