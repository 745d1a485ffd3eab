#include "io/sample/pair_columns.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <unordered_map>
#include <utility>

#include "core/mapped.hpp"
#include "io/sample/formats.hpp"

namespace arenite::io {
namespace {

constexpr double most_deviation = 0.02;  // of a direction, rad: files have six digits
constexpr double enough = 0.9;           // share of the contacts with a force

using NumberRow = std::vector<double>;  ///< of the candidates

std::vector<NumberRow> numbers_of(const std::vector<std::vector<std::string_view>>& rows,
                                  const std::vector<std::size_t>& candidates) {
  std::vector<NumberRow> numbers;
  for (const auto& cells : rows) {
    NumberRow row;
    for (const std::size_t c : candidates) {
      const auto value = c < cells.size() ? to_number(cells[c]) : std::nullopt;
      if (!value) break;
      row.push_back(*value);
    }
    if (row.size() == candidates.size()) numbers.push_back(std::move(row));
  }
  return numbers;
}

class PairGeometry {
 public:
  explicit PairGeometry(const RawGrains& grains) : grains_(grains) {
    for (const RawGrain& g : grains.rows) centre_[g.id] = g.place;
  }

  bool is_grain(double id) const {
    return id == std::floor(id) && std::abs(id) < 1e15 && centre_.count(static_cast<std::int64_t>(id)) > 0;
  }
  /// From the second grain to the first, in the nearest image; nothing across a plane.
  Vec3 branch(double i, double j) const {
    const Vec3 way = centre_.at(static_cast<std::int64_t>(i)) - centre_.at(static_cast<std::int64_t>(j));
    return grains_.laid([&](const auto& laid) {
      const auto here = laid.frame.of(way);
      return laid.frame.in_space(laid.has_box ? laid.cell.nearest_image(here) : here);
    });
  }

 private:
  const RawGrains& grains_;
  std::unordered_map<std::int64_t, Vec3> centre_;
};

/// Columns that may be a vector: that of the first component, and along which axes they go, each as far behind the
/// first as its axis is behind the first axis.
struct VectorOfColumns {
  std::size_t first;
  const std::vector<int>& axes;
  std::size_t column(int axis) const { return first + static_cast<std::size_t>(axis - axes.front()); }
  Vec3 of(const NumberRow& row) const {
    Vec3 v;
    for (const int axis : axes) v[axis] = row[column(axis)];
    return v;
  }
};

/// How far vectors deviate from the branches, or from being across them, on average (sine); infinite where they do not
/// lie so. Vectors without length do not tell; of none that tells it is infinite.
struct Fit {
  double deviation = std::numeric_limits<double>::infinity();
  std::size_t telling = 0;
  bool is_one() const { return std::isfinite(deviation); }
  /// In a lattice, columns that belong to two vectors may look like one where most of them are 0.
  bool is_better_than(const Fit& other) const {
    return is_one() && (telling != other.telling ? telling > other.telling : deviation < other.deviation);
  }
};
Fit fit_of(const std::vector<NumberRow>& rows, const std::vector<Vec3>& branches, const VectorOfColumns& at,
           bool along) {
  std::size_t telling = 0, fitting = 0;
  double sum = 0;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const Vec3 f = at.of(rows[k]), d = branches[k];
    const double size = norm(f) * norm(d);
    if (!(size > 0)) continue;
    const double sine = (along ? norm(cross(f, d)) : std::abs(dot(f, d))) / size;
    ++telling;
    fitting += sine <= most_deviation ? 1 : 0;
    sum += std::min(sine, most_deviation);
  }
  const bool fits = telling > 0 && static_cast<double>(fitting) >= enough * static_cast<double>(telling);
  return fits ? Fit{sum / static_cast<double>(telling), telling} : Fit{};
}

/// Whether the vectors in columns are the branches themselves (dx, dy of pair/local).
bool are_branches(const std::vector<NumberRow>& rows, const std::vector<Vec3>& branches, const VectorOfColumns& at) {
  for (std::size_t k = 0; k < rows.size(); ++k)
    if (std::abs(norm(at.of(rows[k])) - norm(branches[k])) > most_deviation * norm(branches[k])) return false;
  return true;
}

bool all_zero(const std::vector<NumberRow>& rows, const VectorOfColumns& at) {
  return std::ranges::all_of(rows, [&](const NumberRow& row) { return at.of(row) == Vec3{}; });
}

}  // namespace

std::vector<std::size_t> find_pair_columns(const std::vector<std::vector<std::string_view>>& rows,
                                           const std::vector<std::size_t>& candidates, const RawGrains& grains) {
  const auto numbers = numbers_of(rows, candidates);
  const auto axes = grains.axes();
  const std::size_t n = candidates.size();
  if (numbers.empty() || n < 2 + 2 * axes.size()) return {};
  const PairGeometry geometry(grains);
  const auto are_grains = [&](std::size_t c) {
    return std::ranges::all_of(numbers, [&](const NumberRow& row) { return geometry.is_grain(row[c]); });
  };
  std::size_t i = 0;
  while (i + 1 < n && !(are_grains(i) && are_grains(i + 1) &&
                        std::ranges::none_of(numbers, [&](const NumberRow& row) { return row[i] == row[i + 1]; })))
    ++i;
  if (i + 1 >= n) return {};
  const auto branches = mapped(numbers, [&](const NumberRow& row) { return geometry.branch(row[i], row[i + 1]); });
  const auto wide = static_cast<std::size_t>(axes.back() - axes.front());  // from the first component to the last
  std::size_t force = n;
  Fit best;
  for (std::size_t x = 0; x + wide < n; ++x) {
    if (x + wide >= i && x <= i + 1) continue;
    const VectorOfColumns at{x, axes};
    const Fit found = fit_of(numbers, branches, at, true);
    if (found.is_better_than(best) && !are_branches(numbers, branches, at)) best = found, force = x;
  }
  if (force == n) return {};
  const std::size_t next = force + wide + 1;
  const auto with = [&](std::size_t p) {
    std::vector found{candidates[i], candidates[i + 1]};
    for (const std::size_t first : {force, p})
      for (const int axis : axes) found.push_back(candidates[VectorOfColumns{first, axes}.column(axis)]);
    return found;
  };
  const auto is_tangential = [&](std::size_t p) { return fit_of(numbers, branches, {p, axes}, false).is_one(); };
  for (std::size_t p = next; p + wide < n; ++p)
    if (is_tangential(p)) return with(p);
  for (std::size_t p = 0; p + wide < force; ++p)  // asked for before the normal force
    if ((p + wide < i || p > i + 1) && is_tangential(p)) return with(p);
  // Without friction all is zero: behind fx and fy, or behind fz too where as many follow as fz, p1, p2 and p3 are.
  const std::size_t p = wide == 1 && n - next >= 4 ? next + 1 : next;
  if (p + wide < n && all_zero(numbers, {p, axes})) return with(p);
  return {};
}

}  // namespace arenite::io
