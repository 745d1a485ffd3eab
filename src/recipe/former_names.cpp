#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "recipe/document.hpp"

namespace arenite::recipe {
namespace {

/// A key in a section, or a word that a key takes, that had another name; `*` is an item of a list.
struct Renamed {
  std::string_view where, former, now;
};

/// Sections come before what they hold, which stands under their name of now.
constexpr std::array former_keys{
    Renamed{"", "frame", "container"},
    Renamed{"", "raster", "grid"},
    Renamed{"", "twin", "simulation"},
    Renamed{"bidisperse", "cut", "truncation"},
    Renamed{"bidisperse", "cut_each_class", "truncate_each_class"},
    Renamed{"stages.*", "frames", "snapshots"},
    Renamed{"stages.*", "masses", "mass_scaling"},
    Renamed{"stages.*", "rest", "equilibrium"},
    Renamed{"container", "load_swing", "load_peak_to_peak"},
    Renamed{"camera", "frame_emissivity", "container_emissivity"},
    Renamed{"camera", "plate_frames", "reference_frames"},
    Renamed{"camera", "plate_cold", "reference_cold"},
    Renamed{"camera", "plate_warm", "reference_warm"},
};

constexpr std::array former_words{
    Renamed{"stages.*.mass_scaling", "own", "none"},
    Renamed{"stages.*.mass_scaling", "even", "uniform"},
    Renamed{"temperature.from", "plates", "references"},
};

/// Lines that a resolved recipe of version 0.1 did not have: keys that came later, as they stand where nothing else is asked for.
struct LaterLine {
  std::string_view section, line;
};
constexpr std::array later_lines{
    LaterLine{"contact", "rolling = \"none\""},
    LaterLine{"contact", "bonds = \"none\""},
    LaterLine{"contact", "cohesion = \"none\""},
    LaterLine{"stages.*", "bond = false"},
    LaterLine{"loads.*", "bond_law = \"elastic_brittle\""},
    LaterLine{"populations.*", "shape = \"disk\""},
    LaterLine{"stages.*", "slide = { left = \"0 mm/s\", right = \"0 mm/s\", bottom = \"0 mm/s\", top = \"0 mm/s\" }"},
    LaterLine{"stages.*", "rough = { left = false, right = false, bottom = false, top = false }"},
    LaterLine{"stages.*", "shear_rate = \"0 1/s\""},
    LaterLine{"stages.*", "gravity_size = \"9.81 m/s^2\""},
    LaterLine{"stages.*", "gravity_angle = \"0 deg\""},
};

std::string below(std::string_view section, std::string_view key) {
  const bool is_item = !key.empty() && std::all_of(key.begin(), key.end(), [](char c) { return c >= '0' && c <= '9'; });
  return section.empty() ? std::string(key) : fmt::format("{}.{}", section, is_item ? "*" : key);
}

template <auto from, auto to> std::string_view renamed(std::string_view section, std::string_view key) {
  for (const Renamed& each : former_keys)
    if (each.where == section && each.*from == key) return each.*to;
  return key;
}
constexpr auto key_now = renamed<&Renamed::former, &Renamed::now>, key_then = renamed<&Renamed::now, &Renamed::former>;

void rename_below(Node& node, const std::string& path, std::vector<std::string>& notices) {
  for (const Renamed& each : former_words) {
    if (node.kind != Node::Kind::text || node.text != each.former || path != each.where) continue;
    note_former_name(notices, fmt::format("{} = \"{}\"", path, each.former), fmt::format("\"{}\"", each.now));
    node.text = each.now;
  }
  for (Node& item : node.items) rename_below(item, below(path, "0"), notices);
  for (Entry& entry : node.entries) {
    const std::string_view now = key_now(path, entry.key);
    if (now != entry.key && !node.find(now)) {
      note_former_name(notices, below(path, entry.key), now);
      entry.key = now;
    }
    rename_below(entry.value, below(path, entry.key), notices);
  }
}

/// The parts of a dotted path, each given the name that `name` finds for it below the parts of now.
template <class Name> std::string renamed_path(std::string_view path, const Name& name, std::string& section) {
  std::string result;
  for (std::size_t begin = 0; begin <= path.size();) {
    const std::size_t end = std::min(path.find('.', begin), path.size());
    const std::string_view word = path.substr(begin, end - begin);
    const std::string_view other = name(section, word);
    result += (begin == 0 ? "" : ".") + std::string(other);
    section = below(section, key_now(section, word));
    begin = end + 1;
  }
  return result;
}

}  // namespace

void note_former_name(std::vector<std::string>& notices, std::string_view former, std::string_view now) {
  std::string sentence = fmt::format("{} is now called {}; the former name is still read", former, now);
  if (std::find(notices.begin(), notices.end(), sentence) == notices.end()) notices.push_back(std::move(sentence));
}

void rename_former_keys(Node& root, std::vector<std::string>& notices) { rename_below(root, "", notices); }

std::string current_key(std::string_view key, Node& value) {
  std::string path;
  const std::string now = renamed_path(key, key_now, path);
  std::vector<std::string> none;
  rename_below(value, path, none);
  return now;
}

std::string under_former_names(std::string_view toml) {
  std::string text, heading;
  for (std::size_t begin = 0; begin < toml.size();) {
    const std::size_t end = std::min(toml.find('\n', begin), toml.size());
    std::string line(toml.substr(begin, end - begin));
    begin = end + 1;
    const auto is_later = [&](const LaterLine& each) { return each.section == heading && each.line == line; };
    if (std::any_of(later_lines.begin(), later_lines.end(), is_later)) continue;
    const std::size_t open = line.find_first_not_of('['), equals = line.find(" = ");
    if (open > 0 && open != std::string::npos) {
      const std::size_t close = line.find(']');
      heading.clear();
      line.replace(open, close - open, renamed_path(line.substr(open, close - open), key_then, heading));
      // An item of a list stands under a heading without its number.
      if (open == 2) heading += ".*";
    } else if (equals != std::string::npos) {
      std::string section = line.find('.') < equals ? "" : heading;
      const std::string key = renamed_path(line.substr(0, equals), key_then, section);
      std::string value = line.substr(equals + 3);
      for (const Renamed& each : former_words)
        if (section == each.where && value == fmt::format("\"{}\"", each.now)) value = fmt::format("\"{}\"", each.former);
      line = fmt::format("{} = {}", key, value);
    }
    text += line + "\n";
  }
  return text;
}

}  // namespace arenite::recipe
