#include <fmt/core.h>

#include <algorithm>
#include <map>

#include "core/problems.hpp"
#include "core/text.hpp"
#include "io/film/formats.hpp"
#include "io/table/table.hpp"

namespace arenite::io {
namespace {

struct Value {
  int line = 0;
  std::string text;
};

const std::vector<std::string> known{"file",         "width",         "height",     "frames",      "type", "byte_order", "offset",
                                     "frame_header", "frame_trailer", "frame_rate", "integration", "bits", "camera",     "quantity"};

/// Lines "key = value"; # begins a remark outside quotes.
std::map<std::string, Value> values_of(std::string_view text, Problems& problems) {
  std::map<std::string, Value> values;
  Lines lines(text);
  std::string_view line;
  while (lines.next(line)) {
    bool quoted = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
      if (line[i] == '"') quoted = !quoted;
      if (line[i] == '#' && !quoted) line = line.substr(0, i);
    }
    line = trimmed(line);
    if (line.empty()) continue;
    const std::size_t equals = line.find('=');
    const std::string key(trimmed(line.substr(0, equals)));
    if (equals == std::string_view::npos) {
      problems.add(lines.number(), "is no line \"key = value\"; correct it or begin it with #");
      continue;
    }
    if (std::find(known.begin(), known.end(), key) == known.end()) {
      const std::string meant = nearest(key, known);
      problems.add(lines.number(), fmt::format("\"{}\" is no key of a raw film{}; the keys are {}", key.substr(0, 40),
                                               meant.empty() ? "" : fmt::format(" (did you mean \"{}\"?)", meant), list_of(known)));
      continue;
    }
    std::string_view value = trimmed(line.substr(equals + 1));
    if (value.size() >= 2 && value.front() == '"' && value.back() == '"') value = value.substr(1, value.size() - 2);
    if (!values.emplace(key, Value{lines.number(), std::string(value)}).second)
      problems.add(lines.number(), "\"{}\" stands here a second time; leave one", key);
  }
  return values;
}

class Sidecar {
 public:
  Sidecar(std::string_view text, Problems& problems) : problems_(problems), values_(values_of(text, problems)) {}

  const Value* find(const char* key) const {
    const auto found = values_.find(key);
    return found != values_.end() ? &found->second : nullptr;
  }
  std::string text(const char* key) const { return find(key) != nullptr ? find(key)->text : std::string(); }
  std::int64_t count(const char* key, std::int64_t otherwise, bool required = false) {
    const Value* value = find(key);
    if (value == nullptr) {
      if (required) problems_.add("does not say the {}; add a line \"{} = ...\"", key, key);
      return otherwise;
    }
    const auto number = to_integer(value->text);
    if (number && *number >= 0 && *number <= (std::int64_t{1} << 40)) return *number;
    problems_.add(value->line, "{} is \"{}\", which is no whole number; write one", key, value->text.substr(0, 40));
    return otherwise;
  }
  /// A bare number is in the SI unit.
  double quantity(const char* key, Dimension dimension, const char* unit) {
    const Value* value = find(key);
    if (value == nullptr) return 0;
    if (const auto bare = to_number(value->text); bare && *bare > 0) return *bare;
    try {
      if (const double si = parse_si(value->text, dimension, unit); si > 0) return si;
      problems_.add(value->line, "{} is not above 0; correct it", key);
    } catch (const InputError& error) { problems_.add(value->line, "{}: {}", key, error.problems().front().message); }
    return 0;
  }
  NumberType pixel() {
    static const std::map<std::string, NumberType, std::less<>> types{{"uint8", NumberType::u8},   {"uint16", NumberType::u16}, {"int16", NumberType::i16},
                                                                      {"uint32", NumberType::u32}, {"int32", NumberType::i32},  {"float32", NumberType::f32},
                                                                      {"float64", NumberType::f64}};
    const auto found = types.find(text("type"));
    if (found != types.end()) return found->second;
    problems_.add(find("type") != nullptr ? find("type")->line : 0,
                  "does not say the type of a pixel; write type = \"uint8\", \"uint16\", \"int16\", \"uint32\", \"int32\", \"float32\" or \"float64\"");
    return NumberType::u8;
  }

 private:
  Problems& problems_;
  std::map<std::string, Value> values_;
};

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
  refuse(sidecar.name(), "describes raw frames, and there is no .raw, .bin or .dat of its name; add a line file = \"...\"");
}

bool is_sidecar(std::string_view head) {
  if (head.find('\0') != std::string_view::npos) return false;
  bool width = false, height = false;
  Lines lines(head);
  std::string_view line;
  while (lines.next(line)) {
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
  Sidecar sidecar(bytes->text(0, std::size_t{1} << 16), problems);
  FilmInfo info;
  const std::int64_t width = sidecar.count("width", 1, true), height = sidecar.count("height", 1, true);
  PlainLayout layout;
  layout.pixel = sidecar.pixel();
  const std::string order = sidecar.text("byte_order");
  if (!order.empty() && order != "little" && order != "big")
    problems.add(sidecar.find("byte_order")->line, "byte_order is neither \"little\" nor \"big\"; write one of these");
  layout.big_endian = order == "big";
  const std::int64_t offset = sidecar.count("offset", 0), frame_header = sidecar.count("frame_header", 0);
  const std::int64_t frame_trailer = sidecar.count("frame_trailer", 0), frames = sidecar.count("frames", -1);
  info.frame_rate = sidecar.quantity("frame_rate", dimension::frequency, "Hz");
  info.integration = sidecar.quantity("integration", dimension::time, "ms");
  info.bits = static_cast<int>(std::min<std::int64_t>(sidecar.count("bits", 0), 16));
  info.camera = sidecar.text("camera");
  const std::string quantity = sidecar.text("quantity");
  if (quantity == "K") info.quantity = FilmQuantity::kelvin;
  else if (quantity == "DL") info.quantity = FilmQuantity::digital_level;
  else if (!quantity.empty()) problems.add(sidecar.find("quantity")->line, "quantity is neither \"DL\" (digital levels) nor \"K\"; write one of these");
  problems.raise();
  check_film_size(bytes->name(), width, height, 1, choice);
  info.width = static_cast<int>(width);
  info.height = static_cast<int>(height);
  layout.offset = static_cast<std::uint64_t>(offset + frame_header);
  layout.stride = static_cast<std::uint64_t>(frame_header + frame_trailer) + info.pixels() * bytes_of(layout.pixel);
  const Bytes film = frames_of(*bytes, sidecar.text("file"));
  const std::int64_t there = frames_there(*film, layout, info.pixels());
  info.frames = frames >= 0 ? frames : there;
  // Without a count the file must end with a frame, or the sizes are not those of the film.
  const std::uint64_t used = layout.offset + static_cast<std::uint64_t>(there) * layout.stride;
  if (frames < 0 && used - static_cast<std::uint64_t>(frame_header) != film->size())
    refuse(film->name(), "has {} bytes, which is no whole number of frames of {} x {} pixels as {} says; correct its sizes or add frames = {}", film->size(),
           width, height, bytes->name(), there);
  return plain_film(film, std::move(info), layout, choice);
}

}  // namespace

/// Raw frames, described by a text of lines "key = value" beside them, without sections: a film's recipe is none.
const FilmFormat films::raw{.name = "raw",
                            .sentence = "raw frames with a sidecar",
                            .sidecar = "describe raw frames in a text beside it, NAME.txt with the lines width = .., height = .. and type = ..",
                            .is = is_sidecar,
                            .open = open_sidecar};

}  // namespace arenite::io
