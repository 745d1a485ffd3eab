#pragma once
#include <vector>

#include "model/film.hpp"
#include "model/image.hpp"
#include "thermal/radiometry/band.hpp"
#include "thermal/thermography/correction.hpp"

namespace arenite::thermography {

/// A point of a calibration curve.
struct LevelPoint {
  double level = 0, temperature = 0;  ///< digital level, K
};

/// Levels for which a curve is made.
struct LevelRange {
  double low = 0, high = 16383;
};

/// Straight between the points of a black body, whatever their order; beyond them the last pieces go on. Throws InputError for fewer
/// than two points, two of one level, or temperatures that do not rise with the level.
LevelCurve curve_through(std::vector<LevelPoint> points, const LevelRange& range = {});

/// The same for a surface that is not black: what a level says of the photons stays, and a part of them is mirrored.
LevelCurve curve_through(std::vector<LevelPoint> points, const radiometry::Band& band, const radiometry::Surface& surface, const LevelRange& range = {});

/// Radiometry between two black-body references: the level is a straight line of the photons in the band, and a surface that is
/// not black shows eps N(T) + (1 - eps) N(T_amb).
LevelCurve curve_by_references(const radiometry::Band& band, const LevelPoint& cold, const LevelPoint& warm, const radiometry::Surface& surface,
                               const LevelRange& range = {});

/// Radiometry with one level known, which is that of a black surface: levels are proportional to photons.
LevelCurve curve_by_radiometry(const radiometry::Band& band, const LevelPoint& known, const radiometry::Surface& surface, const LevelRange& range = {});

/// What temperatures were made with, and what grains are.
struct GrainSurfaces {
  radiometry::Band band;
  radiometry::Surface assumed;     ///< of everything in the film, so far
  std::vector<double> emissivity;  ///< of every material; empty: nothing is known of them
};

/// Maps in kelvin that were made as if everything were the assumed surface, as each grain's own material shows them: its pixels' mean, and
/// what varies about it by the slope of Planck's law there. A pixel belongs to the grain that covers its middle, and those just beyond a rim
/// to the nearest grain; the rest stays as it is. Maps are unchanged where materials are as assumed.
void see_surfaces(LockinMaps& maps, const PictureGrains& grains, const GrainSurfaces& surfaces);

}  // namespace arenite::thermography
