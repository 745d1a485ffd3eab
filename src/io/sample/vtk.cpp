#include <zlib.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/text.hpp"
#include "io/disk/byte_source.hpp"
#include "io/sample/formats.hpp"
#include "io/sample/named_columns.hpp"

namespace arenite::io {
namespace {

/// One tag of an XML text: "/Points" at its end, attributes by name, and where what follows it begins.
struct XmlTag {
  std::string_view name;
  std::map<std::string_view, std::string_view> attributes;
  std::size_t end = 0;
  std::string_view value(std::string_view attribute) const {
    const auto at = attributes.find(attribute);
    return at == attributes.end() ? std::string_view{} : at->second;
  }
};
std::optional<XmlTag> next_tag(std::string_view text, std::size_t from) {
  const std::size_t begin = text.find('<', from), close = text.find('>', std::min(begin, text.size()));
  if (close == text.npos) return std::nullopt;
  std::string_view inside = text.substr(begin + 1, close - begin - 1);
  XmlTag tag;
  tag.end = close + 1;
  tag.name = inside.substr(0, std::min(inside.find_first_of(" \t\r\n"), inside.size()));
  while (true) {
    const std::size_t equals = inside.find("=\"");
    if (equals == inside.npos) return tag;
    std::string_view name = inside.substr(0, equals);
    if (const auto blank = name.find_last_of(" \t\r\n"); blank != name.npos) name.remove_prefix(blank + 1);
    inside.remove_prefix(equals + 2);
    const std::size_t quote = std::min(inside.find('"'), inside.size());
    tag.attributes.emplace(name, inside.substr(0, quote));
    inside.remove_prefix(std::min(quote + 1, inside.size()));
  }
}

/// Bytes of a base64 text up to its first other character; parts that end with "=" may follow one another.
std::string from_base64(std::string_view text) {
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  for (std::size_t k = 0; k + 4 <= text.size(); k += 4) {
    unsigned group = 0;
    int count = 0;
    for (std::size_t c = 0; c < 4; ++c) {
      const std::size_t digit = digits.find(text[k + c]);
      if (digit == digits.npos && text[k + c] != '=') return bytes;
      count += digit == digits.npos ? 0 : 1;
      group = group << 6 | static_cast<unsigned>(digit == digits.npos ? 0 : digit);
    }
    for (int byte = 0; byte < count - 1; ++byte) bytes += static_cast<char>(group >> (16 - 8 * byte) & 0xff);
  }
  return bytes;
}

/// How a file stores its arrays.
struct VtkStorage {
  bool compressed = false, wide = false;  ///< wide: lengths of 8 bytes
  std::size_t appended = std::string_view::npos;
  bool appended_raw = false;

  /// What a tag says of it; true where it is the last one that says anything.
  bool take(const XmlTag& tag, std::string_view text) {
    if (tag.name == "VTKFile") {
      compressed = !tag.value("compressor").empty();
      wide = tag.value("header_type") == "UInt64";
    }
    if (tag.name != "AppendedData") return false;
    appended = text.find('_', tag.end);
    appended_raw = tag.value("encoding") == "raw";
    if (appended != text.npos) ++appended;
    return true;
  }
};

template <class T> double nth_number(std::string_view bytes, std::size_t k) {
  return static_cast<double>(number_at<T>(bytes, k * sizeof(T)));
}
struct VtkType {
  std::string_view name;
  std::size_t size;
  double (*at)(std::string_view bytes, std::size_t k);
};
constexpr VtkType vtk_types[] = {{"Float64", 8, nth_number<double>},     {"Float32", 4, nth_number<float>},
                                 {"Int8", 1, nth_number<std::int8_t>},   {"UInt8", 1, nth_number<std::uint8_t>},
                                 {"Int16", 2, nth_number<std::int16_t>}, {"UInt16", 2, nth_number<std::uint16_t>},
                                 {"Int32", 4, nth_number<std::int32_t>}, {"UInt32", 4, nth_number<std::uint32_t>},
                                 {"Int64", 8, nth_number<std::int64_t>}, {"UInt64", 8, nth_number<std::uint64_t>}};

/// The bytes behind their lengths, unpacked; fewer than `size` where they are damaged.
std::string unpacked_bytes(std::string_view stored, const VtkStorage& how, std::size_t size) {
  const std::size_t width = how.wide ? 8 : 4;
  const auto length = [&](std::size_t k) -> std::size_t {
    if ((k + 1) * width > stored.size()) return 0;
    return static_cast<std::size_t>(how.wide ? nth_number<std::uint64_t>(stored, k)
                                             : nth_number<std::uint32_t>(stored, k));
  };
  if (!how.compressed) return std::string(stored.substr(std::min(width, stored.size()), std::min(length(0), size)));
  const std::size_t blocks = length(0), whole = length(1), last = length(2);
  std::size_t at = (3 + std::min(blocks, stored.size())) * width;
  std::string bytes;
  for (std::size_t b = 0; b < blocks && at <= stored.size() && bytes.size() < size; ++b) {
    uLongf room = static_cast<uLongf>(std::min(b + 1 == blocks && last > 0 ? last : whole, size - bytes.size()));
    std::string block(room, '\0');
    const std::size_t packed = std::min(length(3 + b), stored.size() - at);
    if (room == 0 || uncompress(reinterpret_cast<Bytef*>(block.data()), &room,
                                reinterpret_cast<const Bytef*>(stored.data() + at), static_cast<uLong>(packed)) != Z_OK)
      return bytes;
    bytes.append(block, 0, room);
    at += packed;
  }
  return bytes;
}

/// The numbers of an array, `count` of them.
std::vector<double> numbers_of_array(std::string_view text, const XmlTag& tag, const VtkStorage& how, std::size_t count,
                                     Problems& problems) {
  const std::string_view name = tag.value("Name"), format = tag.value("format");
  std::vector<double> values;
  if (format.empty() || format == "ascii") {
    Lines lines(text.substr(tag.end, text.find('<', tag.end) - tag.end));
    for (std::string_view line; lines.next(line);)
      for (const std::string_view cell : split_blanks(line))
        values.push_back(number_or_problem(cell, std::string(name), 1, 0, problems));
  } else {
    const auto* type = std::ranges::find(vtk_types, tag.value("type"), &VtkType::name);
    const bool appended = format == "appended";
    const auto offset = to_integer(tag.value("offset"));
    const std::size_t begin =
        appended && offset && *offset >= 0 ? how.appended + static_cast<std::size_t>(*offset) : tag.end;
    if (type == std::end(vtk_types) || (appended && (how.appended == text.npos || !offset)) || begin >= text.size()) {
      problems.add("the array \"{}\" cannot be found; write the file again", name);
      return values;
    }
    const std::size_t start = appended ? begin : std::min(text.find_first_not_of(" \t\r\n", begin), text.size());
    const std::string_view stored = text.substr(start);
    const std::string decoded = appended && how.appended_raw ? std::string() : from_base64(stored);
    const std::string bytes =
        unpacked_bytes(appended && how.appended_raw ? stored : std::string_view(decoded), how, count * type->size);
    for (std::size_t k = 0; (k + 1) * type->size <= bytes.size(); ++k) values.push_back(type->at(bytes, k));
  }
  if (values.size() == count) return values;
  problems.add("the array \"{}\" has {} numbers instead of {}; the file is cut off or damaged", name, values.size(),
               count);
  return std::vector<double>(count, 1.0);
}

/// The columns of `grains_in` that arrays of points are, by names that programs give them.
constexpr std::pair<std::string_view, std::string_view> array_names[] = {
    {"radius", "radius"},  {"radii", "radius"},      {"diameter", "diameter"},
    {"id", "id"},          {"material", "material"}, {"materialid", "material"},
    {"matid", "material"}, {"type", "material"},     {"speciestype", "material"}};

struct VtkArrays {
  std::size_t points = 0;
  std::map<std::string_view, std::vector<double>> of;  ///< "place" has three numbers a point
};

VtkArrays read_arrays(std::string_view text, Problems& problems) {
  VtkArrays arrays;
  VtkStorage how;
  std::vector<std::pair<std::string_view, XmlTag>> wanted;
  std::string_view section;
  int pieces = 0;
  for (auto tag = next_tag(text, 0); tag; tag = next_tag(text, tag->end)) {
    if (how.take(*tag, text)) break;
    if (tag->name == "VTKFile") {
      if (how.compressed && tag->value("compressor") != "vtkZLibDataCompressor")
        problems.add("its arrays are packed by {}; write them by vtkZLibDataCompressor or not packed",
                     tag->value("compressor"));
      if (tag->value("byte_order") == "BigEndian") problems.add("its numbers are big-endian; write them little-endian");
    } else if (tag->name == "Piece") {
      if (++pieces == 1)
        arrays.points =
            static_cast<std::size_t>(std::max<std::int64_t>(0, to_integer(tag->value("NumberOfPoints")).value_or(0)));
    } else if (tag->name == "PointData" || tag->name == "Points" || tag->name == "/PointData" ||
               tag->name == "/Points") {
      section = tag->name;
    } else if (tag->name == "DataArray" && pieces == 1) {
      const std::string name = lower_case(tag->value("Name"));
      if (section == "Points") wanted.emplace_back("place", *tag);
      else if (section == "PointData")
        for (const auto& [written, ours] : array_names)
          if (name == written) wanted.emplace_back(ours, *tag);
    }
  }
  if (pieces != 1) problems.add("the file has {} pieces; write points as one", pieces);
  if (arrays.points > 1100 * text.size()) problems.add("the file announces more points than it can hold");
  if (problems.any()) return arrays;
  for (const auto& [name, tag] : wanted)
    arrays.of.emplace(name, numbers_of_array(text, tag, how, arrays.points * (name == "place" ? 3 : 1), problems));
  return arrays;
}

constexpr std::string_view legacy = "# vtk DataFile";

/// Of the whole file, as ParaView (TimeValue) and VisIt (TIME, CYCLE) write it.
std::vector<Moment> vtk_moment(std::string_view text, const std::string&) {
  VtkStorage how;
  std::optional<XmlTag> time, step;
  bool before_points = true;
  for (auto tag = next_tag(text, 0); tag && !how.take(*tag, text); tag = next_tag(text, tag->end)) {
    before_points = before_points && tag->name != "Piece";
    const std::string name = lower_case(tag->value("Name"));
    if (!before_points || tag->name != "DataArray") continue;
    if (name == "timevalue" || name == "time") time = tag;
    if (name == "cycle") step = tag;
  }
  const auto number = [&](const std::optional<XmlTag>& tag) -> std::optional<double> {
    if (!tag) return std::nullopt;
    Problems damaged;
    const std::vector<double> values = numbers_of_array(text, *tag, how, 1, damaged);
    return damaged.any() ? std::nullopt : std::optional(values.front());
  };
  Moment moment{{}, number(time)};
  if (const auto cycle = number(step)) moment.step = static_cast<std::int64_t>(std::clamp(*cycle, -9e15, 9e15));
  return moment == Moment{} ? std::vector<Moment>{} : std::vector{moment};
}

RawGrains read_vtk_points(const Reading& reading) {
  RawGrains grains;
  Problems& problems = reading.problems;
  if (reading.text.starts_with(legacy))
    return problems.add("this is a legacy VTK file; write its points with their radii as VTK XML (.vtp, .vtu)"), grains;
  const VtkArrays arrays = read_arrays(reading.text, problems);
  const auto find = [&](std::string_view name) {
    const auto at = arrays.of.find(name);
    return at == arrays.of.end() ? nullptr : &at->second;
  };
  const auto *place = find("place"), *radius = find("radius"), *diameter = find("diameter"), *id = find("id"),
             *material = find("material");
  if (!place && !problems.any()) problems.add("the file has no points");
  if (!radius && !diameter && !problems.any())
    problems.add("the points have no array \"radius\" (or radii, diameter); write it with them");
  if (problems.any()) return grains;
  const double length = reading.options.length();
  for (std::size_t k = 0; k < arrays.points; ++k) {
    RawGrain& grain = grains.rows.emplace_back();
    grain.id = id ? static_cast<std::int64_t>(std::clamp((*id)[k], -9e15, 9e15)) : static_cast<std::int64_t>(k);
    grain.place = length * Vec3{(*place)[3 * k], (*place)[3 * k + 1], (*place)[3 * k + 2]};
    grain.radius = length * (radius ? (*radius)[k] : 0.5 * (*diameter)[k]);
    if (radius && diameter && !is_radius_of((*radius)[k], (*diameter)[k]))
      problems.add("point {}: radius and diameter contradict each other; leave one of the arrays out", k);
    if (material) grain.material = std::to_string(static_cast<std::int64_t>(std::clamp((*material)[k], -9e15, 9e15)));
  }
  if (!reading.options.length_unit) grains.notes.push_back(assumed_unit(reading.options, "length", "m", "length-unit"));
  return grains;
}

}  // namespace

/// Points of a VTK XML file (.vtp, .vtu) with radii, as ParaView, YADE's VTKRecorder and LIGGGHTS write them: as text,
/// base64 or raw behind, packed by zlib or not.
const SampleFormat samples::vtk{
    .name = "vtk",
    .grains_are = "VTK XML of points with radius (.vtp, .vtu)",
    .contacts_are = "a table, or where spheres overlap",
    .states = {{"units", "none are in the file: m, told, or that given by options"},
               {"time (TimeValue, TIME), step (CYCLE)",
                "compared with that of the contacts: refused where it is another, told where it cannot be"},
               {"cell", "none is in the file; --box and --periodic give it"},
               {"third coordinate", "read, as of tables"},
               {"columns (arrays of points)",
                "radius (radii) or diameter, id, material (materialId, type); others are "
                "passed over"},
               {"several pieces, big-endian numbers", "refused"},
               {"forces", "none are in the file"}},
    .is_grains =
        [](std::string_view line) {
          return line.starts_with("<?xml") || line.starts_with("<VTKFile") || line.starts_with(legacy);
        },
    .grains = read_vtk_points,
    .grain_moments = vtk_moment};

}  // namespace arenite::io
