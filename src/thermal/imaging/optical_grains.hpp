#pragma once
#include <string>
#include <vector>

#include "core/vec.hpp"
#include "model/film_place.hpp"
#include "model/image.hpp"
#include "model/lockin_maps.hpp"
#include "thermal/imaging/circles.hpp"

namespace arenite::imaging {

/// How an ordinary camera looks at a sample that is filmed, too.
struct OpticalView {
  std::string file;                  ///< of its picture, for messages
  double pixel = 0, film_pixel = 0;  ///< sides of pixels on the sample, m
  Vec2 container;                    ///< its inner width and height, m
  bool is_placed = false;            ///< its place in the film is given; else it is in the middle
  double travel = 0;                 ///< of its lower wall from the smallest to the largest load, m
  std::vector<double> radii;         ///< size classes of the grains, m; empty: found
  CircleOptions search = {};         ///< how rims are searched
};

/// Grains found in an ordinary camera's picture of the sample at the smallest load and carried to where `frame`, the
/// film's own picture at that load, shows them; in the film's pixels, with brightnesses of the optical picture and no
/// materials. Both pictures nearly have the same middle (8 pixels of the film, 2 degrees); one that lies elsewhere is
/// laid on grains that the film itself shows. A frame without contrast says nothing of grains, which then are where
/// pixels warm with the load (`maps`), moved as far as the wall travels. `notes` gets how the pictures lie. Throws
/// InputError where there are no grains or they fit nowhere.
PictureGrains optical_grains(const Image& picture, const OpticalView& view, const FilmPlace& place,
                             const FloatImage& frame, const LockinMaps& maps, std::vector<std::string>& notes);

}  // namespace arenite::imaging
