#include "core/error.hpp"
#include "io/disk/store_file.hpp"
#include "io/results/groups.hpp"
#include "io/results/results.hpp"

namespace arenite::io {
namespace {

struct Component {
  const char* name;
  const char* unit;
  std::vector<double> StressField::*member;
};
constexpr Component components[] = {{"ux", "m", &StressField::ux},
                                    {"uy", "m", &StressField::uy},
                                    {"sigma_xx", "Pa", &StressField::xx},
                                    {"sigma_yy", "Pa", &StressField::yy},
                                    {"sigma_xy", "Pa", &StressField::xy}};

template <class Joints>
void check_ends(const Hdf5Reader& at, const Joints& joints, std::size_t grains) {
  for (const auto& joint : joints)
    for (const std::int32_t g : {joint.i, joint.j})
      if (g < 0 || static_cast<std::size_t>(g) >= grains) at.refuse("names a grain that does not exist");
}

template <class At, class C>
void transfer_cement(const At& at, C& cement, std::size_t grains) {
  const auto group = at.group("cement");
  group("full", cement.full);
  group("coating [m]", cement.coating);
  const auto bridges = group.group("bridges");
  bridges.template size<std::int32_t>("i", cement.bridges);
  bridges.member("i", cement.bridges, &Bridge::i);
  bridges.member("j", cement.bridges, &Bridge::j);
  bridges.member("half_i", cement.bridges, &Bridge::half_i, "m");
  bridges.member("half_j", cement.bridges, &Bridge::half_j, "m");
  const auto menisci = group.group("menisci");
  menisci.template size<std::int32_t>("i", cement.menisci);
  menisci.member("i", cement.menisci, &Meniscus::i);
  menisci.member("j", cement.menisci, &Meniscus::j);
  menisci.member("radius", cement.menisci, &Meniscus::radius, "m");
  if constexpr (At::reads) {
    check_ends(bridges.at, cement.bridges, grains);
    check_ends(menisci.at, cement.menisci, grains);
  }
}

template <class To, class From>
std::vector<To> converted(const std::vector<From>& values) {
  std::vector<To> result;
  result.reserve(values.size());
  for (const From value : values) result.push_back(static_cast<To>(value));
  return result;
}

template <class At, class M>
void transfer_map(const At& at, M& map) {
  const auto group = at.group("map");
  group("width", map.width);
  group("height", map.height);
  group("dx [m]", map.dx);
  group.note("first_row", "bottom");
  group.note("phases", "0 empty, 1 matrix, 2 particle");
  if constexpr (At::reads) {
    constexpr int largest = 1 << 20;
    if (map.width < 0 || map.height < 0 || map.width > largest || map.height > largest) group.at.refuse("has a size that makes no sense");
  }
  const Shape shape{map.height, map.width};
  auto phases = converted<std::uint8_t>(map.phase), classes = converted<std::uint8_t>(map.grain_class);
  group.image("phase", phases, shape);
  group.image("grain", map.grain, shape);
  group.array("grain_class", classes);
  if constexpr (At::reads) {
    for (const auto phase : phases)
      if (phase > static_cast<std::uint8_t>(Phase::particle)) group.at.refuse("names a phase that does not exist");
    for (const auto each : classes)
      if (each > static_cast<std::uint8_t>(GrainClass::large)) group.at.refuse("names a class of grains that does not exist");
    map.phase = converted<Phase>(phases);
    map.grain_class = converted<GrainClass>(classes);
    try {
      check(map);
    } catch (const InputError& error) {
      group.at.refuse(error.what());
    }
  }
}

/// A field that is there; none is where nothing was loaded.
template <class At, class S>
void transfer_stresses(const At& at, S& field, const PhaseMap& map) {
  if constexpr (At::reads) {
    if (!at.at.has("field")) return;
    field.width = map.width;
    field.height = map.height;
    field.dx = map.dx;
  } else if (field.size() == 0) {
    return;
  }
  const auto group = at.group("field");
  for (const auto& c : components) group.image(c.name, field.*c.member, {field.height, field.width}, c.unit);
}

template <class At, class R>
void transfer_field(const At& at, R& result) {
  transfer_origin(at, result);
  transfer_packing(at, result.packing);
  transfer_cement(at, result.cement, result.packing.grains.size());
  transfer_map(at, result.map);
  transfer_stresses(at, result.field, result.map);
  transfer_history(at, "convergence", result.convergence);
  transfer_history(at, "curve", result.curve);
  const auto cracks = at.group("cracks");
  cracks.template size<double>("x", result.cracks);
  cracks.member("x", result.cracks, &Crack::x, "m");
  cracks.member("y", result.cracks, &Crack::y, "m");
  cracks.member("type", result.cracks, &Crack::type);
  cracks.member("strain", result.cracks, &Crack::strain);
  transfer_numbers(at, "numbers", result.numbers);
}

}  // namespace

void write_field(const std::filesystem::path& path, const FieldResult& result) {
  const PutGroup to{Hdf5Writer()};
  transfer_field(to, result);
  write_sealed(path, "field", to.at.bytes());
}

FieldResult read_field(const std::filesystem::path& path) {
  FieldResult result;
  transfer_field(TakeGroup{Hdf5Reader(read_sealed(path, "field"), path.string())}, result);
  return result;
}

}  // namespace arenite::io
