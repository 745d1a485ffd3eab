#include "io/phase_map_image.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <unordered_map>

#include "core/error.hpp"

namespace arenite::io {
namespace {

Image cropped(Image image, const std::optional<Crop>& crop, const std::string& file) {
  if (!crop) return image;
  const auto [x, y, width, height] = *crop;
  if (x < 0 || y < 0 || width <= 0 || height <= 0 || width > image.width - x || height > image.height - y)
    throw InputError(file, 0, fmt::format("has {} x {} pixels, and the crop {},{},{},{} does not lie inside; give X,Y of its upper left "
                                          "pixel, width, height", image.width, image.height, x, y, width, height));
  Image part{width, height, {}};
  part.value.reserve(part.size());
  for (int row = y; row < y + height; ++row) {
    const auto first = image.value.begin() + static_cast<std::ptrdiff_t>(image.index(x, row));
    part.value.insert(part.value.end(), first, first + width);
  }
  return part;
}

/// The only place where rows are turned round: row 0 of a picture is at the top, row 0 of a map at the bottom.
template <class T>
std::vector<T> bottom_first(const std::vector<T>& top_first, int width, int height) {
  std::vector<T> turned;
  turned.reserve(top_first.size());
  for (int row = height - 1; row >= 0; --row) {
    const auto first = top_first.begin() + static_cast<std::ptrdiff_t>(row) * width;
    turned.insert(turned.end(), first, first + width);
  }
  return turned;
}

/// Place of a map's node in the picture before it was cropped, for messages.
std::string pixel(const PhaseMap& map, std::size_t node, const std::optional<Crop>& crop) {
  const auto width = static_cast<std::size_t>(map.width);
  const int x = static_cast<int>(node % width), y = map.height - 1 - static_cast<int>(node / width);
  return fmt::format("{}, {}", x + (crop ? crop->x : 0), y + (crop ? crop->y : 0));
}

/// Labels of anybody's numbering become 0, 1, 2 in the order of their first node.
void number_grains(PhaseMap& map, const std::vector<std::int32_t>& label, const PhaseMapOptions& options, const std::string& file) {
  std::unordered_map<std::int32_t, std::int32_t> number;
  std::size_t bare = 0, outside = 0, first_bare = 0, first_outside = 0;
  std::int32_t last = 0, grain = -1;
  for (std::size_t i = 0; i < map.size(); ++i) {
    const bool particle = map.phase[i] == Phase::particle;
    if (particle && label[i] == 0 && bare++ == 0) first_bare = i;
    if (!particle && label[i] != 0 && outside++ == 0) first_outside = i;
    if (!particle || label[i] == 0) continue;
    if (grain < 0 || label[i] != last) {
      last = label[i];
      grain = number.emplace(last, static_cast<std::int32_t>(number.size())).first->second;
    }
    map.grain[i] = grain;
  }
  std::vector<Problem> problems;
  if (bare > 0)
    problems.push_back({file, 0, 0, fmt::format("has no label for {} particle pixels, the first at {}; label them, or leave the labels "
                                                "out and let grains be found", bare, pixel(map, first_bare, options.crop))});
  if (outside > 0)
    problems.push_back({file, 0, 0, fmt::format("labels {} pixels that are no particle, the first at {}; write 0 there, or say with "
                                                "--phases that they are particle", outside, pixel(map, first_outside, options.crop))});
  if (!problems.empty()) throw InputError(std::move(problems));
  map.grain_class.assign(number.size(), GrainClass::none);
}

bool several_values(const Image& labels) {
  return std::any_of(labels.value.begin(), labels.value.end(), [&](std::int32_t v) { return v != labels.value.front(); });
}

}  // namespace

Crop parse_crop(std::string_view text) {
  int numbers[4] = {};
  const char *at = text.data(), *end = text.data() + text.size();
  for (int i = 0; i < 4; ++i) {
    const auto read = std::from_chars(at, end, numbers[i]);
    const bool last = i == 3;
    if (read.ec != std::errc{} || (last ? read.ptr != end : read.ptr == end || *read.ptr != ','))
      throw InputError(fmt::format("\"{}\" is no rectangle; write X,Y,WIDTH,HEIGHT in pixels, for example 0,0,512,512", text));
    at = read.ptr + (last ? 0 : 1);
  }
  return {numbers[0], numbers[1], numbers[2], numbers[3]};
}

ForeignMap make_phase_map(const Image& picture, const Image* labels, const PhaseMapOptions& options, const std::string& file,
                          const std::string& label_file) {
  if (!(options.dx > 0) || !std::isfinite(options.dx))
    throw InputError(fmt::format("the side of a pixel is {:g} m; give a positive length", options.dx));
  if (labels != nullptr && (labels->width != picture.width || labels->height != picture.height))
    throw InputError(label_file, 0, fmt::format("has {} x {} pixels and the phase map {} x {}; give labels of the same picture", labels->width,
                                                labels->height, picture.width, picture.height));
  const Image part = cropped(picture, options.crop, file);
  Image marks;
  if (labels != nullptr) marks = cropped(*labels, options.crop, label_file);
  ForeignMap result;
  PhaseMap& map = result.map;
  map = arenite::make_phase_map(part.width, part.height, options.dx);
  map.phase = bottom_first(assign_phases(part, options.phases, labels != nullptr && several_values(marks), file, result.notes),
                           part.width, part.height);
  if (labels == nullptr) return result;
  if (std::find(map.phase.begin(), map.phase.end(), Phase::particle) == map.phase.end())
    throw InputError(label_file, 0, "gives labels to a map without particles; leave them out, or say with --phases which value is particle");
  number_grains(map, bottom_first(marks.value, marks.width, marks.height), options, label_file);
  result.labelled = true;
  return result;
}

ForeignMap read_phase_map(const std::filesystem::path& path, const PhaseMapOptions& options) {
  const Image picture = read_image(path, options.image);
  if (!options.labels && options.label_image.dataset.empty())
    return make_phase_map(picture, nullptr, options, path.string(), {});
  const auto label_path = options.labels.value_or(path);
  ImageChoice choice = options.label_image;
  if (!choice.slice) choice.slice = options.image.slice;
  const Image labels = read_image(label_path, choice);
  return make_phase_map(picture, &labels, options, path.string(), label_path.string());
}

}  // namespace arenite::io
