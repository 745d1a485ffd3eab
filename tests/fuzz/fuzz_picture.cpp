#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "core/error.hpp"
#include "io/image/phase_map.hpp"
#include "thermal/imaging/label_grains.hpp"

namespace {

using namespace arenite;

/// Small enough that a run is quick; the rule is the same for any limit.
constexpr std::int64_t most_pixels = 1 << 16;

io::PhaseMapOptions options_of(unsigned way) {
  io::PhaseMapOptions options;
  options.image.most_pixels = most_pixels;
  if ((way & 1) != 0) options.image.slice = way >> 4;
  options.image.channel = static_cast<io::Channel>((way >> 4) % 6);
  if ((way & 2) != 0)
    options.phases = {{0, Phase::empty}, {85, Phase::particle}, {170, Phase::matrix}, {255, Phase::matrix}};
  if ((way & 4) != 0) options.crop = io::Crop{1, 0, 3, 2};
  return options;
}

void examine(const Image& image) {
  if (image.width <= 0 || image.height <= 0 || static_cast<std::int64_t>(image.size()) > most_pixels) std::abort();
  if (image.value.size() != image.size()) std::abort();
}

/// What came through is a sound map, with labels of its own or found by the watershed.
void label_and_examine(io::ForeignMap& read) {
  if (!read.labelled) imaging::label_grains(read.map, {imaging::Labelling::watershed, 1});
  try {
    check(read.map);
  } catch (const InputError&) { std::abort(); }
}

}  // namespace

/// Any bytes are a picture or an InputError, and any picture is a phase map or an InputError. The first byte chooses
/// slice or channel, table, crop and labels (the picture itself); the rest is the file.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const io::PhaseMapOptions options = options_of(data[0]);
  try {
    const Image image =
        io::decode_image(std::string(reinterpret_cast<const char*>(data) + 1, size - 1), "picture", options.image);
    examine(image);
    io::ForeignMap read =
        io::make_phase_map(image, (data[0] & 8) != 0 ? &image : nullptr, options, "picture", "labels");
    label_and_examine(read);
  } catch (const InputError& error) {
    if (error.problems().empty()) std::abort();
  }
  return 0;
}
