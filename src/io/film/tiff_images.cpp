#include "io/film/tiff_images.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <string_view>
#include <unordered_set>
#include <utility>

#include "core/option.hpp"
#include "core/text.hpp"

namespace arenite::io {
namespace {

std::uint64_t number_of_bytes(std::string_view bytes, std::size_t at, std::size_t size, bool big_endian) {
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < size; ++i)
    value |= std::uint64_t{number_at<std::uint8_t>(bytes, at + i)} << 8 * (big_endian ? size - 1 - i : i);
  return value;
}

/// Where the directories of all pages begin: the chain is followed once, so that any page is reached at once after.
std::vector<std::uint64_t> page_places(const TiffSource& source) {
  const ByteSource& bytes = *source.bytes;
  const std::string head = bytes.text(0, 16);
  const bool swap = head[0] == 'M', large = number_of_bytes(head, 2, 2, swap) == 43;
  const std::size_t count_size = large ? 8 : 2, entry = large ? 20 : 12, link = large ? 8 : 4;
  std::vector<std::uint64_t> places;
  std::unordered_set<std::uint64_t> seen;
  for (std::uint64_t at = number_of_bytes(head, large ? 8 : 4, link, swap); at != 0;) {
    if (!seen.insert(at).second)
      source.refuse(fmt::format("is a TIFF film whose pages form a loop after page {}; write it again", places.size()));
    const std::uint64_t entries = number_of_bytes(bytes.text(at, count_size), 0, count_size, swap);
    const std::uint64_t end = at + count_size + entries * entry;
    if (entries > 4096 || end + link > bytes.size() || end < at) source.refuse_damaged();
    places.push_back(at);
    at = number_of_bytes(bytes.text(end, link), 0, link, swap);
  }
  return places;
}

/// Where the images of a file begin that has one directory for all of them.
std::uint64_t first_of_many(TIFF* tiff, const TiffSource& source, std::uint64_t frame, std::int64_t images,
                            std::string_view by) {
  const auto strips = TIFFNumberOfStrips(tiff);
  std::uint64_t first = TIFFIsTiled(tiff) != 0 ? 0 : TIFFGetStrileOffset(tiff, 0), end = first;
  for (std::uint32_t k = 0; k < strips && first > 0; ++k) {
    if (TIFFGetStrileOffset(tiff, k) != end) first = 0;
    end += TIFFGetStrileByteCount(tiff, k);
  }
  const bool plain = first > 0 && tiff_field<std::uint16_t>(tiff, TIFFTAG_COMPRESSION) == COMPRESSION_NONE;
  const std::uint64_t size = source.bytes->size(), there = plain && size > first ? (size - first) / frame : 0;
  if (there < static_cast<std::uint64_t>(images))
    source.refuse(fmt::format("holds {} images, but {} describes {}; save it again", std::max<std::uint64_t>(there, 1),
                              by, images));
  return first;
}

}  // namespace

TiffImages::TiffImages(TIFF* tiff, const TiffSource& source, TiffStack stack, std::uint64_t bytes_an_image,
                       const std::string& channel)
    : stack_(std::move(stack)),
      places_(page_places(source)) {
  if (places_.empty()) source.refuse("holds no frame; record the film again");
  if (stack_.images() <= 1) stack_ = {};
  if (stack_.by.empty()) return;
  if (stack_.frames > 1 && stack_.slices > 1)
    source.refuse(fmt::format("holds {} frames of {} slices, as {} describes it; save one slice", stack_.frames,
                              stack_.slices, stack_.by));
  if (stack_.slices > 1) {
    std::swap(stack_.slices, stack_.frames);
    for (char& axis : stack_.order) axis = axis == 'Z' ? 'T' : axis == 'T' ? 'Z' : axis;
    remarks_.push_back(fmt::format("{} calls its frames slices.", stack_.by));
  }
  find_places(tiff, source, bytes_an_image);
  if (stack_.channels > 1) choose(source, channel);
}

/// The images that are stated are those of the file, or all pages are frames.
void TiffImages::find_places(TIFF* tiff, const TiffSource& source, std::uint64_t bytes_an_image) {
  const auto pages = static_cast<std::int64_t>(places_.size()), images = stack_.images();
  if (pages == 1) {
    behind_ = first_of_many(tiff, source, bytes_an_image, images, stack_.by);
  } else if (pages < images) {
    source.refuse(fmt::format("holds {} images, but {} describes {}; save it again", pages, stack_.by, images));
  } else if (pages > images) {
    remarks_.push_back(fmt::format("{} describes {} images, but the film has {} pages, which are all read.", stack_.by,
                                   images, pages));
    stack_ = {};
  }
}

void TiffImages::choose(const TiffSource& source, const std::string& channel) {
  std::vector<std::string> names;
  for (std::int64_t c = 1; c <= std::min<std::int64_t>(stack_.channels, 64); ++c)
    names.push_back(fmt::format("channel {}", c));
  const auto found = std::ranges::find(names, channel);
  if (found == names.end())
    source.refuse(fmt::format("holds {} frames of {} channels, as {} describes it; choose one with {}: {}",
                              stack_.frames, stack_.channels, stack_.by, option("dataset"), list_of(names)));
  channel_ = found - names.begin();
}

std::vector<double> TiffImages::times() const {
  if (static_cast<std::int64_t>(stack_.time.size()) != stack_.channels * stack_.frames) return {};
  const auto first = stack_.time.begin() + channel_ * stack_.frames;
  return {first, first + stack_.frames};
}

}  // namespace arenite::io
