#include "io/image/tiff_stack.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "core/problems.hpp"
#include "core/text.hpp"
#include "io/stated_units.hpp"

namespace arenite::io {
namespace {

constexpr std::int64_t most = 2'000'000;  // of images along an axis; products of three fit 64 bits

/// A count of 1 or more; 1 for anything else.
std::int64_t count_of(std::string_view text) {
  const auto n = parse_number<std::int64_t>(trimmed(text));
  return n && *n >= 1 && *n <= most ? *n : 1;
}

std::optional<double> number_in(std::string_view text) {
  const auto value = parse_number<double>(trimmed(text));
  return value && std::isfinite(*value) ? value : std::nullopt;
}

double positive(std::string_view text) { return std::max(0.0, number_in(text).value_or(0)); }

TiffStack of_imagej(std::string_view text) {
  TiffStack stack{.by = "ImageJ"};
  std::int64_t images = 1;
  std::string_view unit;
  double spacing = 0;
  std::optional<double> zero, step;  // of a calibration by a straight line, ImageJ's function 0
  bool straight = false;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    const std::string_view line = text.substr(at, end - at), key = line.substr(0, line.find('=')),
                           value = line.substr(std::min(key.size() + 1, line.size()));
    if (key == "images") images = count_of(value);
    if (key == "channels") stack.channels = count_of(value);
    if (key == "slices") stack.slices = count_of(value);
    if (key == "frames") stack.frames = count_of(value);
    if (key == "finterval") stack.interval = positive(value);
    if (key == "fps") stack.shown_per_second = positive(value);
    if (key == "tunit") unit = value;
    if (key == "unit") stack.length_unit = in_metres(1, value).value_or(0);
    if (key == "spacing") spacing = positive(value);
    if (key == "cf") straight = trimmed(value) == "0";
    if (key == "c0") zero = number_in(value);
    if (key == "c1") step = number_in(value);
    if (key == "vunit") stack.number_unit = trimmed(value);
    at = end + 1;
  }
  if (stack.images() == 1) stack.slices = images;  // a plain stack states no more
  stack.side[2] = spacing * stack.length_unit;
  if (straight && zero && step) stack.number_zero = *zero, stack.number_step = *step;
  if (const auto seconds = seconds_of(unit)) stack.interval *= *seconds;
  else stack.interval = 0, stack.unknown_unit = unit;
  return stack;
}

/// The value of an attribute of the tag that begins at the text's start.
std::string_view attribute(std::string_view tag, std::string_view name) {
  tag = tag.substr(0, tag.find('>'));
  const std::string key = " " + std::string(name) + "=\"";
  const std::size_t at = tag.find(key);
  if (at == std::string_view::npos) return {};
  const std::string_view value = tag.substr(at + key.size());
  return value.substr(0, value.find('"'));
}

TiffStack of_ome(std::string_view text) {
  TiffStack stack{.by = "OME"};
  const std::string_view pixels = text.substr(text.find("<Pixels"));
  stack.channels = count_of(attribute(pixels, "SizeC"));
  stack.slices = count_of(attribute(pixels, "SizeZ"));
  stack.frames = count_of(attribute(pixels, "SizeT"));
  if (std::string order(attribute(pixels, "DimensionOrder")); order.starts_with("XY") && order.size() == 5)
    stack.order = order.substr(2);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::string name = std::string("PhysicalSize") + "XYZ"[axis];
    const std::string unit(attribute(pixels, name + "Unit"));
    stack.side[axis] = in_metres(positive(attribute(pixels, name)), unit.empty() ? "um" : unit).value_or(0);
  }
  const auto in_seconds = [&](double value, std::string_view unit) {
    const auto seconds = seconds_of(unit);
    if (!seconds) stack.unknown_unit = unit;
    return seconds ? value * *seconds : 0;
  };
  stack.interval = in_seconds(positive(attribute(pixels, "TimeIncrement")), attribute(pixels, "TimeIncrementUnit"));
  constexpr auto none = std::numeric_limits<double>::quiet_NaN();
  if (stack.channels > 64 || stack.frames > 10'000'000) return stack;
  const std::int64_t all = stack.channels * stack.frames;
  std::vector<double> time;
  for (std::size_t at = text.find("<Plane "); at != std::string_view::npos; at = text.find("<Plane ", at + 1)) {
    const std::string_view plane = text.substr(at);
    const auto number = [&](const char* name) {
      return parse_number<std::int64_t>(attribute(plane, name)).value_or(0);
    };
    const auto delta = parse_number<double>(attribute(plane, "DeltaT"));
    const std::int64_t c = number("TheC"), t = number("TheT");
    if (!delta || number("TheZ") != 0 || c < 0 || t < 0 || c >= stack.channels || t >= stack.frames) continue;
    time.resize(static_cast<std::size_t>(all), none);
    time[static_cast<std::size_t>(c * stack.frames + t)] = in_seconds(*delta, attribute(plane, "DeltaTUnit"));
  }
  if (stack.unknown_unit.empty()) stack.time = std::move(time);
  return stack;
}

/// {"shape": [120, 6, 10], ..}: all images are frames.
TiffStack of_tifffile(std::string_view text, std::int64_t width, std::int64_t height) {
  std::string_view list = text.substr(text.find('['));
  list = list.substr(1, list.find(']') - 1);
  std::vector<std::int64_t> shape;
  while (!list.empty()) {
    const std::size_t comma = std::min(list.find(','), list.size());
    shape.push_back(count_of(list.substr(0, comma)));
    list.remove_prefix(std::min(comma + 1, list.size()));
  }
  TiffStack stack{.by = "tifffile"};
  if (shape.size() < 3 || shape.back() != width || shape[shape.size() - 2] != height) return {};
  for (std::size_t k = 0; k + 2 < shape.size(); ++k) stack.frames = std::min(stack.frames * shape[k], most);
  return stack;
}

}  // namespace

std::int64_t TiffStack::image(std::int64_t channel, std::int64_t frame) const {
  std::int64_t number = 0, step = 1;
  for (const char axis : order) {
    number += step * (axis == 'C' ? channel : axis == 'T' ? frame : 0);
    step *= axis == 'C' ? channels : axis == 'T' ? frames : slices;
  }
  return number;
}

TiffStack stack_in(std::string_view description, std::int64_t width, std::int64_t height) {
  if (description.starts_with("ImageJ=")) return of_imagej(description);
  if (description.find("<OME") != std::string_view::npos && description.find("<Pixels") != std::string_view::npos)
    return of_ome(description);
  if (description.starts_with("{\"shape\": [")) return of_tifffile(description, width, height);
  return {};
}

}  // namespace arenite::io
