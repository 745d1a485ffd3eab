#include "io/numbers_table.hpp"
#include "io/film_result_file.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

#include "io/packing_groups.hpp"
#include "io/result_groups.hpp"
#include "io/sealed_file.hpp"

namespace arenite::io {
namespace {

template <class Owner, class Value>
struct Column {
  const char* name;
  const char* unit;
  std::vector<Value> Owner::*member;
};

constexpr std::array maps{Column<LockinMaps, float>{"mean", "K", &LockinMaps::mean},
                          Column<LockinMaps, float>{"drift", "K/s", &LockinMaps::drift},
                          Column<LockinMaps, float>{"amplitude", "K", &LockinMaps::amplitude},
                          Column<LockinMaps, float>{"phase", "rad", &LockinMaps::phase},
                          Column<LockinMaps, float>{"in_phase", "K", &LockinMaps::in_phase},
                          Column<LockinMaps, float>{"quadrature", "K", &LockinMaps::quadrature},
                          Column<LockinMaps, float>{"standard_error", "K", &LockinMaps::standard_error},
                          Column<LockinMaps, float>{"second_harmonic", "K", &LockinMaps::second_harmonic},
                          Column<LockinMaps, float>{"residual", "K", &LockinMaps::residual}};

constexpr std::array grain_columns{Column<PictureGrains, double>{"column", "1", &PictureGrains::x},
                                   Column<PictureGrains, double>{"row", "1", &PictureGrains::y},
                                   Column<PictureGrains, double>{"radius", "1", &PictureGrains::radius},
                                   Column<PictureGrains, double>{"position_error", "1", &PictureGrains::position_error},
                                   Column<PictureGrains, double>{"radius_error", "1", &PictureGrains::radius_error},
                                   Column<PictureGrains, double>{"brightness", "1", &PictureGrains::brightness},
                                   Column<PictureGrains, double>{"score", "1", &PictureGrains::score}};

constexpr std::array motion_columns{Column<GrainMotion, double>{"cos_x", "1", &GrainMotion::cos_x},
                                    Column<GrainMotion, double>{"sin_x", "1", &GrainMotion::sin_x},
                                    Column<GrainMotion, double>{"cos_y", "1", &GrainMotion::cos_y},
                                    Column<GrainMotion, double>{"sin_y", "1", &GrainMotion::sin_y},
                                    Column<GrainMotion, double>{"error", "1", &GrainMotion::error}};

constexpr std::array swing_columns{Column<GrainSwing, double>{"temperature", "K", &GrainSwing::temperature},
                                   Column<GrainSwing, double>{"sigma_hyd", "Pa", &GrainSwing::sigma_hyd},
                                   Column<GrainSwing, double>{"error", "Pa", &GrainSwing::error},
                                   Column<GrainSwing, double>{"pixels", "1", &GrainSwing::pixels}};

constexpr std::array twin_columns{Column<FilmTwin, double>{"swing", "Pa", &FilmTwin::swing},
                                  Column<FilmTwin, double>{"state", "Pa", &FilmTwin::state}};

template <class Owner, std::size_t n>
void write_columns(const Hdf5Writer& at, const char* name, const Owner& owner, const std::array<Column<Owner, double>, n>& columns) {
  const auto group = at.create_group(name);
  for (const auto& c : columns) group.write(c.name, owner.*c.member, c.unit);
}

/// All columns have `size` values, or none has any.
template <class Owner, std::size_t n>
Owner read_columns(const Hdf5Reader& group, const std::array<Column<Owner, double>, n>& columns, std::size_t size) {
  Owner owner;
  for (const auto& c : columns) {
    owner.*c.member = group.doubles(c.name);
    if (!(owner.*c.member).empty() && (owner.*c.member).size() != size) group.refuse("holds arrays of different lengths");
  }
  return owner;
}

void write_picture(const Hdf5Writer& at, const char* name, const std::vector<float>& values, Hdf5Writer::Shape shape, const char* unit) {
  if (!values.empty()) at.write_image(name, std::vector<double>(values.begin(), values.end()), shape, unit);
}

std::vector<float> read_picture(const Hdf5Reader& at, const char* name, int height, int width) {
  if (!at.has(name)) return {};
  const auto values = at.image(name, height, width);
  return {values.begin(), values.end()};
}

void write_maps(const Hdf5Writer& at, const FilmResult& r) {
  const auto group = at.create_group("maps");
  const Hdf5Writer::Shape shape{r.film.height, r.film.width};
  group.set("frequency [1/s]", r.maps.frequency);
  group.set("frequency_error [1/s]", r.maps.frequency_error);
  group.set("reference_phase [rad]", r.maps.reference_phase);
  group.set("frames", static_cast<std::int64_t>(r.maps.frames));
  group.set("swing", r.maps.convention == SwingConvention::full ? "full" : "half");
  write_picture(group, "picture", r.picture, shape, "K");
  if (!r.bad.empty()) group.write_image("bad", r.bad, shape);
  for (const auto& m : maps) write_picture(group, m.name, r.maps.*m.member, shape, m.unit);
}

void read_maps(const Hdf5Reader& group, FilmResult& r) {
  const int height = r.film.height, width = r.film.width;
  r.maps.width = width;
  r.maps.height = height;
  r.maps.frequency = group.number("frequency [1/s]");
  r.maps.frequency_error = group.number("frequency_error [1/s]");
  r.maps.reference_phase = group.number("reference_phase [rad]");
  r.maps.frames = static_cast<std::size_t>(group.integer("frames"));
  r.maps.convention = group.label("swing") == "full" ? SwingConvention::full : SwingConvention::half;
  r.picture = read_picture(group, "picture", height, width);
  if (group.has("bad")) r.bad = group.image_of_bytes("bad", height, width);
  for (const auto& m : maps) r.maps.*m.member = read_picture(group, m.name, height, width);
}

void write_film(const Hdf5Writer& at, const FilmResult& r) {
  const auto group = at.create_group("film");
  group.set("width", std::int64_t{r.film.width});
  group.set("height", std::int64_t{r.film.height});
  group.set("frames", r.film.frames);
  group.set("frame_rate [1/s]", r.film.frame_rate);
  group.set("integration [s]", r.film.integration);
  group.set("format", r.film.format);
  group.set("unit", r.film.quantity == FilmQuantity::digital_level ? "level" : "K");
  group.set("camera", r.film.camera);
  group.set("pixel [m]", r.pixel);
  group.set("origin_x [m]", r.origin.x);
  group.set("origin_y [m]", r.origin.y);
}

void read_film(const Hdf5Reader& group, FilmResult& r) {
  constexpr std::int64_t largest = 1 << 16;
  const std::int64_t width = group.integer("width"), height = group.integer("height");
  if (width < 0 || height < 0 || width > largest || height > largest) group.refuse("has a size that makes no sense");
  r.film.width = static_cast<int>(width);
  r.film.height = static_cast<int>(height);
  r.film.frames = group.integer("frames");
  r.film.frame_rate = group.number("frame_rate [1/s]");
  r.film.integration = group.number("integration [s]");
  r.film.format = group.label("format");
  r.film.quantity = group.label("unit") == "level" ? FilmQuantity::digital_level : FilmQuantity::kelvin;
  r.film.camera = group.label("camera");
  r.pixel = group.number("pixel [m]");
  r.origin = {group.number("origin_x [m]"), group.number("origin_y [m]")};
}

void write_fit(const Hdf5Writer& group, const FilmResult& r) {
  group.set("proposed", static_cast<std::int64_t>(r.fit.proposed));
  group.set("present", r.fit.present);
  group.set("present_error", r.fit.present_error);
  group.set("over_noise", r.fit.over_noise);
  group.set("over_signal", r.fit.over_signal);
  group.set("model_error", r.fit.model_error);
  group.set("load [N]", r.fit.load);
  group.write("factor_scale", r.fit.factor_scale, "1");
  group.write("factor_scale_error", r.fit.factor_scale_error, "1");
  write_picture(group, "picture", r.fit.picture, {r.film.height, r.film.width}, "K");
}

void read_fit(const Hdf5Reader& group, FilmResult& r) {
  r.fit.proposed = static_cast<std::size_t>(std::max<std::int64_t>(0, group.integer("proposed")));
  r.fit.present = group.number("present");
  r.fit.present_error = group.number("present_error");
  r.fit.over_noise = group.number("over_noise");
  r.fit.over_signal = group.number("over_signal");
  r.fit.model_error = group.number("model_error");
  r.fit.load = group.number("load [N]");
  r.fit.factor_scale = group.doubles("factor_scale");
  r.fit.factor_scale_error = group.doubles("factor_scale_error");
  if (r.fit.factor_scale.size() != r.fit.factor_scale_error.size()) group.refuse("holds arrays of different lengths");
  r.fit.picture = read_picture(group, "picture", r.film.height, r.film.width);
}

}  // namespace

void write_film_result(const std::filesystem::path& path, const FilmResult& result) {
  const Hdf5Writer at;
  write_origin(at, result);
  write_film(at, result);
  write_maps(at, result);
  write_packing(at, result.packing);
  write_columns(at, "grains", result.grains, grain_columns);
  write_columns(at, "motion", result.motion, motion_columns);
  write_columns(at, "swing", result.swing, swing_columns);
  write_columns(at, "twin", result.twin, twin_columns);
  const auto forces = at.create_group("forces");
  forces.write("fn_error", result.fn_error, "N");
  forces.write("ft_error", result.ft_error, "N");
  forces.write("presence", result.presence, "1");
  write_fit(forces, result);
  write_numbers(at, "numbers", result.numbers);
  write_sealed(path, "film", at.bytes());
}

FilmResult read_film_result(const std::filesystem::path& path) {
  const Hdf5Reader at(read_sealed(path, "film"), path.string());
  FilmResult result;
  read_origin(at, result);
  read_film(at.group("film"), result);
  read_maps(at.group("maps"), result);
  result.packing = read_packing(at.group("packing"));
  const std::size_t grains = result.packing.grains.size(), contacts = result.packing.contacts.size();
  result.grains = read_columns(at.group("grains"), grain_columns, grains);
  result.grains.material = result.packing.grains.material;
  result.motion = read_columns(at.group("motion"), motion_columns, grains);
  result.swing = read_columns(at.group("swing"), swing_columns, grains);
  result.twin = read_columns(at.group("twin"), twin_columns, grains);
  const auto forces = at.group("forces");
  result.fn_error = forces.doubles("fn_error");
  result.ft_error = forces.doubles("ft_error");
  result.presence = forces.doubles("presence");
  for (const std::size_t size : {result.fn_error.size(), result.ft_error.size(), result.presence.size()})
    if (size != 0 && size != contacts) forces.refuse("holds arrays of different lengths");
  read_fit(forces, result);
  result.numbers = read_numbers(at, "numbers");
  return result;
}

}  // namespace arenite::io
