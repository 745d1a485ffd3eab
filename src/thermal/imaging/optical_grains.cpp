#include "thermal/imaging/optical_grains.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/problems.hpp"
#include "core/ranks.hpp"
#include "model/lockin_maps.hpp"
#include "thermal/imaging/grains_of_picture.hpp"
#include "thermal/imaging/overlay.hpp"
#include "thermal/imaging/registration.hpp"

namespace arenite::imaging {
namespace {

constexpr double enough = 2;   // pixels of the optical picture along one of the film give centres to a hundredth
constexpr double margin = 10;  // pixels of the film round the container in which its grains may lie
constexpr double least_correlation = 0.3, most_rms = 0.5;  // of an overlay that is believed; pixels of the film

/// Part of a picture; pixels count from there.
struct Part {
  int column = 0, row = 0, width = 0, height = 0;
};

/// The container and what is near it, in the middle of the picture: what is round it costs time and looks round, too.
Part part_near_container(const OpticalView& view, const Image& image, double pixel) {
  const auto side = [&](double inner, int all) {
    return std::min(all, static_cast<int>(std::ceil((inner + 2 * margin * view.film_pixel) / pixel)));
  };
  Part part{0, 0, image.width, image.height};
  if (view.is_placed) return part;
  part.width = side(view.container.x, image.width);
  part.height = side(view.container.y, image.height);
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
Similarity as_given(const Image& whole, const Part& part, int times, const FloatImage& film, double scale) {
  const auto first = [&](int begin, int all) { return (begin + 0.5 * (times - 1) - 0.5 * (all - 1)) / times; };
  return {scale,
          0,
          {0.5 * (film.width - 1) + scale * first(part.column, whole.width),
           0.5 * (film.height - 1) + scale * first(part.row, whole.height)},
          false};
}

bool fits(const Overlay& overlay) {
  return std::abs(overlay.correlation) >= least_correlation && overlay.rms <= most_rms;
}

/// Where pixels warm and cool with the load: grains, however alike their rims are to what is behind them. Bright spots
/// at contacts count no more than most of a grain's pixels.
FloatImage warming_of(const LockinMaps& maps) {
  FloatImage warming{maps.width, maps.height, maps.amplitude};
  const float most = of_rank(warming.value, warming.value.size() * 6 / 10);
  for (float& v : warming.value) v = std::min(v, most);
  return warming;
}

/// Grains of an optical picture when the load is largest.
PictureGrains when_loaded(const OpticalView& view, const FilmPlace& place, PictureGrains grains,
                          const Similarity& first) {
  const Similarity back = first.inverse();
  for (Vec2& centre : grains.centre) {
    const Vec2 at = first(centre);
    const double share = 1 - place.metres(at).y / view.container.y;
    centre = back(at - Vec2{0, share * view.travel / place.pixel});
  }
  return grains;
}

Overlay lay_over_grains(const PictureGrains& grains, const Similarity& first, const FloatImage& frame) {
  auto overlay = lay_over(grains, first, frame);
  if (fits(overlay)) return overlay;
  try {
    const auto shown = find_circles(frame);
    overlay = lay_over(grains, register_circles(grains, shown.grains, {.scale = first.scale}).transform, frame, {2, 0});
  } catch (const InputError&) { overlay.rms = 2 * most_rms; }
  return overlay;
}

constexpr const char* laid_over_warming =
    "the film's frames show no contrast between grains and background; the optical picture is laid over the amplitude "
    "map, and the positions of grains are known to about 0.1 pixels";
constexpr double warming_rms = 1.2,
                 warming_error =
                     0.1;  // pixels: circles that are fitted one by one to uneven warming, and all of them together

}  // namespace

PictureGrains optical_grains(const Image& whole, const OpticalView& view, const FilmPlace& place,
                             const FloatImage& frame, const LockinMaps& maps, std::vector<std::string>& notes) {
  const double fine = view.pixel;
  const int times = std::max(1, static_cast<int>(view.film_pixel / (enough * fine) + 1e-6));
  const Part part = part_near_container(view, whole, fine);
  const FloatImage image = coarser(whole, part, times);
  const double pixel = times * fine;
  CircleOptions search = view.search;
  search.largest = 0.25 * std::min(view.container.x, view.container.y) / pixel;
  auto found = circles_of(view.radii, image, pixel, search);
  if (found.grains.size() < 3)
    refuse(view.file,
           "shows {} grains; give a picture in which they stand out, or a list of the grains (picture.grains)",
           found.grains.size());
  const auto first = as_given(whole, part, times, frame, pixel / view.film_pixel);
  auto overlay = lay_over_grains(found.grains, first, frame);
  bool by_warming = false;
  if (!fits(overlay)) {
    overlay = lay_over(when_loaded(view, place, found.grains, first), first, warming_of(maps));
    by_warming = overlay.correlation >= least_correlation && overlay.rms <= warming_rms;
    if (!by_warming)
      refuse(view.file,
             "does not fit on the film; take it at the smallest load from the same side, and give its scale "
             "(picture.optical_pixel)");
    notes.push_back(laid_over_warming);
  }
  const Vec2 middle = first.inverse()({0.5 * (frame.width - 1), 0.5 * (frame.height - 1)}),
             off = overlay.transform(middle) - first(middle);
  notes.push_back(
      fmt::format("the optical picture shows {} grains; it is shifted by {:.2f} pixels of the film to the left and "
                  "{:.2f} upwards, rotated by {:.2f} degrees, its scale is {:+.2f} % off, and grains in the film are "
                  "{:.2f} pixels (rms) from their positions in it",
                  found.grains.size(), off.x, off.y, overlay.transform.rotation * 180 / std::numbers::pi,
                  100 * (overlay.transform.scale / first.scale - 1), overlay.rms));
  auto grains = apply(overlay.transform, std::move(found.grains));
  const Vec2 centre = mean_point(grains.centre);
  for (std::size_t i = 0; i < grains.size(); ++i) {
    const double laid = std::hypot(overlay.shift_error, overlay.turn_error * norm(grains.centre[i] - centre),
                                   by_warming ? warming_error : 0);
    grains.position_error[i] = std::hypot(grains.position_error[i], laid);
  }
  return grains;
}

}  // namespace arenite::imaging
