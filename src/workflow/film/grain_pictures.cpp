#include "workflow/film/grain_pictures.hpp"

#include <string>
#include <utility>
#include <vector>

#include "core/problems.hpp"
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

GrainPicture picture_of_film(const std::filesystem::path& path, const io::ImageChoice& choice) {
  const auto film = io::open_film(path, {.dataset = choice.dataset});
  const FilmInfo& info = film->info();
  if (choice.slice && (*choice.slice < 0 || *choice.slice >= info.frames))
    refuse(path.string(), "holds {} frames; there is no frame {} (frames count from 0)", info.frames, *choice.slice);
  const thermography::FrameStatistics statistics = thermography::frame_statistics(*film);
  GrainPicture picture{{info.width, info.height, statistics.mean}, static_cast<std::int64_t>(statistics.frames), 0};
  const std::vector<std::uint8_t> bad = thermography::find_bad_pixels(statistics);
  thermography::Correction correction;
  correction.width = info.width;
  correction.height = info.height;
  correction.bad = thermography::replacements(bad, info.width, info.height);
  picture.replaced = correction.bad.size();
  FrameBlock block;
  if (choice.slice) {
    film->read(*choice.slice, 1, block);
    picture.frames = 1;
  } else {
    block.frames = 1;
    block.value = std::move(picture.image.value);
  }
  thermography::apply(correction, block, picture.image.value);
  return picture;
}

}  // namespace

void declare(ParameterVisitor& v, GrainPictureKeys& keys) {
  v.integer({"frame", "Frame of a film, or slice of a stack, counted from 0; unless given, the mean of all frames."},
            keys.frame, {0, 1'000'000'000'000});
  int channel = static_cast<int>(keys.channel) - 1;  // `none` cannot be chosen
  v.choice({"channel", "Colour channel that is used."}, channel,
           {{"red", ""}, {"green", ""}, {"blue", ""}, {"mean", ""}, {"grey", "as bright as the eye sees it"}});
  keys.channel = static_cast<io::Channel>(channel + 1);
  v.numbers(
      {"origin",
       "Pixel at which x = y = 0, column and row counted from the upper left; unless given, the lower left corner "
       "of the picture."},
      keys.origin, "", range::any);
  v.require(keys.origin.empty() || keys.origin.size() == 2, {"origin"},
            "must be column and row of a pixel, counted from the upper left, for example 50,228");
  v.text({"materials",
          "Materials by brightness, darkest first, with commas between; unless given, the classes are found "
          "automatically."},
         keys.materials);
}

GrainPicture read_grain_picture(const std::filesystem::path& path, const io::ImageChoice& choice) {
  io::refuse_other_recording(path);
  if (!is_photograph(path) && io::looks_like_film(path)) return picture_of_film(path, choice);
  return {to_float(io::read_image(path, choice)), 1, 0};
}

}  // namespace arenite::workflow
