#include "workflow/lammps/read_carried.hpp"

#include <fmt/core.h>

#include <array>
#include <cstdint>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "core/problems.hpp"
#include "core/text.hpp"
#include "grains/lammps/deck.hpp"
#include "io/sample/lammps_dump.hpp"
#include "io/table/text_file.hpp"

namespace arenite::workflow {

namespace fs = std::filesystem;
namespace names = lammps::names;

namespace {

/// One item of a dump: numbers by the names of columns.
class DumpColumns {
 public:
  DumpColumns(const fs::path& path, std::string_view item)
      : problems_(path.string()),
        text_(io::read_text(path)),
        dump_(io::read_dump({text_, 0, options_, problems_})) {
    problems_.raise();
    io::DumpItem* const found = dump_.find(item);
    if (!found) refuse(path.string(), "there is no \"ITEM: {}\"; run LAMMPS again", item);
    table_ = &found->table;
    io::check_count(dump_, *table_, "NUMBER OF " + std::string(item), problems_);
    io::name_columns(*table_, split_blanks(found->title.substr(item.size())));
    io::check_rows(*table_, problems_);
    problems_.raise();
  }
  std::size_t size() const { return table_->rows.size(); }
  const std::optional<io::RawCell>& cell() const { return dump_.cell; }

  std::size_t at(const std::string& name) {
    const auto found = table_->find({name});
    if (!found) refuse(problems_.file(), "there is no column \"{}\"; run LAMMPS again", name);
    return *found;
  }
  template <std::size_t N> std::array<std::size_t, N> at(const std::array<std::string, N>& names) {
    std::array<std::size_t, N> places{};
    for (std::size_t k = 0; k < N; ++k) places[k] = at(names[k]);
    return places;
  }
  double number(std::size_t row, std::size_t column) {
    const auto& [line, cells] = table_->rows[row];
    return io::number_or_problem(cells[column], table_->columns[column].name, 1, line, problems_);
  }
  Vec3 vector(std::size_t row, const std::array<std::size_t, 3>& columns) {
    return by_axis<3>([&](int axis) { return number(row, columns[axis]); });
  }
  void raise() { problems_.raise(); }

 private:
  Problems problems_;
  io::SampleOptions options_;
  std::string text_;
  io::DumpSnapshot dump_;
  io::Table* table_ = nullptr;
};

template <int D> Vec<D> of_space(Vec3 v) {
  return by_axis<D>([&](int axis) { return v[axis]; });
}
template <int D> Turning<D> turning_of(Vec3 v);
template <> Turning<2> turning_of<2>(Vec3 v) { return v.z; }
template <> Turning<3> turning_of<3>(Vec3 v) { return v; }

std::array<std::string, 3> along(const std::string& before) { return {before + "x", before + "y", before + "z"}; }
std::array<std::string, 3> numbered(const std::string& before, int first) {
  return {fmt::format("{}[{}]", before, first), fmt::format("{}[{}]", before, first + 1),
          fmt::format("{}[{}]", before, first + 2)};
}

template <int D> void read_grains(DumpColumns& atoms, lammps::CarriedIn<D>& carried) {
  const auto place = atoms.at(along("")), velocity = atoms.at(along("v")), omega = atoms.at(along("omega")),
             force = atoms.at(along("f"));
  for (std::size_t k = 0; k < atoms.size(); ++k) {
    carried.position.push_back(of_space<D>(atoms.vector(k, place)));
    carried.velocity.push_back(of_space<D>(atoms.vector(k, velocity)));
    carried.omega.push_back(turning_of<D>(atoms.vector(k, omega)));
    carried.force.push_back(of_space<D>(atoms.vector(k, force)));
  }
}

/// Of each wall, one fix a material.
template <int D> void read_wall(DumpColumns& atoms, int side, std::size_t materials, lammps::CarriedIn<D>& carried) {
  for (std::size_t m = 0; m < materials; ++m) {
    const auto at = atoms.at(numbered("f_" + lammps::wall_fix(side, static_cast<int>(m)), 2));
    for (std::size_t k = 0; k < atoms.size(); ++k)
      if (const Vec3 force = atoms.vector(k, at); norm(force) > 0)
        carried.contacts.push_back({static_cast<std::int32_t>(k), wall_partner(side), of_space<D>(force)});
  }
}

template <int D> void read_pairs(const fs::path& path, lammps::CarriedIn<D>& carried) {
  DumpColumns pairs(path, "ENTRIES");
  if (pairs.size() == 0) return;
  const std::size_t first = pairs.at("c_ids[1]"), second = pairs.at("c_ids[2]");
  const auto normal = pairs.at(numbered("c_forces", 1)), tangential = pairs.at(numbered("c_forces", 4));
  for (std::size_t row = 0; row < pairs.size(); ++row) {
    const auto i = static_cast<std::int32_t>(pairs.number(row, first)) - 1,
               j = static_cast<std::int32_t>(pairs.number(row, second)) - 1;
    const Vec<D> on_first = of_space<D>(pairs.vector(row, normal) + pairs.vector(row, tangential));
    if (i < j) carried.contacts.push_back({i, j, on_first});
    else carried.contacts.push_back({j, i, -on_first});
  }
  pairs.raise();
}

/// Steps, and the ways of walls from where they were.
template <int D> void read_end(const fs::path& path, lammps::CarriedIn<D>& carried) {
  std::istringstream words(io::read_text(path));
  double value = 0;
  for (std::string name; words >> name >> value;) {
    if (name == "steps") carried.steps = static_cast<std::int64_t>(value);
    for (int side = 0; side < sides_in<D>; ++side)
      if (name == any_side_names[side]) carried.domain.wall[side].position += value;
  }
}

}  // namespace

template <int D> lammps::CarriedIn<D> read_carried(const fs::path& folder, const dem::SampleIn<D>& given) {
  lammps::CarriedIn<D> carried;
  carried.domain = given.domain;
  read_end(folder / names::ended, carried);
  DumpColumns atoms(folder / names::state, "ATOMS");
  if (atoms.size() != given.count)
    refuse((folder / names::state).string(), "it has {} grains of {}; some left the container on LAMMPS's way",
           atoms.size(), given.count);
  for (int axis = 0; axis < D && atoms.cell(); ++axis) {
    if (!given.domain.periodic[axis]) continue;
    carried.domain.wall[2 * axis].position = atoms.cell()->corner[axis];
    carried.domain.wall[2 * axis + 1].position = atoms.cell()->corner[axis] + atoms.cell()->edge[axis][axis];
  }
  read_grains(atoms, carried);
  for (int side = 0; side < sides_in<D>; ++side)
    if (!given.domain.is_periodic(side) && given.domain.wall[side].present)
      read_wall(atoms, side, given.start.materials.size(), carried);
  atoms.raise();
  read_pairs(folder / names::pairs, carried);
  return carried;
}

template lammps::CarriedIn<2> read_carried(const fs::path&, const dem::SampleIn<2>&);
template lammps::CarriedIn<3> read_carried(const fs::path&, const dem::SampleIn<3>&);

}  // namespace arenite::workflow
