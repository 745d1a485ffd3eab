#include <filesystem>

#include "io/results/groups.hpp"
#include "io/results/results.hpp"
#include "model/grain_motion.hpp"
#include "model/lockin_maps.hpp"

namespace arenite::io {
namespace {

constexpr Column<PictureGrains> grain_columns[] = {{"column", "1", &PictureGrains::centre, &Vec2::x},
                                                   {"row", "1", &PictureGrains::centre, &Vec2::y},
                                                   {"radius", "1", &PictureGrains::radius},
                                                   {"position_error", "1", &PictureGrains::position_error},
                                                   {"radius_error", "1", &PictureGrains::radius_error},
                                                   {"brightness", "1", &PictureGrains::brightness},
                                                   {"score", "1", &PictureGrains::score}};

constexpr Column<GrainMotion> motion_columns[] = {{"cos_x", "1", &GrainMotion::cosine, &Vec2::x},
                                                  {"sin_x", "1", &GrainMotion::sine, &Vec2::x},
                                                  {"cos_y", "1", &GrainMotion::cosine, &Vec2::y},
                                                  {"sin_y", "1", &GrainMotion::sine, &Vec2::y},
                                                  {"error", "1", &GrainMotion::error}};

constexpr Column<PeakToPeak> peak_to_peak_columns[] = {{"temperature", "K", &PeakToPeak::temperature},
                                                       {"sigma_hyd", "Pa", &PeakToPeak::sigma_hyd},
                                                       {"error", "Pa", &PeakToPeak::error},
                                                       {"pixels", "1", &PeakToPeak::pixels}};

constexpr Column<FilmSimulation> simulation_columns[] = {{"peak_to_peak", "Pa", &FilmSimulation::peak_to_peak},
                                                         {"state", "Pa", &FilmSimulation::state}};

void transfer_film(const Hdf5Group& at, FilmResult& r) {
  const auto group = at.group("film");
  group("width", r.film.width);
  group("height", r.film.height);
  group("frames", r.film.frames);
  group("frame_rate [1/s]", r.film.frame_rate);
  group("integration [s]", r.film.integration);
  group("format", r.film.format);
  group.choice("unit", r.film.quantity, FilmQuantity::digital_level, "level", FilmQuantity::kelvin, "K");
  group("camera", r.film.camera);
  group("pixel [m]", r.pixel);
  group("origin_x [m]", r.origin.x);
  group("origin_y [m]", r.origin.y);
  if (!at.reads()) return;
  constexpr int largest = 1 << 16;
  if (r.film.width < 0 || r.film.height < 0 || r.film.width > largest || r.film.height > largest)
    group.refuse("has an impossible size");
  r.maps.width = r.film.width;
  r.maps.height = r.film.height;
}

void transfer_maps(const Hdf5Group& at, FilmResult& r, Shape shape) {
  const auto group = at.group("maps");
  group("frequency [1/s]", r.maps.frequency);
  group("frequency_error [1/s]", r.maps.frequency_error);
  group("reference_phase [rad]", r.maps.reference_phase);
  group("frames", r.maps.frames);
  group.choice("convention", r.maps.convention, AmplitudeConvention::peak_to_peak,
               name_of(AmplitudeConvention::peak_to_peak), AmplitudeConvention::amplitude,
               name_of(AmplitudeConvention::amplitude));
  group.optional_image("picture", r.picture, shape, "K");
  group.optional_image("bad", r.bad, shape);
  for (const auto& [name, unit, values] : lockin_maps)
    if (values != &LockinMaps::noise_floor)
      group.optional_image(name, r.maps.*values, shape, unit);  // which follows from the standard error
}

void transfer_forces(const Hdf5Group& at, FilmResult& r, Shape shape) {
  const auto group = at.group("forces");
  group.array("fn_error", r.fn_error, "N");
  group.array("ft_error", r.ft_error, "N");
  group.array("presence", r.presence);
  for (const auto* of_contacts : {&r.fn_error, &r.ft_error, &r.presence})
    if (!of_contacts->empty()) group.same_length({of_contacts->size(), r.packing.contacts.size()});
  group("proposed", r.fit.proposed);
  group("present", r.fit.present);
  group("present_error", r.fit.present_error);
  group("over_noise", r.fit.over_noise);
  group("over_signal", r.fit.over_signal);
  group("model_error", r.fit.model_error);
  group("load [N]", r.fit.load);
  group.array("factor_scale", r.fit.factor_scale);
  group.array("factor_scale_error", r.fit.factor_scale_error);
  group.same_length({r.fit.factor_scale.size(), r.fit.factor_scale_error.size()});
  group.optional_image("picture", r.fit.picture, shape, "K");
}

void transfer_film_result(const Hdf5Group& at, FilmResult& r) {
  transfer_origin(at, r);
  transfer_film(at, r);
  const Shape shape{r.film.height, r.film.width};
  transfer_maps(at, r, shape);
  transfer_packing(at, r.packing);
  const std::size_t grains = r.packing.grains.size();
  transfer_columns(at.group("grains"), r.grains, grain_columns, grains, true);
  transfer_columns(at.group("motion"), r.motion, motion_columns, grains, true);
  transfer_columns(at.group("peak_to_peak"), r.peak_to_peak, peak_to_peak_columns, grains, true);
  transfer_columns(at.group("simulation"), r.simulation, simulation_columns, grains, true);
  transfer_forces(at, r, shape);
  transfer_numbers(at, "numbers", r.numbers);
}

}  // namespace

void write_film_result(const std::filesystem::path& path, const FilmResult& result) {
  write_result_file(path, "film", transfer_film_result, result);
}

FilmResult read_film_result(const std::filesystem::path& path) {
  FilmResult result = read_result_file(path, "film", transfer_film_result);
  result.grains.material = result.packing.grains.material;
  return result;
}

}  // namespace arenite::io
