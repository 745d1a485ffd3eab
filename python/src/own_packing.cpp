#include "own_packing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "arrays.hpp"
#include "core/error.hpp"
#include "io/assemble.hpp"
#include "model/contacts.hpp"

namespace arenite::python {
namespace {

constexpr std::int32_t most_index = std::numeric_limits<std::int32_t>::max() - 1;

void check(const OwnFrame& frame) {
  const auto positive = [](double value, const char* name, bool or_zero) {
    if (!std::isfinite(value) || value < 0 || (value == 0 && !or_zero)) throw InputError(fmt::format("{} is {} m; give a length above 0", name, value));
  };
  positive(frame.width, "width", false);
  positive(frame.height, "height", false);
  positive(frame.thickness, "thickness", true);
}

io::RawGrains rows_of(const ArrayLike& x, const ArrayLike& y, const ArrayLike& radius, const OwnFrame& frame) {
  const auto centre_x = finite_numbers(x, "x"), centre_y = finite_numbers(y, "y"), radii = finite_numbers(radius, "radius");
  if (centre_y.size() != centre_x.size() || radii.size() != centre_x.size()) throw InputError("x, y, radius and material must be of one length");
  io::RawGrains grains;
  grains.has_box = true;
  const Vec2 low = grains.box_low = frame.corner, high = grains.box_high = frame.corner + Vec2{frame.width, frame.height};
  std::tie(grains.periodic_x, grains.periodic_y) = periodic_directions(frame.periodic);
  for (std::size_t k = 0; k < radii.size(); ++k) {
    const Vec2 centre{centre_x[k], centre_y[k]};
    const bool outside_x = !grains.periodic_x && (centre.x < low.x || centre.x > high.x), outside_y = !grains.periodic_y && (centre.y < low.y || centre.y > high.y);
    if (outside_x || outside_y)
      throw InputError(fmt::format("the centre of grain {}, ({:g}, {:g}) m, lies outside the frame, which reaches from ({:g}, {:g}) to ({:g}, {:g}) m; "
                                   "correct the centre, or origin, width and height", k, centre.x, centre.y, low.x, low.y, high.x, high.y));
    grains.rows.push_back({static_cast<std::int64_t>(k), centre, radii[k], {}, 0, 0});
  }
  return grains;
}

class Columns {
 public:
  explicit Columns(const py::object& table) : table_(table), ours_(py::isinstance<Contacts>(table)) {
    if (!ours_ && !py::hasattr(table, "__contains__")) throw InputError("contacts: give a dict of arrays i, j and, where they are known, fn, ft, nx, ny");
  }
  std::optional<ArrayLike> find(const char* name) const {
    if (ours_) return ArrayLike(table_.attr(name));
    if (!table_.contains(name)) return std::nullopt;
    return ArrayLike(table_[name]);
  }
  ArrayLike need(const char* name) const {
    if (auto column = find(name)) return *column;
    throw InputError(fmt::format("contacts has no \"{}\"; give a dict of arrays i, j and, where they are known, fn, ft, nx, ny", name));
  }
  /// Zeros where there is none.
  std::vector<double> numbers(const char* name, std::size_t size) const {
    const auto column = find(name);
    auto values = column ? finite_numbers(*column, fmt::format("contacts[\"{}\"]", name)) : std::vector<double>(size, 0.0);
    if (values.size() != size) throw InputError(fmt::format("contacts[\"{}\"] has {} values for {} contacts; give arrays of one length", name, values.size(), size));
    return values;
  }

 private:
  py::object table_;
  bool ours_;
};

io::RawContacts rows_of(const py::object& table) {
  const Columns columns(table);
  const auto i = whole_numbers(columns.need("i"), 0, most_index, "contacts[\"i\"]"), j = whole_numbers(columns.need("j"), -4, most_index, "contacts[\"j\"]");
  if (i.size() != j.size()) throw InputError("contacts: i and j must be of one length");
  const std::size_t n = i.size();
  const auto fn = columns.numbers("fn", n), ft = columns.numbers("ft", n);
  const bool normals = columns.find("nx").has_value() && columns.find("ny").has_value();
  const auto nx = columns.numbers("nx", n), ny = columns.numbers("ny", n);
  io::RawContacts contacts;
  for (std::size_t k = 0; k < n; ++k) {
    io::RawContact row{i[k], std::max(j[k], 0), j[k] < 0 ? -1 - j[k] : -1, fn[k], ft[k], {}, {}, static_cast<int>(k) + 1};
    if (normals) row.normal = Vec2{-nx[k], -ny[k]};  // a file's normal points from i to j
    contacts.rows.push_back(row);
  }
  return contacts;
}

void take_materials(Packing& packing, const std::optional<ArrayLike>& material, std::vector<Material> materials) {
  const auto last = static_cast<std::int32_t>(std::max<std::size_t>(materials.size(), 1)) - 1;
  auto& numbers = packing.grains.material;
  const std::size_t n = numbers.size();
  numbers = material ? whole_numbers(*material, 0, last, "material (a place in `materials`)") : std::vector<std::int32_t>(n, 0);
  if (numbers.size() != n) throw InputError("x, y, radius and material must be of one length");
  packing.materials = materials.empty() ? Materials{{"grain"}} : std::move(materials);
}

}  // namespace

Packing own_packing(const ArrayLike& x, const ArrayLike& y, const ArrayLike& radius, const std::optional<ArrayLike>& material,
                    std::vector<Material> materials, const OwnFrame& frame, const py::object& contacts) {
  check(frame);
  io::SampleOptions options;
  options.thickness = frame.thickness;
  io::Sample sample;
  Problems of_grains, of_contacts("contacts");
  io::assemble(rows_of(x, y, radius, frame), contacts.is_none() ? io::RawContacts{} : rows_of(contacts), options, sample, of_grains, of_contacts);
  take_materials(sample.packing, material, std::move(materials));
  return std::move(sample.packing);
}

}  // namespace arenite::python
