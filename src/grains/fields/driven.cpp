#include "grains/fields/driven.hpp"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "core/mapped.hpp"
#include "grains/dem/programme.hpp"

namespace arenite::fields {
namespace {

using dem::Programme;

const Programme* programme_driving(const dem::Stage& stage, dem::Driven of) {
  const auto at = std::ranges::find(stage.programmes, of, &Programme::of);
  return at == stage.programmes.end() ? nullptr : &*at;
}

void put(History& rows, const std::string& name, const char* unit, std::vector<double> values) {
  if (!rows.find(name)) rows.columns.push_back({name, unit, std::move(values)});
}

void add_to(History& rows, const dem::Stage& stage, double begin) {
  const std::vector<double>* column = rows.find("time");
  if (!column || column->empty()) return;
  const std::vector<double> time = *column;  // columns move when others are added
  for (int side = 0; side < static_cast<int>(stage.slide.size()); ++side) {
    const Programme* own = programme_driving(stage, {Programme::What::slide, side});
    const double speed = stage.slide[static_cast<std::size_t>(side)];
    const auto way = [&](double t) { return own ? dem::integral(*own, t - begin) : speed * (t - begin); };
    if (own || speed != 0)
      put(rows, std::string(any_side_names[static_cast<std::size_t>(side)]) + "_slid", "m", mapped(time, way));
  }
  if (!stage.gravity || (!programme_driving(stage, {Programme::What::gravity_size}) &&
                         !programme_driving(stage, {Programme::What::gravity_angle})))
    return;
  const auto gravity = mapped(time, [&](double t) { return dem::gravity_at(stage, t - begin); });
  put(rows, "gravity_x", "m/s^2", mapped(gravity, &Vec2::x));
  put(rows, "gravity_y", "m/s^2", mapped(gravity, &Vec2::y));
}

}  // namespace

template <int D> double begin_of(const StageResultIn<D>& result, const dem::Stage& stage) {
  const std::vector<double>* time = result.history.find("time");
  if (result.began) return *result.began;
  if (!time || time->empty()) return 0;
  return stage.duration ? time->back() - *stage.duration : time->front();
}

template <int D> double length_of(const StageResultIn<D>& result, const dem::Stage& stage) {
  const std::vector<double>* time = result.history.find("time");
  if (!stage.duration || !result.began || !time || time->empty()) return stage.duration.value_or(0);
  return time->back() - *result.began;
}

template <int D> void add_driven(StageResultIn<D>& result, const dem::Stage& stage) {
  const double begin = begin_of(result, stage);
  add_to(result.history, stage, begin);
  add_to(result.cycles, stage, begin);
}

#define ARENITE_OF(D)                                                    \
  template double begin_of(const StageResultIn<D>&, const dem::Stage&);  \
  template double length_of(const StageResultIn<D>&, const dem::Stage&); \
  template void add_driven(StageResultIn<D>&, const dem::Stage&);
ARENITE_OF(2)
ARENITE_OF(3)
#undef ARENITE_OF

std::vector<Vec2> gravity_in(const History& rows, const Asked& asked) {
  const auto *x = rows.find("gravity_x"), *y = rows.find("gravity_y");
  std::vector<Vec2> gravity(rows.columns.empty() ? 0 : rows.columns.front().values.size(), asked.gravity);
  for (std::size_t k = 0; x && y && k < gravity.size(); ++k) gravity[k] = {(*x)[k], (*y)[k]};
  return gravity;
}

double gravity_size(const Asked& asked) { return asked.known ? norm(asked.gravity) : statistics::unknown; }

}  // namespace arenite::fields
