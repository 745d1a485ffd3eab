#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "core/error.hpp"
#include "io/image/phase_map.hpp"
#include "thermal/imaging/label_grains.hpp"

namespace {

using namespace arenite;

/// What a line of text gives, up to `end`, which is taken away with it.
std::string_view take_until(std::string_view& text, char end) {
  const std::string_view part = text.substr(0, text.find(end));
  text.remove_prefix(std::min(text.size(), part.size() + 1));
  return part;
}

/// A picture of this width whose values are bytes, four times as large where they pass for labels.
Image picture_of(std::string_view bytes, int width, int factor) {
  Image image{width, static_cast<int>(bytes.size()) / width, {}};
  for (std::size_t i = 0; i < image.size(); ++i) image.value.push_back(factor * static_cast<std::uint8_t>(bytes[i]));
  return image;
}

}  // namespace

/// Any table of phases, crop, picture and labels are a sound phase map or an InputError: a line with the table (empty:
/// guess), a line with the crop (empty: none), a byte of width, a byte (odd: half of the rest are labels), the pixels.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::string_view text(reinterpret_cast<const char*>(data), size);
  const std::string_view table = take_until(text, '\n'), crop = take_until(text, '\n');
  if (text.size() < 2) return 0;
  const int width = 1 + static_cast<std::uint8_t>(text[0]) % 32;
  const bool labelled = text[1] % 2 != 0;
  text.remove_prefix(2);
  io::PhaseMapOptions options;
  try {
    if (!table.empty()) options.phases = io::parse_phase_table(table);
    if (!crop.empty()) options.crop = io::parse_crop(crop);
    const std::size_t half = labelled ? text.size() / 2 : text.size();
    const Image picture = picture_of(text.substr(0, half), width, 1), labels = picture_of(text.substr(half), width, 4);
    io::ForeignMap read = io::make_phase_map(picture, labelled ? &labels : nullptr, options, "picture", "labels");
    if (!read.labelled) imaging::label_grains(read.map, {imaging::Labelling::watershed, 0.5});
    try {
      check(read.map);
    } catch (const InputError&) { std::abort(); }
  } catch (const InputError& error) {
    if (error.problems().empty()) std::abort();
  }
  return 0;
}
