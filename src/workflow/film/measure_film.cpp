#include "workflow/film/measure_film.hpp"

#include <fmt/core.h>

#include <optional>
#include <tuple>

#include "core/mapped.hpp"
#include "model/film_place.hpp"
#include "model/lockin_maps.hpp"
#include "thermal/imaging/settled_walls.hpp"
#include "thermal/inference/film_doubts.hpp"
#include "thermal/inference/film_forces.hpp"
#include "thermal/inference/stress_errors.hpp"
#include "thermal/thermography/blank_frames.hpp"
#include "thermal/thermography/film_checks.hpp"
#include "thermal/thermography/grains/follow_grains.hpp"
#include "thermal/thermography/grains/grain_means.hpp"
#include "thermal/thermography/grains/grain_places.hpp"
#include "thermal/thermography/grains/halo.hpp"
#include "thermal/thermography/phase_pictures.hpp"
#include "workflow/film/film_correction.hpp"
#include "workflow/film/film_grains.hpp"

namespace arenite::workflow {
namespace {

class Measurement {
 public:
  Measurement(const recipe::FilmRecipe& recipe, const FilmRunOptions& options, FilmSource& source)
      : recipe_(recipe),
        options_(options),
        source_(source) {}

  /// False if it was stopped.
  bool run(FilmResult& r) {
    r.film = source_.info();
    r.film.time.clear();
    r.pixel = place_.pixel;
    r.origin = place_.origin;
    const auto made = make_correction(recipe_, source_);
    for (const auto& note : made.notes) options_.notice(note);
    r.bad = made.bad;
    r.film.quantity = FilmQuantity::kelvin;
    thermography::CorrectedFilm film(source_, made.correction);
    if (!lock_in(film, r) || !find(film, r)) return false;
    thermography::refuse_wrong_phase(r.maps, recipe_.lockin.phase);
    for (LockinMaps* maps : {&r.maps, &wider_, &scattered_}) thermography::see_surfaces(*maps, loaded_, made.surfaces);
    return measure(r);
  }

 private:
  thermography::LockinOptions lockin_options(const char* name, std::size_t stage) const {
    const auto progress = [this, name, stage](double share) {
      options_.progress({stage, 5, name, share, 0, 0, false, false});
      return !options_.asked_to_stop();
    };
    thermography::LockinOptions o = recipe_.lockin.options();
    o.convention = AmplitudeConvention::peak_to_peak;
    o.threads = options_.threads;
    o.progress = progress;
    return o;
  }

  bool lock_in(FilmSource& film, FilmResult& r) {
    const auto options = lockin_options("lock-in", 1);
    r.maps = recipe_.lockin.method == recipe::LockinSection::Method::nearest_bin
                 ? thermography::nearest_bin_transform(film, options)
                 : thermography::lock_in(film, options);
    if (r.maps.size() == 0) return false;
    if (!r.maps.blank.empty()) options_.notice(thermography::blank_frames_sentence(r.maps.blank));
    thermography::refuse_without_load(r.maps, recipe_.lockin.frequency);
    thermography::refuse_impossible(r.maps);
    return true;
  }

  bool find(FilmSource& film, FilmResult& r) {
    const auto pictures = thermography::phase_pictures(film, r.maps, lockin_options("pictures", 2));
    if (pictures.size() == 0) return false;
    const LockinMaps still = r.maps;
    find(pictures, r);
    // Of the two opposite phases only pixels inside of grains that are followed show which is that of the largest load.
    if (recipe_.lockin.phase || !thermography::are_opposite(r.maps.reference_phase, still.reference_phase)) return true;
    r.maps = still;
    r.maps.reference_phase = thermography::opposite(still.reference_phase);
    find(pictures, r);
    return true;
  }

  /// Grains in the picture at the smallest load, and where these are followed.
  void find(const thermography::PhasePictures& pictures, FilmResult& r) {
    const std::size_t smallest = thermography::picture_at_smallest_load(pictures, r.maps.reference_phase);
    r.picture = thermography::picture_of(pictures, smallest);
    // The spline's coefficients are the picture with most of the pixels' blur undone: more rims are seen in it.
    const std::vector<float> sharp(pictures.picture(smallest), pictures.picture(smallest) + pictures.pixels());
    std::vector<std::string> notes;
    r.grains = find_film_grains(recipe_, place_, r.film, sharp, r.maps, notes);
    for (const auto& note : notes) options_.notice(note);
    loaded_ = r.grains;
    find_halo(pictures, r);
    if (recipe_.lockin.motion) follow(pictures, r);
    else if (r.halo.share > 0) {
      scattered_ = r.maps;
      thermography::remove_halo({r.halo.share, r.halo.width, r.halo.error}, r.maps);
    }
  }

  /// As given, or as the grains show it.
  void find_halo(const thermography::PhasePictures& pictures, FilmResult& r) const {
    thermography::Halo halo{recipe_.forces.halo.value_or(0), recipe_.forces.halo_width, 0};
    if (!recipe_.forces.halo) halo = thermography::halo_of(pictures, r.grains, r.maps.reference_phase);
    r.halo = {halo.share, halo.error, halo.width, 0};
  }

  /// Fits the grains' motion and locks in where they are. Grains are found at the smallest load; in the middle of the
  /// cycle they are half their travel further. The largest amplitude is that of the largest load: contacts are as they
  /// are then, so the maps show the grains there.
  void follow(const thermography::PhasePictures& seen, FilmResult& r) {
    PictureGrains middle = r.grains;
    const auto followed = [&](const thermography::PhasePictures& pictures, double blur) {
      return thermography::follow_grains(pictures, r.maps, middle, r.motion, loaded_, options_.threads,
                                         recipe_.lockin.phase, blur);
    };
    std::optional<thermography::PhasePictures> bare;
    if (r.halo.share > 0) {
      fit_motion(seen, r, middle);
      scattered_ = followed(seen, recipe_.forces.blur);
      thermography::remove_halo({r.halo.share, r.halo.width, r.halo.error}, bare.emplace(seen));
    }
    const thermography::PhasePictures& pictures = bare ? *bare : seen;
    fit_motion(pictures, r, middle);
    const bool rims_show_it = thermography::is_seen(r.motion);
    if (!rims_show_it) move_with_wall(r, middle);
    wider_ = followed(pictures, recipe_.forces.blur + blur_step);
    if (rims_show_it) r.rim_blur = thermography::rim_blur(pictures, middle, r.motion, options_.threads);
    r.maps = followed(pictures, recipe_.forces.blur);
  }

  void fit_motion(const thermography::PhasePictures& pictures, FilmResult& r, PictureGrains& middle) {
    r.motion = thermography::motion_from_smallest(pictures, r.grains, r.maps.reference_phase, middle, options_.threads);
    unseen_ = thermography::settle_lost(r.grains, r.maps.reference_phase, r.motion);
    if (!unseen_.empty()) middle = thermography::moved(r.grains, r.motion, r.maps.reference_phase, 0.5);
    loaded_ = thermography::moved(r.grains, r.motion, r.maps.reference_phase, 1);
  }

  /// Of grains whose rims have no contrast nothing is seen of their motion: they go with the lower wall.
  void move_with_wall(FilmResult& r, PictureGrains& middle) {
    const double largest = r.maps.reference_phase, height = recipe_.container.height;
    const auto heights = mapped(r.grains.centre, [&](Vec2 centre) { return place_.metres(centre).y / height; });
    r.motion = thermography::motion_with_wall(heights, recipe_.container.travel / place_.pixel, largest);
    middle = thermography::moved(r.grains, r.motion, largest, 0.5);
    loaded_ = thermography::moved(r.grains, r.motion, largest, 1);
    options_.notice(
        fmt::format("the rims of the grains have no contrast, so that their motion is not seen; they are taken to move "
                    "with the lower wall, by container.travel ({:.3g} mm)",
                    1e3 * recipe_.container.travel));
  }

  bool measure(FilmResult& r) {
    options_.progress({3, 5, "grains", 0, 0, 0, false, false});
    const thermography::GrainMeanOptions means{recipe_.forces.central_share,
                                               mapped(recipe_.materials, &recipe::FilmMaterial::thermoelastic_factor)};
    // Places at the largest load are those found plus all of the way that was fitted.
    const PictureGrains uncertain = thermography::with_errors_of_way(loaded_, r.motion);
    r.peak_to_peak = thermography::grain_means(r.maps, uncertain, means);
    if (wider_.size() > 0)
      inference::add_blur_error(r.peak_to_peak, thermography::grain_means(wider_, uncertain, means), blur_step,
                                inference::blur_error(r.rim_blur, recipe_.forces.blur));
    if (scattered_.size() > 0) inference::add_halo_error(r, thermography::grain_means(scattered_, uncertain, means));
    if (const std::size_t lost = thermography::forget_lost(r.motion, r.peak_to_peak); lost > 0)
      options_.notice(fmt::format(
          "the motion of {} of {} grains is not visible well enough in the film; their stress is unknown, and "
          "forces on them are what their neighbours and balance make them",
          lost, r.motion.size()));
    r.packing.materials = materials_of(recipe_);
    start_ = imaging::settle_walls(containers(), loaded_, place_, r);
    r.packing.grains = in_metres(loaded_, place_);
    if (recipe_.forces.from != recipe::ForcesSection::From::none) inference::infer_film_forces(forces(), start_, r);
    inference::add_fit_error(r, loaded_, recipe_.forces.central_share);
    inference::add_factor_error({recipe_.forces.factor_error, fits_factors(), recipe_.container.load_peak_to_peak > 0},
                                r);
    r.doubts = inference::film_doubts(given(), r);
    r.doubts.insert(r.doubts.begin(), r.maps.disturbances.begin(), r.maps.disturbances.end());
    for (const auto& doubt : r.doubts) options_.notice(doubt);
    options_.progress({3, 5, "grains", 1, 0, 0, false, false});
    return !options_.asked_to_stop();
  }

  // What the recipe says, as those who infer from a film take it.

  bool fits_factors() const { return recipe_.forces.factors == recipe::ForcesSection::Factors::fit; }

  imaging::FilmContainers containers() const {
    const bool moves = recipe_.lockin.motion;
    return {container_at(recipe_, 0), container_at(recipe_, moves ? 1 : 0), moves, recipe_.container.travel};
  }

  inference::FilmForcesGiven forces() const {
    const auto& [container, f] = std::tie(recipe_.container, recipe_.forces);
    return {.from_pixels = f.from == recipe::ForcesSection::From::pixels,
            .load_peak_to_peak = container.load_peak_to_peak,
            .load_error = container.load_error,
            .blur = f.blur,
            .grains_move = recipe_.lockin.motion,
            .friction = f.friction,
            .state = f.state,
            .factor_error = f.factor_error,
            .fits_factors = fits_factors(),
            .threads = options_.threads,
            .unseen = unseen_};
  }

  inference::FilmGiven given() const {
    const auto& [container, f] = std::tie(recipe_.container, recipe_.forces);
    return {.phase = recipe_.lockin.phase,
            .diffusivity = recipe_.lockin.diffusivity,
            .load_peak_to_peak = container.load_peak_to_peak,
            .load_error = container.load_error,
            .factor_error = f.factor_error,
            .fits_factors = fits_factors(),
            .blur = f.blur,
            .halo = f.halo.has_value(),
            .height = container.height,
            .travel = container.travel,
            .left = container.left.has_value(),
            .top = container.top.has_value()};
  }

  const recipe::FilmRecipe& recipe_;
  const FilmRunOptions& options_;
  FilmSource& source_;
  FilmPlace place_ = place_of(recipe_, source_.info());
  static constexpr double blur_step = 0.1;  // pixels
  LockinMaps wider_;                        ///< with rims taken off as a lens blurred by a step more shows them
  LockinMaps scattered_;                    ///< with the halo left in; empty where there is none
  Domain start_;                            ///< the container at the smallest load
  PictureGrains loaded_;                    ///< at the largest load
  std::vector<double> unseen_;              ///< errors of their places, where the motion of some is lost
};

}  // namespace

bool measure_film(const recipe::FilmRecipe& recipe, const FilmRunOptions& options, FilmSource& film,
                  FilmResult& result) {
  return Measurement(recipe, options, film).run(result);
}

}  // namespace arenite::workflow
