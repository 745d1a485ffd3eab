#include "workflow/measure_film.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/mapped.hpp"
#include "core/median.hpp"
#include "core/problems.hpp"
#include "core/text.hpp"
#include "statistics/clusters.hpp"
#include "thermal/imaging/registration.hpp"

namespace arenite::workflow {
namespace {

constexpr double enough = 2;   // pixels of the optical picture along one of the film give centres to a hundredth
constexpr double margin = 10;  // pixels of the film round the container in which its grains may lie
constexpr double least_correlation = 0.3, most_rms = 0.5;  // of an overlay that is believed; pixels of the film

/// Part of a picture; pixels count from there.
struct Part {
  int column = 0, row = 0, width = 0, height = 0;
};

/// The container and what is near it, in the middle of the picture: what is round it costs time and looks round, too.
Part part_near_container(const recipe::FilmRecipe& recipe, const Image& image, double pixel) {
  const auto side = [&](double inner, int all) {
    return std::min(all, static_cast<int>(std::ceil((inner + 2 * margin * recipe.picture.pixel) / pixel)));
  };
  Part part{0, 0, image.width, image.height};
  if (recipe.container.left || recipe.container.top) return part;
  part.width = side(recipe.container.width, image.width);
  part.height = side(recipe.container.height, image.height);
  part.column = (image.width - part.width) / 2;
  part.row = (image.height - part.height) / 2;
  return part;
}

/// Mean over squares of `times` x `times` pixels.
FloatImage coarser(const Image& image, const Part& part, int times) {
  FloatImage out{part.width / times, part.height / times, {}};
  for (int row = 0; row < out.height; ++row)
    for (int column = 0; column < out.width; ++column) {
      double sum = 0;
      for (int r = 0; r < times; ++r)
        for (int c = 0; c < times; ++c)
          sum += static_cast<double>(
              image.value[image.index(part.column + column * times + c, part.row + row * times + r)]);
      out.value.push_back(static_cast<float>(sum / (times * times)));
    }
  return out;
}

/// Both pictures have one middle and the scales that the recipe gives.
imaging::Similarity as_given(const Image& whole, const Part& part, int times, const FilmInfo& film, double scale) {
  const auto first = [&](int begin, int all) { return (begin + 0.5 * (times - 1) - 0.5 * (all - 1)) / times; };
  return {scale,
          0,
          {0.5 * (film.width - 1) + scale * first(part.column, whole.width),
           0.5 * (film.height - 1) + scale * first(part.row, whole.height)},
          false};
}

/// What a picture's noise does not tell of the errors of circles shows in the radii of one class, which are alike: by
/// how much they scatter more than their errors say.
double scatter_of_radii(const imaging::FoundCircles& found) {
  std::vector<double> off;
  for (std::size_t i = 0; i < found.grains.size(); ++i)
    if (const auto k = found.grains.size_class[i]; k >= 0 && found.grains.radius_error[i] > 0)
      off.push_back(std::abs(found.grains.radius[i] - found.report.sizes.mean[static_cast<std::size_t>(k)]) /
                    found.grains.radius_error[i]);
  return std::clamp(median(std::move(off)) / median_of_normal_size, 1.0, 10.0);
}

bool fits(const imaging::Overlay& overlay) {
  return std::abs(overlay.correlation) >= least_correlation && overlay.rms <= most_rms;
}

/// Where pixels warm and cool with the load: grains, however alike their rims are to what is behind them. Bright spots
/// at contacts count no more than most of a grain's pixels.
FloatImage warming_of(const LockinMaps& maps) {
  FloatImage warming{maps.width, maps.height, maps.amplitude};
  std::vector<float> sorted = warming.value;
  const auto most = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() * 6 / 10);
  std::nth_element(sorted.begin(), most, sorted.end());
  for (float& v : warming.value) v = std::min(v, *most);
  return warming;
}

/// Grains of an optical picture when the load is largest.
PictureGrains when_loaded(const recipe::FilmRecipe& recipe, const FilmPlace& place, PictureGrains grains,
                          const imaging::Similarity& first) {
  const imaging::Similarity back = first.inverse();
  for (Vec2& centre : grains.centre) {
    const Vec2 at = first(centre);
    const double share = 1 - place.metres(at).y / recipe.container.height;
    centre = back(at - Vec2{0, share * recipe.container.travel / place.pixel});
  }
  return grains;
}

imaging::Overlay lay_over_grains(const PictureGrains& grains, const imaging::Similarity& first,
                                 const FloatImage& frame) {
  auto overlay = imaging::lay_over(grains, first, frame);
  if (fits(overlay)) return overlay;
  try {
    const auto shown = imaging::find_circles(frame);
    overlay = imaging::lay_over(
        grains, imaging::register_circles(grains, shown.grains, {.scale = first.scale}).transform, frame, {2, 0});
  } catch (const InputError&) { overlay.rms = 2 * most_rms; }
  return overlay;
}

constexpr const char* laid_over_warming =
    "the film's frames show no contrast between grains and background; the optical picture is laid over the amplitude "
    "map, and the positions of grains are known to about 0.1 pixels";
constexpr double warming_rms = 1.2,
                 warming_error =
                     0.1;  // pixels: circles that are fitted one by one to uneven warming, and all of them together

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

imaging::FoundCircles circles_of(const recipe::FilmRecipe& recipe, const FloatImage& picture, double pixel,
                                 imaging::CircleOptions options) {
  for (const double r : recipe.picture.radii) options.radii.push_back(r / pixel);
  auto found = imaging::find_circles(picture, options);
  const double times = scatter_of_radii(found);
  for (auto* errors : {&found.grains.position_error, &found.grains.radius_error})
    for (double& error : *errors) error *= times;
  for (std::size_t i = 0; i < found.grains.size(); ++i)
    if (const auto k = found.grains.size_class[i]; k >= 0)
      found.grains.radius[i] = found.report.sizes.mean[static_cast<std::size_t>(k)];
  return found;
}

void take_materials(const recipe::FilmRecipe& recipe, const std::string& where, PictureGrains& grains) {
  const auto order = ordered_by(recipe.materials.size(), [&](std::size_t m) { return recipe.materials[m].brightness; });
  const auto classes = statistics::cluster(grains.brightness, {.most = order.size()});
  if (classes.size() != order.size())
    throw refusal(
        "grains in {} have {} {} of brightness, and the recipe {} materials; give an optical picture in which they "
        "differ (picture.optical) or a list of the grains (picture.grains)",
        where, classes.size(), classes.size() == 1 ? "kind" : "kinds", order.size());
  grains.material.clear();
  for (const auto k : classes.of)
    grains.material.push_back(static_cast<std::int32_t>(order[static_cast<std::size_t>(k)]));
}

PictureGrains optical_grains(const recipe::FilmRecipe& recipe, const FilmPlace& place, const FilmInfo& film,
                             const std::vector<float>& frame, const LockinMaps& maps, std::vector<std::string>& notes) {
  const auto file = recipe.beside(recipe.picture.optical).string();
  const double fine = recipe.picture.optical_pixel > 0 ? recipe.picture.optical_pixel : recipe.picture.pixel;
  const int times = std::max(1, static_cast<int>(recipe.picture.pixel / (enough * fine) + 1e-6));
  const Image whole = io::read_image(file);
  const Part part = part_near_container(recipe, whole, fine);
  const FloatImage image = coarser(whole, part, times);
  const double pixel = times * fine;
  auto found = circles_of(recipe, image, pixel,
                          {.largest = 0.25 * std::min(recipe.container.width, recipe.container.height) / pixel});
  if (found.grains.size() < 3)
    refuse(file, "shows {} grains; give a picture in which they stand out, or a list of the grains (picture.grains)",
           found.grains.size());
  const auto first = as_given(whole, part, times, film, pixel / recipe.picture.pixel);
  auto overlay = lay_over_grains(found.grains, first, {film.width, film.height, frame});
  bool by_warming = false;
  if (!fits(overlay)) {
    overlay = imaging::lay_over(when_loaded(recipe, place, found.grains, first), first, warming_of(maps));
    by_warming = overlay.correlation >= least_correlation && overlay.rms <= warming_rms;
    if (!by_warming)
      refuse(file,
             "does not fit on the film; take it at the smallest load from the same side, and give its scale "
             "(picture.optical_pixel)");
    notes.push_back(laid_over_warming);
  }
  const Vec2 middle = first.inverse()({0.5 * (film.width - 1), 0.5 * (film.height - 1)}),
             off = overlay.transform(middle) - first(middle);
  notes.push_back(
      fmt::format("the optical picture shows {} grains; it is shifted by {:.2f} pixels of the film to the left and "
                  "{:.2f} upwards, rotated by {:.2f} degrees, its scale is {:+.2f} % off, and grains in the film are "
                  "{:.2f} pixels (rms) from their positions in it",
                  found.grains.size(), off.x, off.y, overlay.transform.rotation * 180 / std::numbers::pi,
                  100 * (overlay.transform.scale / first.scale - 1), overlay.rms));
  auto grains = imaging::apply(overlay.transform, std::move(found.grains));
  const Vec2 centre = mean_point(grains.centre);
  for (std::size_t i = 0; i < grains.size(); ++i) {
    const double laid = std::hypot(overlay.shift_error, overlay.turn_error * norm(grains.centre[i] - centre),
                                   by_warming ? warming_error : 0);
    grains.position_error[i] = std::hypot(grains.position_error[i], laid);
  }
  return grains;
}

GrainPicture read_grain_picture(const std::filesystem::path& path, const io::ImageChoice& choice) {
  io::refuse_other_recording(path);
  if (!is_photograph(path) && io::looks_like_film(path)) return picture_of_film(path, choice);
  return {to_float(io::read_image(path, choice)), 1, 0};
}

}  // namespace arenite::workflow
