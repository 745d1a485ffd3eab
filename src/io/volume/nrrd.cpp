#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "core/problems.hpp"
#include "core/text.hpp"
#include "io/stated_units.hpp"
#include "io/volume/header.hpp"
#include "io/volume/volume.hpp"

namespace arenite::io {
namespace {

std::optional<NumberType> nrrd_type(const std::string& word) {
  using enum NumberType;
  static const std::map<std::string, NumberType> known = {
      {"uchar", u8},         {"unsigned char", u8}, {"uint8", u8},           {"uint8_t", u8},       {"signed char", i8},
      {"int8", i8},          {"int8_t", i8},        {"short", i16},          {"signed short", i16}, {"int16", i16},
      {"int16_t", i16},      {"ushort", u16},       {"unsigned short", u16}, {"uint16", u16},       {"uint16_t", u16},
      {"int", i32},          {"signed int", i32},   {"int32", i32},          {"int32_t", i32},      {"uint", u32},
      {"unsigned int", u32}, {"uint32", u32},       {"uint32_t", u32},       {"longlong", i64},     {"int64", i64},
      {"int64_t", i64},      {"ulonglong", u64},    {"uint64", u64},         {"uint64_t", u64},     {"float", f32},
      {"double", f64}};
  const auto found = known.find(word);
  return found == known.end() ? std::nullopt : std::optional(found->second);
}

/// The step along every axis: "(0.5,0,0) (0,0.5,0) (0,0,0.5)"; empty unless there are three.
std::vector<Vec3> directions_of(std::string directions) {
  std::replace_if(
      directions.begin(), directions.end(), [](char c) { return c == ',' || c == ')'; }, ' ');
  std::vector<Vec3> steps;
  std::size_t at = 0;
  while ((at = directions.find('(', at)) != std::string::npos) {
    std::istringstream text(directions.substr(++at));
    Vec3& step = steps.emplace_back();
    double value = 0;
    for (int k = 0; k < 3 && text >> value; ++k) step[k] = value;
  }
  return steps.size() == 3 ? steps : std::vector<Vec3>{};
}

/// What stands in quotation marks: "mm" "mm" "um"; a word without them by itself.
std::vector<std::string> quoted_words(const std::string& text) {
  if (text.find('"') == std::string::npos) return {std::string(trimmed(text))};
  std::vector<std::string> words;
  for (std::size_t from = 0; (from = text.find('"', from)) != std::string::npos;) {
    const std::size_t to = std::min(text.find('"', from + 1), text.size());
    words.push_back(text.substr(from + 1, to - from - 1));
    from = to + 1;
  }
  return words;
}

/// "(5,0,0)"; nothing for other than three numbers.
std::optional<Vec3> place_of(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == ',' || c == '(' || c == ')'; }, ' ');
  std::istringstream numbers(text);
  Vec3 place;
  return numbers >> place.x >> place.y >> place.z ? std::optional(place) : std::nullopt;
}

/// The sides of a voxel by the unit of each axis, or by the one unit of all. Spacings have theirs in the field "units",
/// directions in "space units"; either may stand for the other.
void take_sides(VolumeFacts& facts, std::array<double, 3> side, const TextHeader& header, bool dx_given) {
  const bool own = header.has("spacings") && header.has("units");
  const std::string field = own || !header.has("space units") ? "units" : "space units";
  const std::vector<std::string> units =
      header.has(field) ? quoted_words(header.word(field)) : std::vector<std::string>{""};
  if (units.size() != 3 || (units[1] == units[0] && units[2] == units[0]))
    return take_side(facts, side_of(side, header.file), units.empty() ? "" : units[0], dx_given);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto metres = in_metres(side[axis], units[axis]);
    if (!metres)
      refuse(header.file, "states {} {} of which \"{}\" is no length; state all in mm", field, header.word(field),
             units[axis]);
    side[axis] = *metres;
  }
  facts.dx = side_of(side, header.file);
}

VolumePointer open_nrrd(const Bytes& bytes, const VolumeChoice& choice) {
  const std::string& file = bytes->name();
  const TextHeader header = header_until_blank(bytes, ':', {"data file", "datafile"});
  const auto number = [&](const std::string& key, long long otherwise) {
    return header.has(key) ? header.whole_numbers(key, 1)[0] : otherwise;
  };
  if (number("dimension", 0) != 3) refuse(file, "has {} dimensions; save a volume of three", header.word("dimension"));
  const auto type = nrrd_type(header.word("type"));
  if (!type) refuse(file, "has voxels of type \"{}\"; save whole numbers of up to 64 bits", header.word("type"));
  const auto size = header.whole_numbers("sizes", 3);
  VolumeFacts facts = sized({size[0], size[1], size[2]}, file);
  std::vector<double> spacing;
  const auto along =
      header.has("space directions") ? directions_of(header.word("space directions")) : std::vector<Vec3>{};
  if (header.has("spacings")) spacing = header.numbers("spacings", 3);
  else
    for (const Vec3& step : along) spacing.push_back(norm(step));
  if (along.size() == 3) tell_turned(facts, {along[0], along[1], along[2]}, "its space directions", file);
  if (header.has("space origin"))
    tell_origin(facts, place_of(header.word("space origin")).value_or(Vec3{}), "its space origin");
  if (spacing.size() == 3) take_sides(facts, {spacing[0], spacing[1], spacing[2]}, header, choice.dx_given);
  if (const std::string order = header.has("endian") ? header.word("endian") : "little";
      order != "little" && order != "big")
    refuse(file, "has bytes in the order \"{}\"; save it with endian little or big", order);
  VoxelLayout layout{.type = *type, .big_endian = header.has("endian") && header.word("endian") == "big"};
  const std::string encoding = header.word("encoding");
  const bool packed = encoding == "gzip" || encoding == "gz";
  if (!packed && encoding != "raw")
    refuse(file, "is stored as \"{}\"; save it with the encoding raw or gzip", encoding);
  if (header.has("line skip")) refuse(file, "skips lines of another file's header; save it as one file");
  const std::string beside = header.has("data file")  ? header.word("data file")
                             : header.has("datafile") ? header.word("datafile")
                                                      : std::string{};
  facts.elsewhere = !beside.empty();
  const Bytes data = beside.empty() ? bytes : opened_beside(bytes, beside);
  return header_and_numbers(data, beside.empty() ? header.size : 0, packed, number("byte skip", 0), facts, layout);
}

}  // namespace

constinit const VolumeFormat volumes::nrrd{
    .name = "nrrd",
    .sentence = "NRRD",
    .states =
        {{"sizes", "used: x fastest, z slowest"},
         {"spacings, space directions",
          "used with the unit of each axis (units, space units), refused where voxels are no cubes or their axes lean; "
          "without a unit left aside, and told; told where --dx is given and differs"},
         {"space directions that turn or mirror the axes", "left aside, and told"},
         {"space origin",
          "left aside, and told where it is not 0: places are counted from the corner of the first voxel"},
         {"data file", "read beside the header, which then needs no empty line at its end"},
         {"more numbers than sizes say", "left aside, and told"},
         {"encoding", "raw and gzip are read, others refused"}},
    .is = [](std::string_view head) { return head.starts_with("NRRD000"); },
    .open = open_nrrd};

}  // namespace arenite::io
