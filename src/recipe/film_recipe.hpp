#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/parameters.hpp"
#include "io/film/film.hpp"
#include "recipe/document.hpp"
#include "recipe/film_keys.hpp"
#include "recipe/record.hpp"
#include "thermal/camera/camera.hpp"
#include "thermal/imaging/circles.hpp"
#include "thermal/thermography/lockin.hpp"
#include "thermal/thermography/step/step_load.hpp"

namespace arenite::recipe {

/// A material as a camera sees it.
struct FilmMaterial {
  std::string name;
  double thermoelastic_factor = 0;        ///< A, K/Pa
  double brightness = 0;                  ///< in the picture that grains are found in; only the order counts
  std::optional<double> emissivity = {};  ///< in the camera's band; unless given, that of [temperature]
  double stiffness = 0;                   ///< of its contacts, N/m; 0: not known, alike for all
};

/// The container that holds the grains; walls are contact partners and carry the load.
struct FilmContainer {
  double width = 0, height = 0, thickness = 0;  ///< m
  std::optional<double> left, top;  ///< its inner upper left corner in the picture, pixels; centred if not given
  double load_peak_to_peak = 0;     ///< force on the lower wall, largest less smallest, N; 0: not known
  double load_error = 0.005;        ///< standard error of that force, relative
  double travel = 0;                ///< of the lower wall, upwards, from the smallest to the largest load, m
};

struct PictureSection {
  double pixel = 0;           ///< m
  std::string grains;         ///< CSV of hand-made positions; empty: found by program
  std::string optical;        ///< picture of an ordinary camera for materials; empty: the film's own frames
  double optical_pixel = 0;   ///< m; 0: as `pixel`
  std::vector<double> radii;  ///< size classes, m; empty: found
  imaging::GrainContrast contrast = imaging::CircleOptions{}.contrast;
  double least_score = imaging::CircleOptions{}.least_score;  ///< share of a rim that must show
};

struct CorrectionSection {
  std::string cold, warm;                             ///< films of a black-body reference, for offsets, and gains
  double cold_temperature = 0, warm_temperature = 0;  ///< K
  bool bad_pixels = true;
};

struct TemperatureSection {
  enum class From { references, radiometry, curve, film };
  From from = From::references;
  std::string curve;                 ///< CSV of level and temperature
  std::optional<double> emissivity;  ///< of materials that do not say theirs; radiometry::usual_emissivity unless given
  std::optional<double> ambient;     ///< of what grains mirror, K; radiometry::Surface has it unless given
  std::optional<double> assumed_emissivity;  ///< that the temperatures of a film in kelvin were made with
  std::vector<double> band;  ///< shortest and longest wavelength, m; empty: what the film says, or radiometry::Band
};

struct LockinSection {
  enum class Method { least_squares, nearest_bin };
  double frequency = 0;  ///< Hz
  Method method = Method::least_squares;
  std::int64_t drift = thermography::LockinOptions{}.drift_order, harmonics = thermography::LockinOptions{}.harmonics;
  std::optional<double> phase;  ///< when the load is largest, rad after the first frame; found on the film if not given
  bool motion = true;           ///< grains' motion is fitted and taken out
  double diffusivity = 1e-7;    ///< of heat in the grains, m^2/s, about that of plastics
  thermography::LockinOptions options() const;
};

/// A step of the load, as its film is measured alone.
struct StepSection {
  std::optional<double> time;  ///< of its middle, s after the first frame
  double rise = thermography::StepOptions{}.rise, window = thermography::StepOptions{}.window;  ///< s
  std::int64_t drift = thermography::StepOptions{}.drift_order;
  thermography::StepOptions options() const;
};

/// What the film that a command or a call opens does not say about itself, under [film] as in its recipe.
struct FilmSection {
  std::optional<io::FilmChoice> film;
};

/// The lock-in of a film alone: with the pixel of [picture], for the adiabatic check, and how its maps are given.
struct LockinAlone : LockinSection {
  std::optional<double> pixel;
  AmplitudeConvention convention = AmplitudeConvention::amplitude;
  bool refine = true;
  thermography::LockinOptions options() const;
};

struct ForcesSection {
  enum class From { pixels, means, none };
  From from = From::pixels;
  double central_share = 0.5;  ///< of a grain's area, for its mean
  double blur = 0.5;           ///< of the lens, pixels
  std::optional<double> halo;  ///< share of the light that is scattered; found on the film if not given
  double halo_width = 4;       ///< of a halo that is given, pixels
  enum class Factors { given, fit };
  Factors factors = Factors::given;
  double factor_error = 0.02;  ///< standard error of the factors as given, relative, with what acts like them
  double friction = 0.3;
  bool state = false;  ///< the film shows a state (from no load) and no difference: the friction cone holds
};

/// A simulation of the same packing, from the positions found.
struct SimulationSection {
  std::string recipe;     ///< of the packing
  std::string low, high;  ///< stages whose ends are the smallest and the largest load
};

/// Which states a virtual camera films, and how.
struct CameraSection {
  std::string low, high;  ///< stages; without `low` the load varies from none
  camera::Parameters parameters;
  std::int64_t reference_frames = 100;                ///< in each film of a black-body reference
  double reference_cold = 291, reference_warm = 301;  ///< K
};

/// The film that is measured, and what it does not say about itself, or says wrongly.
struct MeasuredFilm : io::FilmChoice {
  std::string file;  ///< empty: the command or the call names it
  bool operator==(const MeasuredFilm&) const = default;
};

/// What `arenite film` and `arenite camera` are given; one file may serve both.
struct FilmRecipe {
  std::string title;
  std::uint64_t seed = 1;
  std::string source_file;
  std::vector<std::string> notices;  ///< what the reader of the recipe found worth a word
  std::optional<MeasuredFilm> film;
  std::vector<FilmMaterial> materials;
  FilmContainer container;
  PictureSection picture;
  CorrectionSection correction;
  TemperatureSection temperature;
  LockinSection lockin;
  ForcesSection forces;
  std::optional<SimulationSection> simulation;
  std::optional<CameraSection> camera;
  std::filesystem::path beside(const std::string& file) const {
    return std::filesystem::path(source_file).parent_path() / file;
  }  ///< that it names
  /// What films are opened with.
  io::FilmChoice choice() const { return film.value_or(MeasuredFilm{}); }
  /// The film that it names. Throws InputError where it names none.
  std::filesystem::path film_named() const;
};

/// Emissivity of every material: its own, that of [temperature], or the usual one.
std::vector<double> emissivities(const FilmRecipe& recipe);

/// False where temperatures are to come from the two black-body references (the default) and these are not given.
bool has_references(const FilmRecipe& recipe);
inline constexpr const char* needs_references =
    "from is \"references\" unless given, and needs correction.cold, correction.warm and their temperatures, the "
    "second above the first; give them, or write [temperature] with from = \"film\" (it holds temperatures), \"curve\" "
    "or \"radiometry\"";

/// Of a film in kelvin of which nothing says how these were made.
inline constexpr const char* unread_emissivity =
    "emissivity, ambient and band are not used if the film already holds temperatures, unless the emissivity assumed "
    "in them is known; give temperature.assumed_emissivity (1 if they are those of a black body), or remove them";

/// Whether this text is meant for `arenite film` or `arenite camera`, and not for a simulation; false for what is not
/// TOML.
bool describes_film(std::string_view text);

/// The same of a recipe's tree.
bool describes_film(const Node& root);

/// As read_recipe (recipe/recipe.hpp), for films.
FilmRecipe read_film_recipe(const std::string& file, const std::vector<std::string>& overrides = {});
FilmRecipe parse_film_recipe(std::string_view text, const std::string& file_name,
                             const std::vector<std::string>& overrides = {});
FilmRecipe film_recipe_from(const Node& root, const std::string& file);
const RecordTable& film_keys();
std::string to_toml(const FilmRecipe& recipe);
std::string to_commented_toml(const FilmRecipe& recipe);
std::string changed_keys(const FilmRecipe& recipe);

/// Documentation of every key (Markdown).
std::string film_key_reference();

/// The recipe that `arenite init film` writes.
FilmRecipe film_template();

}  // namespace arenite::recipe
