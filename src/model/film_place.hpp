#pragma once
#include <optional>

#include "core/vec.hpp"
#include "model/image.hpp"
#include "model/packing.hpp"

namespace arenite {

/// The one place where rows that point down become heights: pixels of a film as metres from the container's lower left
/// inner corner at the smallest load.
struct FilmPlace {
  Vec2 origin;       ///< centre of the upper left pixel, m
  double pixel = 1;  ///< m
  Vec2 metres(Vec2 pixels) const { return {origin.x + pixels.x * pixel, origin.y - pixels.y * pixel}; }
  Vec2 pixels(Vec2 metres) const { return {(metres.x - origin.x) / pixel, (origin.y - metres.y) / pixel}; }
};

/// That of a picture of so many columns and rows which shows a container of this inner width and height (m): its left
/// inner edge is in column `left` and its upper one in row `top`, and where these are not known the container is in the
/// middle of the picture.
FilmPlace place_of_container(int columns, int rows, double pixel, Vec2 container, std::optional<double> left = {},
                             std::optional<double> top = {});

/// Grains of a picture in metres, numbered from 1.
Grains in_metres(const PictureGrains& grains, const FilmPlace& place);

}  // namespace arenite
