#include "io/image/phase_map.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <unordered_map>

#include "core/mapped.hpp"
#include "core/option.hpp"
#include "core/problems.hpp"
#include "core/text.hpp"
#include "io/table/table.hpp"

namespace arenite::io {
namespace {

Image cropped(Image image, const std::optional<Crop>& crop, const std::string& file) {
  if (!crop) return image;
  const auto [x, y, width, height] = *crop;
  if (x < 0 || y < 0 || width <= 0 || height <= 0 || width > image.width - x || height > image.height - y)
    refuse(file,
           "has {} x {} pixels, and the crop {},{},{},{} does not lie inside; give X,Y of its upper left pixel, width, "
           "height",
           image.width, image.height, x, y, width, height);
  Image part{width, height, {}};
  part.value.reserve(part.size());
  for (int row = y; row < y + height; ++row) {
    const auto first = image.value.begin() + static_cast<std::ptrdiff_t>(image.index(x, row));
    part.value.insert(part.value.end(), first, first + width);
  }
  return part;
}

/// The only place where rows are turned round: row 0 of a picture is at the top, row 0 of a map at the bottom.
template <class T> std::vector<T> bottom_first(std::vector<T> rows, std::ptrdiff_t width, std::ptrdiff_t height) {
  for (std::ptrdiff_t low = 0, high = height - 1; low < high; ++low, --high)
    std::swap_ranges(rows.begin() + low * width, rows.begin() + (low + 1) * width, rows.begin() + high * width);
  return rows;
}

/// Place of a map's node in the picture before it was cropped, for messages.
std::string pixel(const PhaseMap& map, std::size_t node, const std::optional<Crop>& crop) {
  const auto width = static_cast<std::size_t>(map.width);
  const int x = static_cast<int>(node % width), y = map.height - 1 - static_cast<int>(node / width);
  return fmt::format("{}, {}", x + (crop ? crop->x : 0), y + (crop ? crop->y : 0));
}

/// Labels of anybody's numbering become 0, 1, 2 in the order of their first node.
void number_grains(PhaseMap& map, const std::vector<std::int32_t>& label, const PhaseMapOptions& options,
                   const std::string& file) {
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
  Problems problems(file);
  problems.unless(bare == 0,
                  "has no label for {} particle pixels, the first at {}; label them, or leave the labels out so that "
                  "grains are found",
                  bare, pixel(map, first_bare, options.crop));
  problems.unless(
      outside == 0,
      "labels {} pixels that are not particle, the first at {}; write 0 there, or state with {} that they are particle",
      outside, pixel(map, first_outside, options.crop), option("phases"));
  problems.raise();
  map.grain_class.assign(number.size(), GrainClass::none);
}

bool several_values(const Image& labels) {
  return std::any_of(labels.value.begin(), labels.value.end(),
                     [&](std::int32_t v) { return v != labels.value.front(); });
}

constexpr std::string_view names[] = {"void", "matrix", "particle"};
constexpr std::string_view form = "write for example \"0=void,128=matrix,255=particle\"";

using Counts = std::map<std::int32_t, std::size_t>;

Counts count_values(const Image& image) {
  Counts counts;
  for (std::size_t i = 0; i < image.value.size();) {
    std::size_t end = i + 1;
    while (end < image.value.size() && image.value[end] == image.value[i]) ++end;
    counts[image.value[i]] += end - i;
    i = end;
  }
  return counts;
}

/// "0 (44.9 %), 85 (40.1 %)", at most eight values.
std::string listed(const Counts& counts, std::size_t total) {
  constexpr int most = 8;
  std::string text;
  int shown = 0;
  for (const auto& [value, count] : counts) {
    if (shown++ == most) return text + fmt::format(" and {} more", counts.size() - most);
    text += fmt::format("{}{} ({:.3g} %)", text.empty() ? "" : ", ", value,
                        100 * static_cast<double>(count) / static_cast<double>(total));
  }
  return text;
}

/// A table that could be meant: the lowest value void, the highest particle, those between matrix.
std::string proposal(const Counts& counts) {
  std::string text;
  for (auto it = counts.begin(); it != counts.end(); ++it)
    text += fmt::format("{}{}={}", text.empty() ? "" : ",", it->first,
                        it == counts.begin()            ? "void"
                        : std::next(it) == counts.end() ? "particle"
                                                        : "matrix");
  return text;
}

/// The same of two values whose lower one is no void.
std::string proposal_of_matrix(const Counts& counts) {
  return fmt::format("{}=matrix,{}=particle", counts.begin()->first, counts.rbegin()->first);
}

PhaseTable guess(const Counts& counts, std::size_t total, const std::string& file, std::vector<std::string>& notes) {
  if (counts.size() == 1)
    refuse(
        file,
        "has the value {} everywhere: nothing distinguishes particles from void; give a picture of at least two values",
        counts.begin()->first);
  constexpr std::size_t too_many = 8;
  if (counts.size() > too_many)
    refuse(file,
           "has {} values, {}; it is not a phase map: a photograph must be segmented first, and grain labels are given "
           "with {} beside a phase map",
           counts.size(), listed(counts, total), option("labels"));
  if (counts.size() > 2)
    refuse(file, "has the values {}; state the phase of each, for example with {} {}", listed(counts, total),
           option("phases"), proposal(counts));
  notes.push_back(fmt::format(
      "Values {}: the lower was taken as void, the higher as particle. Where particles lie in a matrix, give {} {}.",
      listed(counts, total), option("phases"), proposal_of_matrix(counts)));
  return {{counts.begin()->first, Phase::empty}, {counts.rbegin()->first, Phase::particle}};
}

void refuse_unknown(const Counts& counts, const PhaseTable& table, std::size_t total, const std::string& file) {
  Counts unknown;
  for (const auto& [value, count] : counts)
    if (!table.contains(value)) unknown[value] = count;
  if (!unknown.empty())
    refuse(file, "has values whose phase is not given: {}; add them to {}, or save the picture without smoothing",
           listed(unknown, total), option("phases"));
}

void refuse_one_phase(const Counts& counts, const PhaseTable& table, bool several_grains, const std::string& file) {
  const Phase first = table.at(counts.begin()->first);
  if (std::any_of(counts.begin(), counts.end(), [&](const auto& c) { return table.at(c.first) != first; })) return;
  if (first == Phase::particle && several_grains) return;
  refuse(file, "is {} everywhere; give a map of at least two phases", name_of(first));
}

}  // namespace

Crop parse_crop(std::string_view text) {
  const auto numbers = mapped(split_cells(text, ','), parse_number<int>);
  if (numbers.size() != 4 || std::ranges::any_of(numbers, [](const auto& number) { return !number; }))
    throw refusal("\"{}\" is not a rectangle; write X,Y,WIDTH,HEIGHT in pixels, for example 0,0,512,512", text);
  return {*numbers[0], *numbers[1], *numbers[2], *numbers[3]};
}

ForeignMap make_phase_map(const Image& picture, const Image* labels, const PhaseMapOptions& options,
                          const std::string& file, const std::string& label_file) {
  if (!(options.dx > 0) || !std::isfinite(options.dx))
    throw refusal("the side of a pixel is {:g} m; give a positive length", options.dx);
  if (labels != nullptr && (labels->width != picture.width || labels->height != picture.height))
    refuse(label_file, "has {} x {} pixels and the phase map {} x {}; give labels of the same picture", labels->width,
           labels->height, picture.width, picture.height);
  const Image part = cropped(picture, options.crop, file);
  Image marks;
  if (labels != nullptr) marks = cropped(*labels, options.crop, label_file);
  ForeignMap result;
  PhaseMap& map = result.map;
  map = arenite::make_phase_map(part.width, part.height, options.dx);
  map.phase =
      bottom_first(assign_phases(part, options.phases, labels != nullptr && several_values(marks), file, result.notes),
                   part.width, part.height);
  if (labels == nullptr) return result;
  if (std::find(map.phase.begin(), map.phase.end(), Phase::particle) == map.phase.end())
    refuse(label_file,
           "gives labels to a map without particles; leave them out, or state with {} which value is particle",
           option("phases"));
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

void label_alike(PhaseMap& map) {
  map.grain_class = {GrainClass::none};
  for (std::size_t i = 0; i < map.size(); ++i) map.grain[i] = map.phase[i] == Phase::particle ? 0 : -1;
}

std::string_view name_of(Phase phase) { return names[static_cast<std::size_t>(phase)]; }

PhaseTable parse_phase_table(std::string_view text) {
  PhaseTable table;
  if (text.ends_with(',')) text.remove_suffix(1);
  for (const std::string_view row : split_cells(text, ',')) {
    const std::size_t at = row.find('=');
    const auto value = parse_number<std::int32_t>(row.substr(0, at));
    if (at == std::string_view::npos || !value)
      throw refusal("\"{}\" does not assign a phase to a value; {}", row, form);
    const std::string name(row.substr(at + 1));
    const auto* found = std::find(std::begin(names), std::end(names), name);
    if (found == std::end(names)) {
      const std::string near = nearest(name, {std::begin(names), std::end(names)});
      throw refusal("\"{}\" is not a phase{}; phases are void, matrix and particle", name,
                    near.empty() ? "" : "; did you mean \"" + near + "\"?");
    }
    if (!table.emplace(*value, static_cast<Phase>(found - std::begin(names))).second)
      throw refusal("the value {} is assigned a phase twice; leave one of them out", *value);
  }
  return table;
}

std::vector<Phase> assign_phases(const Image& image, const PhaseTable& given, bool several_grains,
                                 const std::string& file, std::vector<std::string>& notes) {
  const Counts counts = count_values(image);
  if (counts.empty()) refuse(file, "holds no pixels; give a picture with at least one");
  const PhaseTable table = given.empty() ? guess(counts, image.size(), file, notes) : given;
  refuse_unknown(counts, table, image.size(), file);
  refuse_one_phase(counts, table, several_grains, file);
  std::vector<Phase> phases(image.value.size());
  std::int32_t last = counts.begin()->first;
  Phase phase = table.at(last);
  for (std::size_t i = 0; i < phases.size(); ++i) {
    if (image.value[i] != last) phase = table.at(last = image.value[i]);
    phases[i] = phase;
  }
  return phases;
}

}  // namespace arenite::io
