#include "io/sample/sample.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "core/mapped.hpp"
#include "io/table/table.hpp"

namespace arenite::io {
namespace {

constexpr double most_deviation = 0.02;  // of a direction, rad: files have six digits
constexpr double enough = 0.9;           // share of the contacts with a force

using NumberRow = std::vector<double>;  ///< of the candidates

std::vector<NumberRow> numbers_of(const std::vector<std::vector<std::string_view>>& rows, const std::vector<std::size_t>& candidates) {
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
  explicit PairGeometry(const RawGrains& grains) : cell_(grains.has_box ? grains.cell : Domain{}) {
    for (const RawGrain& g : grains.rows) centre_[g.id] = g.centre;
  }

  bool is_grain(double id) const { return id == std::floor(id) && std::abs(id) < 1e15 && centre_.count(static_cast<std::int64_t>(id)) > 0; }
  /// From the second grain to the first, in the nearest image.
  Vec2 branch(double i, double j) const { return cell_.nearest_image(centre_.at(static_cast<std::int64_t>(i)) - centre_.at(static_cast<std::int64_t>(j))); }

 private:
  std::unordered_map<std::int64_t, Vec2> centre_;
  Domain cell_;
};

/// Whether the vectors in two columns lie along the branches, or across them. Vectors without length do not tell; of none that tells it is false.
bool lies(const std::vector<NumberRow>& rows, const std::vector<Vec2>& branches, std::size_t x, std::size_t y, bool along) {
  std::size_t telling = 0, fitting = 0;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const Vec2 f{rows[k][x], rows[k][y]}, d = branches[k];
    const double size = norm(f) * norm(d);
    if (!(size > 0)) continue;
    ++telling;
    fitting += std::abs(along ? f.x * d.y - f.y * d.x : dot(f, d)) <= most_deviation * size ? 1 : 0;
  }
  return telling > 0 && static_cast<double>(fitting) >= enough * static_cast<double>(telling);
}

/// Whether the vectors in two columns are the branches themselves (dx, dy of pair/local).
bool are_branches(const std::vector<NumberRow>& rows, const std::vector<Vec2>& branches, std::size_t x) {
  for (std::size_t k = 0; k < rows.size(); ++k)
    if (std::abs(norm(Vec2{rows[k][x], rows[k][x + 1]}) - norm(branches[k])) > most_deviation * norm(branches[k])) return false;
  return true;
}

bool all_zero(const std::vector<NumberRow>& rows, std::size_t c) {
  return std::ranges::all_of(rows, [&](const NumberRow& row) { return row[c] == 0; });
}

}  // namespace

std::vector<std::size_t> find_pair_columns(const std::vector<std::vector<std::string_view>>& rows, const std::vector<std::size_t>& candidates,
                                           const RawGrains& grains) {
  const auto numbers = numbers_of(rows, candidates);
  const std::size_t n = candidates.size();
  if (numbers.empty() || n < 6) return {};
  const PairGeometry geometry(grains);
  const auto are_grains = [&](std::size_t c) { return std::ranges::all_of(numbers, [&](const NumberRow& row) { return geometry.is_grain(row[c]); }); };
  std::size_t i = 0;
  while (i + 1 < n && !(are_grains(i) && are_grains(i + 1) && std::ranges::none_of(numbers, [&](const NumberRow& row) { return row[i] == row[i + 1]; }))) ++i;
  if (i + 1 >= n) return {};
  const auto branches = mapped(numbers, [&](const NumberRow& row) { return geometry.branch(row[i], row[i + 1]); });
  for (std::size_t x = 0; x + 1 < n; ++x) {
    if (x + 1 >= i && x <= i + 1) continue;
    if (!lies(numbers, branches, x, x + 1, true) || are_branches(numbers, branches, x)) continue;
    const auto with = [&](std::size_t p) {
      return std::vector{candidates[i], candidates[i + 1], candidates[x], candidates[x + 1], candidates[p], candidates[p + 1]};
    };
    for (std::size_t p = x + 2; p + 1 < n; ++p)
      if (lies(numbers, branches, p, p + 1, false)) return with(p);
    // Without friction all is zero: behind fx and fy, or behind fz too where as many follow as fz, p1, p2 and p3 are.
    const std::size_t p = n - (x + 2) >= 4 ? x + 3 : x + 2;
    if (p + 1 < n && all_zero(numbers, p) && all_zero(numbers, p + 1)) return with(p);
  }
  return {};
}

}  // namespace arenite::io
