#include "io/sample/named_columns.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <utility>

#include "core/option.hpp"
#include "core/text.hpp"
#include "io/sample/column_units.hpp"
#include "io/sample/number_columns.hpp"

namespace arenite::io {
namespace {

void require(const Table& table, bool found, const char* column, const char* kind, Problems& problems) {
  if (!found) problems.add(table.header_line, "there is no column \"{}\"; {}", column, kind);
}

/// Whether a force by its components in the plane is as large as by its parts along and across the normal, to three
/// digits.
bool are_one_force(Vec3 force, const std::vector<int>& axes, double fn, double ft) {
  const double size = std::hypot(force[axes[0]], force[axes[1]]);
  return std::abs(size - std::hypot(fn, ft)) <= 1e-3 * size;
}

/// The columns of a table of contacts: what is wrong with them, what is assumed of them, and a contact of each row.
class ContactColumns {
 public:
  ContactColumns(const Table& table, const Reading& reading, const RawGrains& grains);
  /// Whether they tell pairs and forces; otherwise the problems say what is missing.
  bool are_enough() const { return i_ && j_ && (fn_ || by_vector_); }
  void tell_assumed(std::vector<std::string>& notes) const;
  RawContact contact_of(const Table::Row& row) const;

 private:
  void require_all() const;
  void take_ends(const Table::Row& row, RawContact& contact) const;
  NumberColumn force(const char* name) const {
    return find_number(table_, {name}, dimension::force, options_.force(), problems_);
  }
  NumberColumn part(const char* name) const { return find_number(table_, {name}, dimension::none, 1, problems_); }
  NumberColumn length(const char* name) const { return find_length(table_, {name}, options_, problems_); }

  const Table& table_;
  const SampleOptions& options_;
  Problems& problems_;
  bool in_space_;
  std::vector<int> axes_;
  std::optional<std::size_t> i_, j_;
  NumberColumn fn_, ft_, overlap_;
  VectorColumns force_on_j_, normal_, point_;
  bool by_vector_;  ///< the force is that vector, not fn and ft
};

ContactColumns::ContactColumns(const Table& table, const Reading& reading, const RawGrains& grains)
    : table_(table),
      options_(reading.options),
      problems_(reading.problems),
      in_space_(grains.in_space),
      axes_(grains.axes()),
      i_(table.find({"i", "id1"})),
      j_(table.find({"j", "id2"})),
      fn_(force("fn")),
      ft_(force("ft")),
      overlap_(length("overlap")),
      force_on_j_({force("fx"), force("fy"), force("fz")}, axes_),
      normal_({part("nx"), part("ny"), part("nz")}, axes_),
      point_({length("x"), length("y"), length("z")}, axes_),
      by_vector_(force_on_j_.is_there && (!fn_ || in_space_)) {
  require_all();
}

void ContactColumns::require_all() const {
  const char* kind = in_space_ ? "contacts of spheres need i, j and fx, fy, fz of the force on j (or fn without "
                                 "friction) and may have nx, ny, nz, overlap and x, y, z of the contact point"
                               : "contacts need i, j, fn, ft (or fx, fy for the force on j) and may have nx, ny, "
                                 "overlap and x, y of the contact point";
  require(table_, i_.has_value(), "i", kind, problems_);
  require(table_, j_.has_value(), "j", kind, problems_);
  require(table_, fn_ || by_vector_, "fn", kind, problems_);
  if (table_.find({"nx"}) && !normal_.is_there)
    problems_.add(table_.header_line, "there is a column nx but no {}; give all or none",
                  axes_.size() > 2 ? "ny, nz" : "ny");
}

void ContactColumns::tell_assumed(std::vector<std::string>& notes) const {
  const bool force_given = options_.force_unit.has_value(), length_given = options_.length_unit.has_value();
  StatedColumns units(table_);
  if (by_vector_) units.see_vector({"fx", "fy", "fz"}, force_given, problems_);
  else units.see({"fn", "ft"}, force_given);
  units.see_vector({"x", "y", "z"}, length_given, problems_);
  units.see({"overlap"}, length_given);
  units.tell(notes);
  if (!units.are_mixed())
    note_assumed_unit(options_, table_, by_vector_ ? "fx" : "fn", force_given, "force", "N", "force-unit", notes);
  if (!by_vector_ && !ft_ && !in_space_)
    notes.push_back(
        "The contacts have no column ft, so they were taken as frictionless: tangential forces are not known.");
}

/// Who touches whom. A contact that is listed from its wall is the same one, as fn and ft are.
void ContactColumns::take_ends(const Table::Row& row, RawContact& contact) const {
  const std::span sides(any_side_names.begin(), 2 * axes_.size());
  std::string_view grain = row.cells[*i_], other = row.cells[*j_];
  if (std::ranges::count(sides, grain) > 0 && to_number(other)) {
    std::swap(grain, other);
    for (auto* of_j : {&contact.normal, &contact.force_on_j})
      if (*of_j) *of_j = -**of_j;
  }
  contact.i = integer_or_problem(grain, "i", row.line, problems_);
  if (const auto wall = std::ranges::find(sides, other); wall != sides.end())
    contact.wall = static_cast<int>(wall - sides.begin());
  else if (contact.normal && is_plain_name(other) && !to_number(other)) contact.boundary = other;
  else contact.j = integer_or_problem(other, "j", row.line, problems_);
}

RawContact ContactColumns::contact_of(const Table::Row& row) const {
  RawContact contact;
  contact.line = row.line;
  contact.normal = normal_(row);
  contact.point = point_(row);
  if (overlap_ && !row.cells[overlap_.at].empty()) contact.overlap = overlap_(row);
  if (by_vector_) contact.force_on_j = force_on_j_(row);
  take_ends(row, contact);
  if (by_vector_) return contact;
  contact.fn = fn_(row);
  if (!ft_) return contact;
  contact.ft = ft_(row);
  if (force_on_j_.is_there && !are_one_force(*force_on_j_(row), axes_, contact.fn, contact.ft))
    problems_.add(row.line, "fx, fy and fn, ft contradict each other; leave two of the columns out");
  return contact;
}

}  // namespace

std::string assumed_unit(const SampleOptions& options, const char* what, const char* si, const char* other,
                         const char* column) {
  std::vector<std::string> mends;
  if (options.may_be_given) mends.push_back(option(other));
  if (*column) mends.push_back(fmt::format("a header such as \"{} [...]\"", column));
  const std::string mend = mends.empty() ? "" : "; " + list_of(mends, " or ") + " changes this";
  return fmt::format("The file states no unit of {}, so {} was assumed{}.", what, si, mend);
}

void note_assumed_unit(const SampleOptions& options, const Table& table, const char* column, bool chosen,
                       const char* what, const char* si, const char* other, std::vector<std::string>& notes) {
  if (const auto at = table.find({column}); at && !chosen && table.columns[*at].unit.empty())
    notes.push_back(assumed_unit(options, what, si, other, column));
}

RawGrains grains_in(const Table& table, const char* needed, const SampleOptions& options, Problems& problems) {
  RawGrains grains;
  const auto id = table.find({"id", "grain"}), material = table.find({"material"}), zone = table.find({"zone"});
  const NumberColumn x = find_length(table, {"x"}, options, problems), y = find_length(table, {"y"}, options, problems);
  const NumberColumn z = find_length(table, {"z"}, options, problems);
  const NumberColumn radius = find_length(table, {"radius", "r"}, options, problems),
                     diameter = find_length(table, {"diameter", "d"}, options, problems);
  require(table, bool(x), "x", needed, problems);
  require(table, bool(y), "y", needed, problems);
  if (options.dimension == 3) require(table, bool(z), "z", needed, problems);
  require(table, radius || diameter, "radius", needed, problems);
  if (!x || !y || (!radius && !diameter)) return grains;
  if (const auto links = table.find({"links"}); links && std::ranges::any_of(table.rows, [&](const Table::Row& row) {
                                                  return to_number(row.cells[*links]).value_or(0) > 0;
                                                }))
    grains.notes.push_back(
        "The grains are joined by bonds or pulls across gaps (column links), whose forces are in no table: stress and "
        "balance lack them.");
  for (const auto& row : table.rows) {
    RawGrain grain;
    grain.line = row.line;
    grain.id = id ? integer_or_problem(row.cells[*id], "id", row.line, problems)
                  : static_cast<std::int64_t>(grains.rows.size());
    grain.place = {x(row), y(row), z ? z(row) : 0};
    grain.radius = radius ? radius(row) : 0.5 * diameter(row);
    if (radius && diameter && !is_radius_of(grain.radius, diameter(row)))
      problems.add(row.line, "radius and diameter contradict each other; leave one of the columns out");
    if (material) grain.material = row.cells[*material];
    if (zone) grain.zone = integer_or_problem(row.cells[*zone], "zone", row.line, problems);
    grains.rows.push_back(std::move(grain));
  }
  return grains;
}

RawContacts contacts_in(const Table& table, const Reading& reading, const RawGrains& grains) {
  const ContactColumns columns(table, reading, grains);
  RawContacts contacts;
  if (!columns.are_enough()) return contacts;
  columns.tell_assumed(contacts.notes);
  for (const auto& row : table.rows) {
    contacts.rows.push_back(columns.contact_of(row));
    if (!grains.in_space || contacts.rows.back().ft == 0) continue;
    reading.problems.add(
        row.line,
        "ft says how large the tangential force is, but in space not where it points; give the force on j as fx, fy, "
        "fz");
    break;
  }
  return contacts;
}

}  // namespace arenite::io
