#include "io/image/pixel_size.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>

#include "core/option.hpp"
#include "core/problems.hpp"
#include "io/hdf5/spacing.hpp"
#include "io/image/tiff.hpp"
#include "io/image/tiff_stack.hpp"
#include "io/table/table.hpp"

namespace arenite::io {
namespace {

constexpr double inch = 0.0254;

/// Of as many pixels a length along x and y; that length in m, 0 where it is not known.
std::optional<double> square_pixel(const std::string& file, double x, double y, double length, bool dx_given) {
  const bool is_stated = x > 0 && y > 0 && std::isfinite(x) && std::isfinite(y);
  const bool is_oblong = is_stated && !(std::abs(x / y - 1) < 1e-3);
  if (is_oblong && !dx_given)
    refuse(file,
           "has pixels {:.6g} times as wide as high, which are no squares; resample it to squares, or give the side of "
           "a pixel ({}) if they are squares all the same",
           y / x, option("dx"));
  if (!is_stated || is_oblong || !(length > 0)) return std::nullopt;
  const double pixel = length / x;
  return std::isfinite(pixel) ? std::optional(pixel) : std::nullopt;
}

/// A resolution of screens and printers is written by programs that know of no sample.
std::optional<double> unless_of_screens(std::optional<double> pixel) {
  constexpr double usual[] = {72, 96, 100, 120, 144, 150, 200, 240, 300, 400, 600, 1200};  // per inch
  const bool is_of_screens = pixel && std::ranges::any_of(usual, [&](double per_inch) {
                               return std::abs(*pixel * per_inch / inch - 1) < 2e-3;
                             });
  return is_of_screens ? std::nullopt : pixel;
}

StatedVoxel tiff_voxel(const Bytes& bytes, bool dx_given) {
  TiffSource source(bytes);
  const Tiff tiff = open_tiff(source);
  if (!tiff) return {};
  const char* text = nullptr;
  TiffStack stack;
  if (TIFFGetField(tiff.get(), TIFFTAG_IMAGEDESCRIPTION, &text) == 1 && text != nullptr)
    stack = stack_in(text, tiff_field<std::uint32_t>(tiff.get(), TIFFTAG_IMAGEWIDTH),
                     tiff_field<std::uint32_t>(tiff.get(), TIFFTAG_IMAGELENGTH));
  StatedVoxel voxel;
  if (stack.side[2] > 0) voxel.spacing = stack.side[2];
  if (stack.side[0] > 0 && stack.side[1] > 0) {
    voxel.pixel = square_pixel(bytes->name(), 1 / stack.side[0], 1 / stack.side[1], 1, dx_given);
    return voxel;
  }
  float x = 0, y = 0;
  if (TIFFGetField(tiff.get(), TIFFTAG_XRESOLUTION, &x) != 1 || TIFFGetField(tiff.get(), TIFFTAG_YRESOLUTION, &y) != 1)
    return voxel;
  const auto by = tiff_field<std::uint16_t>(tiff.get(), TIFFTAG_RESOLUTIONUNIT);
  const double by_tag = by == RESUNIT_INCH ? inch : by == RESUNIT_CENTIMETER ? 0.01 : 0;
  voxel.pixel = unless_of_screens(square_pixel(bytes->name(), static_cast<double>(x), static_cast<double>(y),
                                               stack.length_unit > 0 ? stack.length_unit : by_tag, dx_given));
  return voxel;
}

std::optional<double> png_pixel(const std::string& file, std::string_view head, bool dx_given) {
  const std::size_t at = head.find("pHYs");
  if (at == head.npos || at + 13 > head.size()) return std::nullopt;
  const auto number = [&](std::size_t from) {
    double value = 0;
    for (std::size_t k = 0; k < 4; ++k) value = 256 * value + static_cast<std::uint8_t>(head[from + k]);
    return value;
  };
  return unless_of_screens(square_pixel(file, number(at + 4), number(at + 8), head[at + 12] == 1 ? 1 : 0, dx_given));
}

StatedVoxel hdf5_voxel(const Bytes& bytes, const StatedOf& of) {
  const StatedSpacing stated = stated_spacing(bytes, {of.dataset, of.is_stack});
  StatedVoxel voxel;
  if (stated.by.empty()) return voxel;
  if (stated.side[0] > 0) voxel.spacing = stated.side[0];
  const double rows = stated.side[1], columns = stated.side[2];
  if (rows > 0 && columns > 0) voxel.pixel = square_pixel(bytes->name(), 1 / columns, 1 / rows, 1, of.dx_given);
  if (rows > 0 && columns > 0) voxel.by = stated.by;
  else
    voxel.remark = fmt::format(
        "by its {} it states a spacing without a known unit, or not along all axes, which is left aside; "
        "give {}",
        stated.by, option("dx"));
  return voxel;
}

}  // namespace

StatedVoxel stated_voxel(const Bytes& picture, const StatedOf& of) {
  const std::string head = picture->text(0, 4096);  // pHYs stands before the pixels
  if (is_tiff(head)) return tiff_voxel(picture, of.dx_given);
  if (is_hdf5(head)) return hdf5_voxel(picture, of);
  if (!head.starts_with("\x89PNG")) return {};
  return {.pixel = png_pixel(picture->name(), head, of.dx_given), .spacing = {}};
}

std::optional<double> stated_pixel(const std::filesystem::path& picture, const StatedOf& of) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(picture, error)) return std::nullopt;
  return stated_voxel(open_bytes(picture), of).pixel;
}

std::string told_pixel(double pixel) {
  return fmt::format(
      "the file states pixels of {0:.6g} um; to have lengths by them, give {1} \"{0:.6g} um\" (dx in [map] of a "
      "recipe)",
      1e6 * pixel, option("dx"));
}

std::string told_other_side(const char* what, double stated, double given) {
  if (std::abs(stated / given - 1) <= 1e-3) return {};
  return fmt::format("the file states {0}s of {1:.6g} um; the side of a {0} that is given, {2:.6g} um, is used", what,
                     1e6 * stated, 1e6 * given);
}

}  // namespace arenite::io
