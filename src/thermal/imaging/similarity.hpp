#pragma once
#include <span>

#include "core/vec2.hpp"
#include "model/picture_grains.hpp"

namespace arenite::imaging {

/// Places in one picture to places in another, both in pixels with y down: p -> scale R(rotation) M p + shift, where M
/// turns x round if the picture is mirrored, and R turns from +x to +y.
struct Similarity {
  double scale = 1, rotation = 0;  ///< -, rad
  Vec2 shift;                      ///< pixels
  bool mirrored = false;

  Vec2 operator()(Vec2 p) const;
  Similarity inverse() const;
};

/// The similarity that takes `from` nearest to `to`, place by place, in the sense of least squares; at least two different
/// places. (Closed form: in the complex plane it is a straight line.)
Similarity fit_similarity(std::span<const Vec2> from, std::span<const Vec2> to, bool mirrored);

/// Grains of one picture as the other shows them: places moved, radii and errors scaled, the rest (brightness, score,
/// classes) as it was. Arrays that are empty stay empty.
PictureGrains apply(const Similarity& transform, PictureGrains grains);

}  // namespace arenite::imaging
