#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/vec.hpp"
#include "io/image/image.hpp"
#include "model/film.hpp"
#include "model/image.hpp"
#include "model/packing.hpp"
#include "recipe/film_recipe.hpp"
#include "thermal/imaging/circles.hpp"

namespace arenite::workflow {

/// The one place where rows that point down become heights: pixels of a film as metres from the container's lower left inner corner at the smallest load.
struct FilmPlace {
  Vec2 origin;       ///< centre of the upper left pixel, m
  double pixel = 1;  ///< m
  Vec2 metres(double column, double row) const { return {origin.x + column * pixel, origin.y - row * pixel}; }
  double column(double x) const { return (x - origin.x) / pixel; }
  double row(double y) const { return (origin.y - y) / pixel; }
};

/// Where the recipe says the container is in the picture, or in its middle.
FilmPlace place_of(const recipe::FilmRecipe& recipe, const FilmInfo& film);

/// The container when the load has gone this share from its smallest to its largest; the lower wall has travelled so far.
Domain container_at(const recipe::FilmRecipe& recipe, double share);

/// Materials of the recipe, with what a film does not know left 0.
Materials materials_of(const recipe::FilmRecipe& recipe);

/// Grains of a picture in metres, numbered from 1.
Grains in_metres(const PictureGrains& grains, const FilmPlace& place);

/// Grains at the smallest load, in the film's pixels, with materials as the recipe numbers them: hand-made (picture.grains), or found in the optical
/// picture and laid over the film, or found in `frame`, the film's own picture at that load (K or levels, rows from the top). `notes` gets what a
/// user should know. Throws InputError where there are no grains, or as many brightnesses as materials cannot be told apart.
PictureGrains find_film_grains(const recipe::FilmRecipe& recipe, const FilmPlace& place, const FilmInfo& film, const std::vector<float>& frame,
                               std::vector<std::string>& notes);

/// Grains found in an ordinary camera's picture of the sample at the smallest load (picture.optical) and carried to where `frame`, the film's own
/// picture at that load, shows them; in the film's pixels, with brightnesses of the optical picture and no materials. Both pictures nearly have the
/// same middle (8 pixels of the film, 2 degrees); one that lies elsewhere is laid on grains that the film itself shows. `notes` gets how the pictures
/// lie. Throws InputError where there are no grains or they fit nowhere.
PictureGrains optical_grains(const recipe::FilmRecipe& recipe, const FilmInfo& film, const std::vector<float>& frame, std::vector<std::string>& notes);

/// Materials of grains by their brightness, parted into as many classes as the recipe has materials; `where` names the picture in
/// the InputError for one that cannot be parted.
void take_materials(const recipe::FilmRecipe& recipe, const std::string& where, PictureGrains& grains);

/// Circles of the recipe's radii; those of one class have one radius, which their mean gives better than each by itself. `pixel` of the picture in m.
imaging::FoundCircles circles_of(const recipe::FilmRecipe& recipe, const FloatImage& picture, double pixel, imaging::CircleOptions options = {});

/// What of a file is looked at for grains.
struct PictureChoice {
  std::optional<std::int64_t> frame = {};   ///< of a film, from 0; none: the mean of all frames
  io::Channel channel = io::Channel::grey;  ///< of a coloured picture
  std::string dataset = {};                 ///< of an HDF5 file
};

/// A picture to find grains in.
struct GrainPicture {
  FloatImage image;
  std::int64_t frames = 1;   ///< that it is the mean of
  std::size_t replaced = 0;  ///< bad pixels that stand replaced by good neighbours
  bool film = false;
};

/// Reads a picture or a film; in a film bad pixels (by level, and by noise from eight frames on) are replaced. InputError
/// for a file that is neither, or a frame that the film does not hold.
GrainPicture read_grain_picture(const std::filesystem::path& path, const PictureChoice& choice = {});

}  // namespace arenite::workflow
