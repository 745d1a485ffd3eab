#include <fmt/core.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "core/mapped.hpp"
#include "core/problems.hpp"
#include "core/text.hpp"
#include "io/film/formats.hpp"
#include "io/table/table.hpp"

namespace arenite::io {
namespace {

constexpr std::pair<const char*, NumberType> types[] = {
    {"uint8", NumberType::u8},  {"uint16", NumberType::u16},  {"int16", NumberType::i16},  {"uint32", NumberType::u32},
    {"int32", NumberType::i32}, {"float32", NumberType::f32}, {"float64", NumberType::f64}};

struct Sidecar {
  std::string file, type, byte_order, camera, quantity;
  std::int64_t width = 1, height = 1, frames = -1, offset = 0, frame_header = 0, frame_trailer = 0, bits = 0;
  double frame_rate = 0, integration = 0;
};

/// A key and what it sets: a text, which may have to be one of some words, a whole number, or a quantity, of which a
/// bare number is in the SI unit.
struct Key {
  std::string name;
  std::variant<std::string Sidecar::*, std::int64_t Sidecar::*, double Sidecar::*> to;
  const char* required = nullptr;  ///< what a sidecar does not say without it
  std::vector<std::string> words = {};
  Dimension dimension = {};
  const char* unit = "";
};
const Key keys[] = {{"file", &Sidecar::file},
                    {"width", &Sidecar::width, "width"},
                    {"height", &Sidecar::height, "height"},
                    {"frames", &Sidecar::frames},
                    {"type", &Sidecar::type, "type of a pixel",
                     mapped<std::string>(types, [](const auto& type) { return type.first; })},
                    {"byte_order", &Sidecar::byte_order, nullptr, {"little", "big"}},
                    {"offset", &Sidecar::offset},
                    {"frame_header", &Sidecar::frame_header},
                    {"frame_trailer", &Sidecar::frame_trailer},
                    {.name = "frame_rate", .to = &Sidecar::frame_rate, .dimension = dimension::frequency, .unit = "Hz"},
                    {.name = "integration", .to = &Sidecar::integration, .dimension = dimension::time, .unit = "ms"},
                    {"bits", &Sidecar::bits},
                    {"camera", &Sidecar::camera},
                    {"quantity", &Sidecar::quantity, nullptr, {"DL", "K"}}};

void take(const Key& key, std::string_view text, int line, Sidecar& sidecar, Problems& problems) {
  const auto number = to_integer(text);
  if (const auto* word = std::get_if<std::string Sidecar::*>(&key.to)) {
    sidecar.** word = text;
    if (!key.words.empty() && std::ranges::count(key.words, text) == 0)
      problems.add(line, "{} is \"{}\" and none of {}; write one of these", key.name, text.substr(0, 40),
                   list_of(key.words));
  } else if (const auto* count = std::get_if<std::int64_t Sidecar::*>(&key.to)) {
    if (number && *number >= 0 && *number <= (std::int64_t{1} << 40)) sidecar.** count = *number;
    else problems.add(line, "{} is \"{}\", which is not a whole number; write one", key.name, text.substr(0, 40));
  } else try {
      const auto bare = to_number(text);
      double& value = sidecar.*std::get<double Sidecar::*>(key.to) =
                          bare ? *bare : parse_si(std::string(text), key.dimension, key.unit);
      if (!(value > 0)) problems.add(line, "{} is not above 0; correct it", key.name);
    } catch (const InputError& error) { problems.add(line, "{}: {}", key.name, error.problems().front().message); }
}

/// Without a remark, which # begins outside quotes, and the blanks around it.
std::string_view bare(std::string_view line) {
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '"') quoted = !quoted;
    if (line[i] == '#' && !quoted) return trimmed(line.substr(0, i));
  }
  return trimmed(line);
}

/// Lines "key = value". A sidecar is the header of a film, as a camera's own headers are, and not a recipe: recording
/// programs and scripts write it, bare words and all, it is found by the frames beside it, and a film must open where
/// no recipe is read. The reader of recipes, which stands above this room, asks for TOML and for units; this one takes
/// what those programs write, as each reader of another header does.
Sidecar read_sidecar(std::string_view text, Problems& problems) {
  Sidecar sidecar;
  std::set<std::string, std::less<>> said;
  Lines lines(text);
  for (std::string_view line; lines.next(line);) {
    line = bare(line);
    if (line.empty()) continue;
    const std::size_t equals = line.find('=');
    if (equals == std::string_view::npos) {
      problems.add(lines.number(), "is not a line \"key = value\"; correct it or begin it with #");
      continue;
    }
    const std::string name(trimmed(line.substr(0, equals)));
    const auto* key = std::ranges::find(keys, name, &Key::name);
    if (key == std::end(keys)) {
      const std::string meant = nearest(name, mapped(keys, &Key::name));
      problems.add(lines.number(), "\"{}\" is not a key of a raw film{}; the keys are {}", name.substr(0, 40),
                   meant.empty() ? "" : fmt::format(" (did you mean \"{}\"?)", meant),
                   list_of(mapped(keys, &Key::name)));
      continue;
    }
    std::string_view value = trimmed(line.substr(equals + 1));
    if (value.size() >= 2 && value.front() == '"' && value.back() == '"') value = value.substr(1, value.size() - 2);
    if (said.insert(name).second) take(*key, value, lines.number(), sidecar, problems);
    else problems.add(lines.number(), "\"{}\" appears a second time; keep one", name);
  }
  for (const Key& key : keys)
    if (key.required != nullptr && !said.contains(key.name))
      problems.add("does not state the {}; add a line \"{} = ...\"", key.required, key.name);
  return sidecar;
}

/// The file that a sidecar is for: the one it names, or the one of its name with another ending.
Bytes frames_of(const ByteSource& sidecar, const std::string& named) {
  if (sidecar.path() == nullptr) return bytes_in_memory(sidecar.text(0, sidecar.size()), sidecar.name());
  const auto& path = *sidecar.path();
  if (!named.empty()) return open_bytes(path.parent_path() / named);
  std::error_code error;
  for (const char* ending : {"", ".raw", ".bin", ".dat"}) {
    auto beside = path;
    beside.replace_extension(ending);
    if (beside != path && std::filesystem::is_regular_file(beside, error)) return open_bytes(beside);
  }
  refuse(sidecar.name(),
         "describes raw frames, and there is no .raw, .bin or .dat of its name; add a line file = \"...\"");
}

bool is_sidecar(std::string_view head) {
  if (head.find('\0') != std::string_view::npos) return false;
  bool width = false, height = false;
  Lines lines(head);
  for (std::string_view line; lines.next(line);) {
    if (trimmed(line).starts_with('[')) return false;  // a recipe, whose frame has a width and a height, too
    const std::string_view key = trimmed(line.substr(0, line.find('=')));
    if (line.find('=') == std::string_view::npos) continue;
    width = width || key == "width";
    height = height || key == "height";
  }
  return width && height;
}

FilmPointer open_sidecar(const Bytes& bytes, const FilmChoice& choice) {
  Problems problems(bytes->name());
  const Sidecar said = read_sidecar(bytes->text(0, std::size_t{1} << 16), problems);
  problems.raise();
  FilmInfo info;
  info.frame_rate = said.frame_rate;
  info.integration = said.integration;
  info.bits = static_cast<int>(std::min<std::int64_t>(said.bits, 16));
  info.camera = said.camera;
  if (!said.quantity.empty()) info.quantity = said.quantity == "K" ? FilmQuantity::kelvin : FilmQuantity::digital_level;
  check_film_size(bytes->name(), said.width, said.height, 1, choice);
  info.width = static_cast<int>(said.width);
  info.height = static_cast<int>(said.height);
  PlainLayout layout;
  layout.pixel = std::ranges::find(types, said.type, &std::pair<const char*, NumberType>::first)->second;
  layout.big_endian = said.byte_order == "big";
  layout.offset = static_cast<std::uint64_t>(said.offset + said.frame_header);
  layout.stride =
      static_cast<std::uint64_t>(said.frame_header + said.frame_trailer) + info.pixels() * bytes_of(layout.pixel);
  const Bytes film = frames_of(*bytes, said.file);
  const std::int64_t there = frames_there(*film, layout, info.pixels());
  info.frames = said.frames >= 0 ? said.frames : there;
  // Without a count the file must end with a frame, or the sizes are not those of the film.
  const std::uint64_t used = layout.offset + static_cast<std::uint64_t>(there) * layout.stride;
  if (said.frames < 0 && used - static_cast<std::uint64_t>(said.frame_header) != film->size())
    refuse(film->name(),
           "has {} bytes, which is not a whole number of frames of {} x {} pixels as in {}; correct its sizes or add "
           "frames = {}",
           film->size(), said.width, said.height, bytes->name(), there);
  return plain_film(film, std::move(info), layout, choice);
}

}  // namespace

/// Raw frames, described by a text of lines "key = value" beside them, without sections: a film's recipe is none.
const FilmFormat films::raw{
    .name = "raw",
    .sentence = "raw frames with a sidecar",
    .states = {{"all keys of the sidecar", "used; unknown ones are refused"},
               {"frames of NaN, of one number, or the frame before once more", "left out as lost, and named"}},

    .sidecar = "describe raw frames in a text beside it, NAME.txt with the lines width = .., height = .. and type = ..",
    .is = is_sidecar,
    .open = open_sidecar};

}  // namespace arenite::io
