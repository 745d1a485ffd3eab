#include "io/numbers_table.hpp"
#include "io/field_file.hpp"

#include <array>

#include "core/error.hpp"
#include "io/packing_groups.hpp"
#include "io/result_groups.hpp"
#include "io/sealed_file.hpp"

namespace arenite::io {
namespace {

struct Component {
  const char* name;
  const char* unit;
  std::vector<double> StressField::*member;
};

constexpr std::array<Component, 5> components{{{"ux", "m", &StressField::ux},
                                               {"uy", "m", &StressField::uy},
                                               {"sigma_xx", "Pa", &StressField::xx},
                                               {"sigma_yy", "Pa", &StressField::yy},
                                               {"sigma_xy", "Pa", &StressField::xy}}};

void write_cement(const Hdf5Writer& at, const Cement& cement) {
  const auto group = at.create_group("cement");
  group.set("full", std::int64_t{cement.full});
  group.set("coating [m]", cement.coating);
  std::vector<std::int32_t> i, j;
  std::vector<double> half_i, half_j, radius;
  for (const Bridge& b : cement.bridges) i.push_back(b.i), j.push_back(b.j), half_i.push_back(b.half_i), half_j.push_back(b.half_j);
  const auto bridges = group.create_group("bridges");
  bridges.write("i", i);
  bridges.write("j", j);
  bridges.write("half_i", half_i, "m");
  bridges.write("half_j", half_j, "m");
  i.clear(), j.clear();
  for (const Meniscus& m : cement.menisci) i.push_back(m.i), j.push_back(m.j), radius.push_back(m.radius);
  const auto menisci = group.create_group("menisci");
  menisci.write("i", i);
  menisci.write("j", j);
  menisci.write("radius", radius, "m");
}

Cement read_cement(const Hdf5Reader& group, std::size_t grains) {
  Cement cement;
  cement.full = group.integer("full") != 0;
  cement.coating = group.number("coating [m]");
  const auto check_ends = [&](const Hdf5Reader& at, const std::vector<std::int32_t>& i, const std::vector<std::int32_t>& j) {
    for (const auto* ends : {&i, &j})
      for (const std::int32_t g : *ends)
        if (g < 0 || static_cast<std::size_t>(g) >= grains) at.refuse("names a grain that does not exist");
  };
  const auto bridges = group.group("bridges");
  const auto bi = bridges.int32s("i"), bj = bridges.int32s("j");
  const auto half_i = bridges.doubles("half_i"), half_j = bridges.doubles("half_j");
  if (bj.size() != bi.size() || half_i.size() != bi.size() || half_j.size() != bi.size())
    bridges.refuse("holds arrays of different lengths");
  check_ends(bridges, bi, bj);
  for (std::size_t b = 0; b < bi.size(); ++b) cement.bridges.push_back({bi[b], bj[b], half_i[b], half_j[b]});
  const auto menisci = group.group("menisci");
  const auto mi = menisci.int32s("i"), mj = menisci.int32s("j");
  const auto radius = menisci.doubles("radius");
  if (mj.size() != mi.size() || radius.size() != mi.size()) menisci.refuse("holds arrays of different lengths");
  check_ends(menisci, mi, mj);
  for (std::size_t m = 0; m < mi.size(); ++m) cement.menisci.push_back({mi[m], mj[m], radius[m]});
  return cement;
}

template <class To, class From>
std::vector<To> converted(const std::vector<From>& values) {
  std::vector<To> result;
  result.reserve(values.size());
  for (const From value : values) result.push_back(static_cast<To>(value));
  return result;
}

void write_map(const Hdf5Writer& at, const PhaseMap& map) {
  const auto group = at.create_group("map");
  const Hdf5Writer::Shape shape{map.height, map.width};
  group.set("width", std::int64_t{map.width});
  group.set("height", std::int64_t{map.height});
  group.set("dx [m]", map.dx);
  group.set("first_row", "bottom");
  group.set("phases", "0 empty, 1 matrix, 2 particle");
  group.write_image("phase", converted<std::uint8_t>(map.phase), shape);
  group.write_image("grain", map.grain, shape);
  group.write("grain_class", converted<std::uint8_t>(map.grain_class));
}

PhaseMap read_map(const Hdf5Reader& group) {
  constexpr std::int64_t largest = 1 << 20;
  const std::int64_t width = group.integer("width"), height = group.integer("height");
  if (width < 0 || height < 0 || width > largest || height > largest) group.refuse("has a size that makes no sense");
  PhaseMap map;
  map.width = static_cast<int>(width);
  map.height = static_cast<int>(height);
  map.dx = group.number("dx [m]");
  const auto phases = group.image_of_bytes("phase", map.height, map.width);
  const auto classes = group.bytes("grain_class");
  for (const auto phase : phases)
    if (phase > static_cast<std::uint8_t>(Phase::particle)) group.refuse("names a phase that does not exist");
  for (const auto each : classes)
    if (each > static_cast<std::uint8_t>(GrainClass::large)) group.refuse("names a class of grains that does not exist");
  map.phase = converted<Phase>(phases);
  map.grain_class = converted<GrainClass>(classes);
  map.grain = group.image_of_int32s("grain", map.height, map.width);
  try {
    check(map);
  } catch (const InputError& error) {
    group.refuse(error.what());
  }
  return map;
}

void write_stresses(const Hdf5Writer& at, const StressField& field) {
  if (field.size() == 0) return;
  const auto group = at.create_group("field");
  for (const auto& c : components) group.write_image(c.name, field.*c.member, {field.height, field.width}, c.unit);
}

StressField read_stresses(const Hdf5Reader& group, const PhaseMap& map) {
  StressField field;
  field.width = map.width;
  field.height = map.height;
  field.dx = map.dx;
  for (const auto& c : components) field.*c.member = group.image(c.name, map.height, map.width);
  return field;
}

void write_cracks(const Hdf5Writer& at, const std::vector<Crack>& cracks) {
  const auto group = at.create_group("cracks");
  std::vector<double> x, y, strain;
  std::vector<std::uint8_t> type;
  for (const Crack& c : cracks) x.push_back(c.x), y.push_back(c.y), strain.push_back(c.strain), type.push_back(c.type);
  group.write("x", x, "m");
  group.write("y", y, "m");
  group.write("type", type);
  group.write("strain", strain, "1");
}

std::vector<Crack> read_cracks(const Hdf5Reader& group) {
  const auto x = group.doubles("x"), y = group.doubles("y"), strain = group.doubles("strain");
  const auto type = group.bytes("type");
  if (y.size() != x.size() || strain.size() != x.size() || type.size() != x.size()) group.refuse("holds arrays of different lengths");
  std::vector<Crack> cracks;
  for (std::size_t c = 0; c < x.size(); ++c) cracks.push_back({static_cast<float>(x[c]), static_cast<float>(y[c]), type[c], strain[c]});
  return cracks;
}

}  // namespace

void write_field(const std::filesystem::path& path, const FieldResult& result) {
  const Hdf5Writer at;
  write_origin(at, result);
  write_packing(at, result.packing);
  write_cement(at, result.cement);
  write_map(at, result.map);
  write_stresses(at, result.field);
  write_history(at, "convergence", result.convergence);
  write_history(at, "curve", result.curve);
  write_cracks(at, result.cracks);
  write_numbers(at, "numbers", result.numbers);
  write_sealed(path, "field", at.bytes());
}

FieldResult read_field(const std::filesystem::path& path) {
  const Hdf5Reader at(read_sealed(path, "field"), path.string());
  FieldResult result;
  read_origin(at, result);
  result.packing = read_packing(at.group("packing"));
  result.cement = read_cement(at.group("cement"), result.packing.grains.size());
  result.map = read_map(at.group("map"));
  if (at.has("field")) result.field = read_stresses(at.group("field"), result.map);
  result.convergence = read_history(at.group("convergence"));
  result.curve = read_history(at.group("curve"));
  result.cracks = read_cracks(at.group("cracks"));
  result.numbers = read_numbers(at, "numbers");
  return result;
}

}  // namespace arenite::io
