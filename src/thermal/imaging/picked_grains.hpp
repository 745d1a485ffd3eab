#pragma once
#include <algorithm>
#include <cstddef>
#include <vector>

#include "core/vec.hpp"
#include "model/film_place.hpp"
#include "model/image.hpp"

/// Which of the circles that were found in a picture are grains.
namespace arenite::imaging {

/// Drops what does not lie in a container of these inner sides (m): its screws and edges look round, too.
void keep_inside(Vec2 container, const FilmPlace& place, PictureGrains& grains);

/// Share of a container of these inner sides (m) that the disks of the grains cover.
double covered_share(Vec2 container, const FilmPlace& place, const PictureGrains& grains);

/// Grains in a container fill three quarters of it and more (random close packing of disks: 0.82 to 0.84); less than
/// this means that some were not found.
inline constexpr double least_covered_share = 0.65;

/// Standard error of the centre of a grain that a list places by hand, pixels: even within a pixel, 1/sqrt(12).
inline constexpr double listed_position_error = 0.3;

/// Share of the smaller radius by which load never presses two grains together.
inline constexpr double most_overlap = 0.3;

/// Calls see(i, j, overlap) for disks i and j < i that overlap by more than load can press them.
template <class See>
void each_overlap(const std::vector<Vec2>& centre, const std::vector<double>& radius, const See& see) {
  for (std::size_t i = 0; i < centre.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (const double overlap = radius[i] + radius[j] - norm(centre[i] - centre[j]);
          overlap > most_overlap * std::min(radius[i], radius[j]))
        see(i, j, overlap);
}

/// Of two circles that overlap so much the one whose rim shows less is no grain.
void drop_overlapping(PictureGrains& grains);

/// Drops pores between three grains: they may have a round rim, but are as dark as what is behind the grains. `frame`
/// is the picture, whose grains are `bright` or dark.
void drop_pores(const std::vector<float>& frame, bool bright, PictureGrains& grains);

}  // namespace arenite::imaging
