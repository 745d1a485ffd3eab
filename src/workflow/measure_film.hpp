#pragma once
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/vec.hpp"
#include "io/film/film.hpp"
#include "io/image/image.hpp"
#include "model/film.hpp"
#include "model/film_result.hpp"
#include "model/image.hpp"
#include "model/packing.hpp"
#include "recipe/film_recipe.hpp"
#include "recipe/recipe.hpp"
#include "thermal/imaging/circles.hpp"
#include "thermal/thermography/correction.hpp"
#include "thermal/thermography/lockin.hpp"
#include "workflow/run_film.hpp"

namespace arenite::workflow {

/// What is done to a film before it is looked at, as its recipe says.
struct FilmCorrection {
  thermography::Correction correction;
  std::vector<std::uint8_t> bad;  ///< 1 for pixels that are replaced
  thermography::GrainSurfaces
      surfaces;  ///< what is left to do where materials are known: their emissivities, if these differ
  std::vector<std::string> notes;  ///< what a user should know: constant or saturated pixels
};

/// Reads references and curve, and looks at the film's first frames for bad pixels. Throws InputError for references of
/// another size and films that do not hold what [temperature] says.
FilmCorrection make_correction(const recipe::FilmRecipe& recipe, FilmSource& film);

/// The load's cycle from the lock-in line of a .ptw film; nothing for films without. `notice` is called where the line
/// shows no cycle near the given frequency, or another one.
std::optional<thermography::LoadSignal> load_signal_of(const std::filesystem::path& path, const FilmInfo& film,
                                                       double given,
                                                       const std::function<void(const std::string&)>& notice);

/// Puts the walls of `result` where the rims of grains show them: the container as a whole goes to its place in the
/// film (`place`), and what is left to single sides. `loaded` are the grains at the largest load. The container at the
/// smallest load.
Domain settle_walls(const recipe::FilmRecipe& recipe, const PictureGrains& loaded, FilmPlace& place,
                    FilmResult& result);

/// Proposes contacts between the grains of `result.packing` and infers their forces from its maps, or from the means of
/// grains, as the recipe's [forces] says. Contacts are proposed where grains touch at the largest or at the smallest
/// load (`result.grains`, in the container `start`): one that opens on the way loses its force.
void infer_film_forces(const recipe::FilmRecipe& recipe, const Domain& start, FilmResult& result);

/// Adds to the errors of the stresses what a blur of the lens that is known to `blur_error` only leaves; `wider` are
/// the stresses when rims are taken off with a blur larger by `step` (pixels).
void add_blur_error(PeakToPeak& change, const PeakToPeak& wider, double step, double blur_error);

/// Adds to the errors of the stresses what is not known of the halo that was taken off; `scattered` are the stresses
/// with it, and what it costs goes to `result.halo`.
void add_halo_error(FilmResult& result, const PeakToPeak& scattered);

/// Adds to the errors of the stresses that of the thermoelastic factors: the recipe's, or where forces tell it from the
/// load the fit's own with what is between the fitted factors and the given ones. With forces.factors = "fit" stresses
/// are first those of the fitted factors.
void add_factor_error(const recipe::FilmRecipe& recipe, FilmResult& result);

/// Adds what noise does not explain, once the forces are known: the mean over a grain's centre differs from the mean
/// that the forces (held by the balance of all grains) put there, seen through the same lens and pixels. The median
/// difference of the grains of a material is the error of all of them that rim, motion and the camera's fixed pattern
/// leave; a grain whose own difference is larger than that is less sure. `shown` are the grains in the maps' pixels,
/// `share` the part averaged.
void add_fit_error(FilmResult& result, const PictureGrains& shown, double share);

/// Measures a film: correction, lock-in, grains in the picture, their motion, stresses and contact forces, into
/// `result`. False if it was stopped. Throws InputError, without the film's name, for what the recipe and the film do
/// not allow.
bool measure_film(const recipe::FilmRecipe& recipe, const FilmRunOptions& options, FilmSource& film,
                  FilmResult& result);

/// Where the recipe says the container is in the picture, or in its middle.
FilmPlace place_of(const recipe::FilmRecipe& recipe, const FilmInfo& film);

/// The container when the load has gone this share from its smallest to its largest; the lower wall has travelled so
/// far.
Domain container_at(const recipe::FilmRecipe& recipe, double share);

/// Materials of the recipe, with what a film does not know left 0.
Materials materials_of(const recipe::FilmRecipe& recipe);

/// Grains of a picture in metres, numbered from 1.
Grains in_metres(const PictureGrains& grains, const FilmPlace& place);

/// Grains at the smallest load, in the film's pixels, with materials as the recipe numbers them: hand-made
/// (picture.grains), or found in the optical picture and laid over the film, or found in `frame`, the film's own
/// picture at that load (K or levels, rows from the top). An optical picture is laid over the amplitudes of `maps`
/// where the frame has no contrast. `notes` gets what a user should know. Throws InputError where there are no grains,
/// or as many brightnesses as materials cannot be told apart.
PictureGrains find_film_grains(const recipe::FilmRecipe& recipe, const FilmPlace& place, const FilmInfo& film,
                               const std::vector<float>& frame, const LockinMaps& maps,
                               std::vector<std::string>& notes);

/// Grains found in an ordinary camera's picture of the sample at the smallest load (picture.optical) and carried to
/// where `frame`, the film's own picture at that load, shows them; in the film's pixels, with brightnesses of the
/// optical picture and no materials. Both pictures nearly have the same middle (8 pixels of the film, 2 degrees); one
/// that lies elsewhere is laid on grains that the film itself shows. A frame without contrast says nothing of grains,
/// which then are where pixels warm with the load (`maps`), moved as far as container.travel says. `notes` gets how the
/// pictures lie. Throws InputError where there are no grains or they fit nowhere.
PictureGrains optical_grains(const recipe::FilmRecipe& recipe, const FilmPlace& place, const FilmInfo& film,
                             const std::vector<float>& frame, const LockinMaps& maps, std::vector<std::string>& notes);

/// Materials of grains by their brightness, parted into as many classes as the recipe has materials; `where` names the
/// picture in the InputError for one that cannot be parted.
void take_materials(const recipe::FilmRecipe& recipe, const std::string& where, PictureGrains& grains);

/// Circles of the recipe's radii; those of one class have one radius, which their mean gives better than each by
/// itself. `pixel` of the picture in m.
imaging::FoundCircles circles_of(const recipe::FilmRecipe& recipe, const FloatImage& picture, double pixel,
                                 imaging::CircleOptions options = {});

/// A picture to find grains in.
struct GrainPicture {
  FloatImage image;
  std::int64_t frames = 1;   ///< that it is the mean of
  std::size_t replaced = 0;  ///< bad pixels that stand replaced by good neighbours
};

/// Reads a picture or a film, whose frames are the choice's slices; without one it is the mean of all. In a film bad
/// pixels (by level, and by noise from eight frames on) are replaced. InputError for a file that is neither, or a frame
/// that the film does not hold.
GrainPicture read_grain_picture(const std::filesystem::path& path, const io::ImageChoice& choice);

/// Throws InputError if the film's levels cannot become temperatures in the way that the recipe says.
void refuse_temperatures(const recipe::FilmRecipe& recipe, const std::filesystem::path& path, const FilmInfo& film);

/// What to say of maps that show no load, a film without one or at a wrong frequency; `given_by` is the key or option
/// that gives it.
std::string no_load_sentence(const LockinMaps& maps, double frequency, std::string_view given_by);

/// Throws InputError if the maps hold nothing but noise, or a line of the camera.
void refuse_without_load(const LockinMaps& maps, double given_frequency);

/// When the film itself says that the load is largest, against what the recipe gives, in cycles from -0.5 to 0.5. A
/// signal that heat does not blur is in phase with the load everywhere; of the two ends the film takes that at which
/// pixels warm.
double phase_off(const LockinMaps& maps, double given_cycles);

/// Throws InputError for maps that cannot be those of a load: values that are no temperatures, amplitudes of kelvins.
void refuse_impossible(const LockinMaps& maps);

/// Throws InputError where the recipe gives a phase that is off by an eighth of a cycle or more. Judged where grains
/// have been followed: before that, rims that move past pixels speak louder than the load.
void refuse_wrong_phase(const recipe::FilmRecipe& recipe, const LockinMaps& maps);

/// What the forces and the film say against what was given beside them, one sentence each with the likely causes:
/// phase, factors of the materials one against another, the scale of temperatures and forces against the load, and what
/// the fit leaves. Throws InputError where they have nothing to do with each other.
std::vector<std::string> film_doubts(const recipe::FilmRecipe& recipe, const FilmResult& result);

}  // namespace arenite::workflow
