#include "workflow/film_grains.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "core/error.hpp"
#include "core/text.hpp"
#include "io/film/film.hpp"
#include "thermal/thermography/correction.hpp"
#include "thermal/thermography/frame_statistics.hpp"

namespace arenite::workflow {
namespace {

/// Photographs, which open as films of one frame, too, where they are grey.
bool is_photograph(const std::filesystem::path& path) {
  const std::string ending = lower_case(path.extension().string());
  return ending == ".png" || ending == ".jpg" || ending == ".jpeg";
}

GrainPicture picture_of_film(const std::filesystem::path& path, const PictureChoice& choice) {
  const auto film = io::open_film(path, {.dataset = choice.dataset});
  const FilmInfo& info = film->info();
  if (choice.frame && (*choice.frame < 0 || *choice.frame >= info.frames))
    throw InputError(path.string(), 0, fmt::format("holds {} frames; there is no frame {} (frames count from 0)", info.frames, *choice.frame));
  const thermography::FrameStatistics statistics = thermography::frame_statistics(*film);
  GrainPicture picture{{info.width, info.height, statistics.mean}, static_cast<std::int64_t>(statistics.frames), 0, true};
  const std::vector<std::uint8_t> bad = thermography::find_bad_pixels(statistics);
  thermography::Correction correction;
  correction.width = info.width;
  correction.height = info.height;
  correction.bad = thermography::replacements(bad, info.width, info.height);
  picture.replaced = correction.bad.size();
  FrameBlock block;
  if (choice.frame) {
    film->read(*choice.frame, 1, block);
    picture.frames = 1;
  } else {
    block.frames = 1;
    block.value = std::move(picture.image.value);
  }
  thermography::apply(correction, block, picture.image.value);
  return picture;
}

}  // namespace

GrainPicture read_grain_picture(const std::filesystem::path& path, const PictureChoice& choice) {
  io::refuse_other_recording(path);
  if (!is_photograph(path) && io::looks_like_film(path)) return picture_of_film(path, choice);
  return {to_float(io::read_image(path, {.slice = choice.frame, .dataset = choice.dataset, .channel = choice.channel})), 1, 0, false};
}

}  // namespace arenite::workflow
