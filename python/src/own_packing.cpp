#include "own_packing.hpp"

#include <fmt/core.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "arrays.hpp"
#include "core/text.hpp"
#include "io/sample/assemble.hpp"
#include "io/sample/formats.hpp"

namespace arenite::python {
namespace {

constexpr std::int32_t most_index = std::numeric_limits<std::int32_t>::max() - 1;

void check_container(const OwnContainer& container) {
  const auto positive = [](double value, const char* name, bool or_zero) {
    if (!std::isfinite(value) || value < 0 || (value == 0 && !or_zero))
      throw InputError(fmt::format("{} is {} m; give a length above 0", name, value));
  };
  positive(container.width, "width", false);
  positive(container.height, "height", false);
  positive(container.thickness, "thickness", true);
}

io::RawGrains rows_of(const ArrayLike& x, const ArrayLike& y, const ArrayLike& radius, const OwnContainer& container) {
  const auto centre_x = finite_numbers(x, "x"), centre_y = finite_numbers(y, "y"),
             radii = finite_numbers(radius, "radius");
  if (centre_y.size() != centre_x.size() || radii.size() != centre_x.size())
    throw InputError("x, y, radius and material must have equal lengths");
  io::RawGrains grains;
  const Vec2 low = container.corner, high = container.corner + Vec2{container.width, container.height};
  grains.plane.lay_box(low, high);
  auto& periodic = grains.plane.cell.periodic;
  std::tie(periodic[0], periodic[1]) = periodic_directions(container.periodic);
  for (std::size_t k = 0; k < radii.size(); ++k) {
    const Vec2 centre{centre_x[k], centre_y[k]};
    const bool outside_x = !periodic[0] && (centre.x < low.x || centre.x > high.x),
               outside_y = !periodic[1] && (centre.y < low.y || centre.y > high.y);
    if (outside_x || outside_y)
      throw InputError(
          fmt::format("the centre of grain {}, ({:g}, {:g}) m, lies outside the container, which extends from ({:g}, "
                      "{:g}) to ({:g}, {:g}) m; correct the centre, or origin, width and height",
                      k, centre.x, centre.y, low.x, low.y, high.x, high.y));
    grains.rows.push_back({static_cast<std::int64_t>(k), Vec3{centre.x, centre.y, 0}, radii[k], {}, 0, 0});
  }
  return grains;
}

constexpr const char* contact_names[] = {"i", "j", "fn", "ft", "nx", "ny"};

class Columns {
 public:
  explicit Columns(const py::object& table) : table_(table), ours_(py::isinstance<Contacts>(table)) {
    if (!ours_ && !py::hasattr(table, "__contains__"))
      throw InputError("contacts: give a dict of arrays i, j and, where they are known, fn, ft, nx, ny");
  }
  std::optional<ArrayLike> find(const char* name) const {
    if (ours_) return ArrayLike(table_.attr(name));
    if (!table_.contains(name)) return std::nullopt;
    return ArrayLike(table_[name]);
  }
  ArrayLike need(const char* name) const {
    if (auto column = find(name)) return *column;
    throw InputError(fmt::format(
        "contacts has no \"{}\"; give a dict of arrays i, j and, where they are known, fn, ft, nx, ny", name));
  }
  /// Zeros where there is none.
  std::vector<double> numbers(const char* name, std::size_t size) const {
    const auto column = find(name);
    auto values =
        column ? finite_numbers(*column, fmt::format("contacts[\"{}\"]", name)) : std::vector<double>(size, 0.0);
    if (values.size() != size)
      throw InputError(fmt::format("contacts[\"{}\"] has {} values for {} contacts; give arrays of equal length", name,
                                   values.size(), size));
    return values;
  }

 private:
  py::object table_;
  bool ours_;
};

/// A table of pandas may hold more; in a dict a name that is none is a slip.
void check_names(const py::object& table) {
  if (!py::isinstance<py::dict>(table)) return;
  for (const auto& [key, values] : table.cast<py::dict>()) {
    const auto name = py::str(key).cast<std::string>();
    if (std::ranges::find(contact_names, name) == std::end(contact_names))
      throw InputError(
          fmt::format("contacts has no arrays of the name \"{}\"; there are {}", name, list_of(contact_names, ", ")));
  }
}

io::RawContacts rows_of(const py::object& table) {
  check_names(table);
  const Columns columns(table);
  const auto i = whole_numbers(columns.need("i"), 0, most_index, "contacts[\"i\"]"),
             j = whole_numbers(columns.need("j"), -4, most_index, "contacts[\"j\"]");
  if (i.size() != j.size()) throw InputError("contacts: i and j must have equal lengths");
  const std::size_t n = i.size();
  const auto fn = columns.numbers("fn", n), ft = columns.numbers("ft", n);
  const bool normals = columns.find("nx").has_value() && columns.find("ny").has_value();
  const auto nx = columns.numbers("nx", n), ny = columns.numbers("ny", n);
  io::RawContacts contacts;
  for (std::size_t k = 0; k < n; ++k) {
    io::RawContact row;
    row.i = i[k], row.j = std::max(j[k], 0), row.wall = is_wall(j[k]) ? wall_side(j[k]) : -1;
    row.fn = fn[k], row.ft = ft[k], row.line = static_cast<int>(k) + 1;
    if (normals) row.normal = Vec3{-nx[k], -ny[k], 0};  // a file's normal points from i to j
    contacts.rows.push_back(row);
  }
  return contacts;
}

void take_materials(Packing& packing, const std::optional<ArrayLike>& material, std::vector<Material> materials) {
  const auto last = static_cast<std::int32_t>(std::max<std::size_t>(materials.size(), 1)) - 1;
  auto& numbers = packing.grains.material;
  const std::size_t n = numbers.size();
  numbers = material ? whole_numbers(*material, 0, last, "material (a place in `materials`)")
                     : std::vector<std::int32_t>(n, 0);
  if (numbers.size() != n) throw InputError("x, y, radius and material must have equal lengths");
  packing.materials = materials.empty() ? Materials{{"grain"}} : std::move(materials);
}

}  // namespace

Packing own_packing(const ArrayLike& x, const ArrayLike& y, const ArrayLike& radius,
                    const std::optional<ArrayLike>& material, std::vector<Material> materials,
                    const OwnContainer& container, const py::object& contacts) {
  check_container(container);
  io::SampleOptions options;
  options.thickness = container.thickness;
  io::Sample sample;
  Problems of_grains, of_contacts("contacts");
  const io::RawGrains grains = rows_of(x, y, radius, container);
  io::assemble(grains, grains.plane, contacts.is_none() ? io::RawContacts{} : rows_of(contacts), options, sample,
               of_grains, of_contacts);
  take_materials(sample.packing, material, std::move(materials));
  return std::move(sample.packing);
}

}  // namespace arenite::python
