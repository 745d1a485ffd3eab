#include "grains/dem/neighbours.hpp"

#include <cmath>
#include <numeric>
#include <string>

#include "core/cannot_go_on.hpp"
#include "core/error.hpp"
#include "grains/dem/carried.hpp"
#include "grains/dem/cells.hpp"

namespace arenite::dem {

namespace {

void check_places(const Sample& s) {
  for (std::size_t k = 0; k < s.count; ++k) {
    const auto& d = s.record[k];
    const char* fault = nullptr;
    if (!std::isfinite(d.x + d.y + d.vx + d.vy + d.omega)) fault = " has a coordinate or velocity that is not finite";
    for (int side = 0; side < 4 && !fault; ++side) {
      const auto& wall = s.domain.wall[static_cast<std::size_t>(side)];
      const double place = side < bottom ? d.x : d.y;
      const double inside = (side % 2 == 0) ? place - wall.position : wall.position - place;
      if (wall.present && inside < 0) fault = " has left the frame through a wall";
    }
    if (fault) {
      const auto id = s.start.grains.id[static_cast<std::size_t>(d.grain)];
      const std::string what = "grain " + std::to_string(id) + fault;
      if (s.step == 0) throw InputError(what + " before the first step; correct its place, or the frame");
      throw CannotGoOn(what + " at step " + std::to_string(s.step) + "; a smaller time step or a gentler load is needed");
    }
  }
}

/// A grain that crosses a periodic edge goes on at the opposite one; its own velocity is without the affine motion and
/// does not change, the seen velocity is renewed by the caller's next refresh.
void wrap(Sample& s) {
  const auto& w = s.domain.wall;
  const double width = s.domain.width(), height = s.domain.height();
  const AffineMotion mx = affine_x(s.domain), my = affine_y(s.domain);
  for (std::size_t k = 0; k < s.count; ++k) {
    auto& d = s.record[k];
    if (s.domain.periodic_y) {
      const double n = std::floor((d.y - w[bottom].position) / height);
      const double y = d.y - n * height;
      d.vy += my.at(y) - my.at(d.y);
      d.y = y;
      d.x -= n * s.domain.tilt;
    }
    if (s.domain.periodic_x) {
      const double x = d.x - std::floor((d.x - w[left].position) / width) * width;
      d.vx += mx.at(x) - mx.at(d.x);
      d.x = x;
    }
  }
}

template <class T>
void permute(std::vector<T>& values, const std::vector<std::int32_t>& order) {
  if (values.empty()) return;
  std::vector<T> old(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(order.size()));
  for (std::size_t k = 0; k < order.size(); ++k) values[k] = old[static_cast<std::size_t>(order[k])];
}

/// Returns the former number of every disk.
std::vector<std::int32_t> sort_by_cell(Sample& s) {
  const CellGrid grid = grid_of(s);
  std::vector<std::int32_t> first(grid.size() + 1, 0), cell(s.count), order(s.count);
  for (std::size_t k = 0; k < s.count; ++k) {
    cell[k] = grid.cell(s.record[k].x, s.record[k].y);
    ++first[static_cast<std::size_t>(cell[k]) + 1];
  }
  std::partial_sum(first.begin(), first.end(), first.begin());
  for (std::size_t k = 0; k < s.count; ++k)
    order[static_cast<std::size_t>(first[static_cast<std::size_t>(cell[k])]++)] = static_cast<std::int32_t>(k);
  s.record.resize(s.count);
  permute(s.record, order);
  for (auto* a : {&s.vx, &s.vy, &s.omega, &s.angle, &s.ax, &s.ay, &s.alpha}) permute(*a, order);
  for (auto& a : s.higher) permute(a, order);
  return order;
}

}  // namespace

void rebuild_list(Sample& s, const Team& team) {
  check_places(s);
  wrap(s);
  const std::vector<std::int32_t> was = sort_by_cell(s);
  s.listed_x.resize(s.count);
  s.listed_y.resize(s.count);
  for (std::size_t k = 0; k < s.count; ++k) {
    s.listed_x[k] = s.record[k].x;
    s.listed_y[k] = s.record[k].y;
  }
  s.listed_domain = s.domain;
  ++s.builds;
  std::swap(s.list, s.former);
  list_contacts(s, team);
  carry_over(s, s.former, was, team);
}

double list_leeway(const Sample& s) {
  for (std::size_t side = 0; side < 4; ++side) {
    const bool periodic = side < bottom ? s.domain.periodic_x : s.domain.periodic_y;
    const double moved = std::abs(s.domain.wall[side].position - s.listed_domain.wall[side].position);
    if (!periodic && moved > 0.5 * s.skin) return 0;
  }
  const CellFrame then = cell_frame(s.listed_domain), now = cell_frame(s.domain);
  return 0.5 * (s.skin - reach_of(s) * (std::abs(now.width / then.width - 1) * now.periodic_x +
                                        std::abs(now.height / then.height - 1) * now.periodic_y));
}

}  // namespace arenite::dem
