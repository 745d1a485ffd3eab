#include <cstdint>
#include <filesystem>
#include <vector>

#include "core/mapped.hpp"
#include "io/results/groups.hpp"
#include "io/results/results.hpp"

namespace arenite::io {
namespace {

void transfer_cement(const Hdf5Group& at, Cement& cement, std::size_t grains) {
  const auto group = at.group("cement");
  group("full", cement.full);
  group("coating [m]", cement.coating);
  const auto bridges = group.group("bridges");
  bridges.records(cement.bridges, Named{"i", &Bridge::i}, Named{"j", &Bridge::j}, Named{"half_i", &Bridge::half_i, "m"},
                  Named{"half_j", &Bridge::half_j, "m"});
  const auto menisci = group.group("menisci");
  menisci.records(cement.menisci, Named{"i", &Meniscus::i}, Named{"j", &Meniscus::j},
                  Named{"radius", &Meniscus::radius, "m"});
  check_ends(bridges, cement.bridges, grains, "names a grain that does not exist");
  check_ends(menisci, cement.menisci, grains, "names a grain that does not exist");
}

template <class To, class From> std::vector<To> converted(const std::vector<From>& values) {
  return mapped(values, [](From value) { return static_cast<To>(value); });
}

void transfer_map(const Hdf5Group& at, PhaseMap& map) {
  const auto group = at.group("map");
  group("width", map.width);
  group("height", map.height);
  group("dx [m]", map.dx);
  group.note("first_row", "bottom");
  constexpr int largest = 1 << 20;
  if (at.reads() && (map.width < 0 || map.height < 0 || map.width > largest || map.height > largest))
    group.refuse("has an impossible size");
  const Shape shape{map.height, map.width};
  auto classes = converted<std::uint8_t>(map.grain_class);
  transfer_phases(group, map.phase, shape);
  group.image("grain", map.grain, shape);
  group.array("grain_class", classes);
  if (!at.reads()) return;
  for (const auto each : classes)
    if (each > static_cast<std::uint8_t>(GrainClass::large))
      group.refuse("names a class of grains that does not exist");
  map.grain_class = converted<GrainClass>(classes);
  refuse_unsound(group, map);
}

/// A field that is there; none is where nothing was loaded.
void transfer_stresses(const Hdf5Group& at, StressField& field, const PhaseMap& map) {
  if (at.lacks("field", field.size() == 0)) return;
  if (at.reads()) {
    field.width = map.width;
    field.height = map.height;
    field.dx = map.dx;
  }
  const auto group = at.group("field");
  for (const auto& c : field_columns) group.image(c.name, field.*c.numbers, {field.height, field.width}, c.unit);
}

void transfer_field(const Hdf5Group& at, FieldResult& result) {
  transfer_origin(at, result);
  transfer_packing(at, result.packing);
  transfer_cement(at, result.cement, result.packing.grains.size());
  transfer_map(at, result.map);
  transfer_stresses(at, result.field, result.map);
  transfer_history(at, "convergence", result.convergence);
  transfer_history(at, "curve", result.curve);
  at.group("cracks").records(result.cracks, Named{"x", &Crack::x, "m"}, Named{"y", &Crack::y, "m"},
                             Named{"type", &Crack::type}, Named{"strain", &Crack::strain});
  transfer_numbers(at, "numbers", result.numbers);
}

}  // namespace

void write_field(const std::filesystem::path& path, const FieldResult& result) {
  write_result_file(path, "field", transfer_field, result);
}

FieldResult read_field(const std::filesystem::path& path) { return read_result_file(path, "field", transfer_field); }

}  // namespace arenite::io
