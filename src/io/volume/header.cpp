#include "io/volume/header.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <functional>
#include <optional>
#include <sstream>
#include <string_view>

#include "core/option.hpp"
#include "core/problems.hpp"
#include "core/text.hpp"
#include "io/stated_units.hpp"

namespace arenite::io {
namespace {

constexpr std::size_t longest_header = std::size_t{1} << 16;

std::string trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r=");
  if (first == std::string_view::npos) return {};
  return std::string(text.substr(first, text.find_last_not_of(" \t\r") - first + 1));
}

TextHeader read_header(const Bytes& bytes, char separator,
                       const std::function<bool(std::string_view line, const std::string& key)>& is_last,
                       std::initializer_list<std::string> elsewhere = {}) {
  const std::string head = bytes->text(0, longest_header);
  TextHeader header{bytes->name(), {}, 0};
  while (header.size < head.size()) {
    const std::size_t end = std::min(head.find('\n', header.size), head.size());
    const std::string_view line = std::string_view(head).substr(header.size, end - header.size);
    header.size = std::min(end + 1, head.size());
    const std::size_t at = line.find(separator);
    std::string key;
    if (at != std::string_view::npos && !line.starts_with('#')) {
      key = trimmed(line.substr(0, at));
      std::ranges::transform(key, key.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
      header.values[key] = trimmed(line.substr(at + 1));
    }
    if (is_last(line, key)) return header;
  }
  const bool is_whole = header.size == bytes->size();
  for (const std::string& key : elsewhere)
    if (is_whole && header.has(key)) return header;
  refuse(bytes->name(), "has a header that does not end; copy it again");
}

}  // namespace

const std::string& TextHeader::word(const std::string& key) const {
  const auto found = values.find(key);
  if (found == values.end()) refuse(file, "does not state \"{}\" in its header; save it again", key);
  return found->second;
}

std::vector<double> TextHeader::numbers(const std::string& key, std::size_t count) const {
  std::istringstream text(word(key));
  std::vector<double> list;
  for (double value = 0; text >> value;) list.push_back(value);
  if (list.size() != count) refuse(file, "states {} = \"{}\"; {} numbers are wanted", key, word(key), count);
  return list;
}

std::vector<std::int64_t> TextHeader::whole_numbers(const std::string& key, std::size_t count) const {
  std::istringstream text(word(key));
  std::vector<std::int64_t> list;
  for (std::int64_t value = 0; text >> value;) list.push_back(value);
  if (list.size() != count) refuse(file, "states {} = \"{}\"; {} whole numbers are wanted", key, word(key), count);
  return list;
}

TextHeader header_until_blank(const Bytes& bytes, char separator, std::initializer_list<std::string> elsewhere) {
  return read_header(
      bytes, separator, [](std::string_view line, const std::string&) { return line.empty() || line == "\r"; },
      elsewhere);
}

TextHeader header_until_key(const Bytes& bytes, char separator, const std::string& key) {
  return read_header(bytes, separator, [&](std::string_view, const std::string& found) { return found == key; });
}

Bytes opened_beside(const Bytes& bytes, const std::string& name) {
  const std::filesystem::path* path = bytes->path();
  if (!path) refuse(bytes->name(), "names the file \"{}\" beside it, and there is none in memory", name);
  const std::filesystem::path data = path->parent_path() / name;
  if (std::error_code error; !std::filesystem::exists(data, error))
    refuse(bytes->name(), "names the file \"{}\" for its voxels, which is not there; put it beside the header", name);
  return open_bytes(data);
}

void take_side(VolumeFacts& facts, double side, const std::string& unit, bool dx_given) {
  facts.dx = in_metres(side, unit);
  if (!facts.dx && !dx_given)
    facts.remarks.push_back(fmt::format("a spacing of {:g} {}, which is no known length, is left aside; give {}", side,
                                        unit.empty() ? "without a unit" : unit, option("dx")));
}

void tell_turned(VolumeFacts& facts, const std::array<Vec3, 3>& along, const char* stated, const std::string& file) {
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 &one = along[k], &next = along[(k + 1) % 3];
    if (!(std::abs(dot(one, next)) <= 1e-3 * norm(one) * norm(next)))
      refuse(file, "has axes that lean, by {}: its voxels are no cubes; resample it to cubes", stated);
  }
  bool turned = false;
  for (int k = 0; k < 3; ++k) {
    const Vec3& step = along[static_cast<std::size_t>(k)];
    turned = turned || !(step[k] > (1 - 1e-6) * norm(step));
  }
  if (turned)
    facts.remarks.push_back(
        fmt::format("{} turn or mirror the axes, which is left aside: x, y and z are those of the numbers in the "
                    "file, x fastest",
                    stated));
}

void tell_origin(VolumeFacts& facts, const Vec3& origin, const char* stated) {
  if (norm(origin) > 0)
    facts.remarks.push_back(
        fmt::format("{} ({:g}, {:g}, {:g}) is left aside: places are counted from the corner of the first voxel",
                    stated, origin.x, origin.y, origin.z));
}

VolumePointer header_and_numbers(const Bytes& data, std::size_t start, bool packed, std::int64_t skip,
                                 const VolumeFacts& facts, VoxelLayout layout) {
  const std::size_t wanted = bytes_of(layout.type) * facts.slice() * static_cast<std::size_t>(facts.depth);
  if (packed) {
    const auto behind = static_cast<std::size_t>(std::max<std::int64_t>(skip, 0));
    const std::string plain =  // and one more, which shows that there are others
        unpacked(data->text(start, static_cast<std::size_t>(data->size()) - start), wanted + behind + 1, data->name());
    layout.start = behind;
    return voxels_in(bytes_in_memory(plain, data->name()), facts, layout);
  }
  layout.start =
      skip < 0 ? std::max<std::uint64_t>(data->size(), wanted) - wanted : start + static_cast<std::uint64_t>(skip);
  return voxels_in(data, facts, layout);
}

}  // namespace arenite::io
