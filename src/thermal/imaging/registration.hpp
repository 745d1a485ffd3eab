#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/vec.hpp"
#include "model/image.hpp"

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

/// The similarity that takes `from` nearest to `to`, place by place, in the sense of least squares; at least two
/// different places. (Closed form: in the complex plane it is a straight line.)
Similarity fit_similarity(std::span<const Vec2> from, std::span<const Vec2> to, bool mirrored);

/// Grains of one picture as the other shows them: places moved, radii and errors scaled, the rest (brightness, score,
/// classes) as it was. Arrays that are empty stay empty.
PictureGrains apply(const Similarity& transform, PictureGrains grains);

enum class Mirror : std::uint8_t { no, yes, found };

struct RegistrationOptions {
  std::optional<double> scale = {};  ///< pixels of `to` a pixel of `from`, where it is known
  double scale_within = 0.1;         ///< share by which a scale that is given may be off
  Mirror mirror = Mirror::no;
  double radius_within =
      0.25;  ///< share by which radii of one grain may differ in both pictures; 0: radii are not compared
};

/// How one set of circles lies on another.
struct Registration {
  Similarity transform;                                      ///< from `from` to `to`
  std::vector<std::pair<std::int32_t, std::int32_t>> pairs;  ///< index in `from`, index in `to`, by the first
  double rms = 0;  ///< of what is left between the two of each pair, along one axis, pixels of `to`
  double scale_error = 0, rotation_error = 0;  ///< standard errors: -, rad
  double matched = 0;                          ///< pairs over the size of the smaller set
};

/// Finds the similarity that lays grains found in one picture (optical) on those found in another (thermal) without a
/// hand-picked point: two grains of the one are held against all pairs of the other that agree in size, what fits their
/// neighbours is grown over the picture, and the transform whose pairs are many and near is fitted to all of them,
/// outliers left out; it is taken once two more pairs of grains have led to none better. Grains may be missing or
/// invented in both, and the pictures need not show the same part. Throws InputError where there are fewer than three
/// grains in a set or too few find a partner.
Registration register_circles(const PictureGrains& from, const PictureGrains& to,
                              const RegistrationOptions& options = {});

}  // namespace arenite::imaging
