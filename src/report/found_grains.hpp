#pragma once
#include <string>
#include <vector>

#include "core/vec.hpp"
#include "io/image/image.hpp"
#include "thermal/imaging/circles.hpp"
#include "workflow/film/grain_pictures.hpp"

namespace arenite::report {

/// Grains found in a picture, and how their places count.
struct FoundGrains {
  const imaging::FoundCircles& found;
  const workflow::GrainPicture& picture;
  double pixel = 0;                    ///< width of a pixel on the sample, m; 0: not known, lengths are in pixels
  Vec2 corner;                         ///< pixel (column, row) from which x counts to the right and y up
  std::vector<std::string> materials;  ///< names, darkest first; empty: "class1", "class2", ... where there are several
  std::string file;
};

/// Table id, x, y, radius, material (read by packing.method = "file" and `measure`), with standard errors, brightness
/// and score; lengths in mm, or in pixels where a pixel's width is not known.
std::string grains_csv(const FoundGrains& grains);
std::string grains_text(const FoundGrains& grains);
std::string grains_json(const FoundGrains& grains);

/// The picture in grey with the grains' circles on it, coloured by material; small pictures are drawn up to four times
/// as large.
io::ColourPicture grains_overlay(const FoundGrains& grains);

}  // namespace arenite::report
