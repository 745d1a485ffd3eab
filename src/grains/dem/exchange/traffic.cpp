#include "grains/dem/exchange/traffic.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <variant>
#include <vector>

#include "core/error.hpp"
#include "core/random.hpp"
#include "geometry/rectangle.hpp"
#include "grains/dem/exchange/change_grains.hpp"
#include "grains/dem/integrators/time_step.hpp"
#include "grains/dem/setup.hpp"

namespace arenite::dem {
namespace {

/// The area with its edges, those of the container where none are given.
geometry::Rectangle in_container(const Area& area, const Domain& domain) {
  const auto side = [&](int which) { return domain.wall[which].position; };
  return {area.left.value_or(side(left)), area.right.value_or(side(right)), area.bottom.value_or(side(bottom)),
          area.top.value_or(side(top))};
}

/// Where there is room for another disk in an area.
class Room {
 public:
  Room(Sample& s, const Area& area, const std::vector<NewGrain>& added, const std::vector<MovedGrain>& moved,
       double largest)
      : s_(s),
        area_(in_container(area, s.domain)) {
    const double reach = largest + s.largest_radius;
    const Vec2 middle = area_.middle();
    const auto look_at = [&](Vec2 place, double radius) {
      const Vec2 way = s.domain.nearest_image(place - middle);
      if (std::abs(way.x) < 0.5 * area_.width() + reach && std::abs(way.y) < 0.5 * area_.height() + reach)
        near_.push_back({place, radius});
    };
    for (std::size_t k = 0; k < s.count; ++k) look_at(s.record[k].place, s.record[k].radius);
    for (const NewGrain& each : added) look_at(each.place, each.radius);
    for (const MovedGrain& each : moved) look_at(each.place, s.record[each.disk].radius);
  }

  /// A place for a disk, which it then takes; none where so many at random are taken.
  std::optional<Vec2> take(double radius, std::uint64_t seed) {
    constexpr int most = 100;
    for (int n = 0; n < most; ++n) {
      RandomStream random(seed, Purpose::inflow_place, static_cast<std::uint64_t>(s_.exchanged.tries++));
      const double x = within(area_.x_min, area_.x_max, radius, random.uniform()),
                   y = within(area_.y_min, area_.y_max, radius, random.uniform());
      if (!is_free({x, y}, radius)) continue;
      near_.push_back({{x, y}, radius});
      return Vec2{x, y};
    }
    return std::nullopt;
  }

 private:
  struct Disk {
    Vec2 place;
    double radius;
  };

  /// As far from both ends as the radius; else in the middle.
  static double within(double low, double high, double radius, double share) {
    const double slack = high - low - 2 * radius;
    return slack > 0 ? low + radius + share * slack : 0.5 * (low + high);
  }

  bool is_free(Vec2 place, double radius) const {
    for (int side = 0; side < sides; ++side)
      if (s_.domain.wall[side].present && s_.domain.depth(side, place) < radius) return false;
    for (const Disk& other : near_)
      if (norm(s_.domain.nearest_image(place - other.place)) < radius + other.radius) return false;
    return std::ranges::none_of(s_.domain.boundaries, [&](const Boundary& b) { return is_met(b, place, radius); });
  }

  bool is_met(const Boundary& boundary, Vec2 place, double radius) const {
    const auto& points = boundary.points;
    const std::size_t n = points.size();
    for (std::size_t k = 0; boundary.present && k + (boundary.closed ? 0 : 1) < n; ++k) {
      const Vec2 to_start = s_.domain.nearest_image(points[k] - place), a = place + to_start,
                 b = a + points[(k + 1) % n] - points[k];
      if (norm(place - geometry::nearest_on_segment(a, b, place)) < radius) return true;
    }
    return false;
  }

  Sample& s_;
  geometry::Rectangle area_;
  std::vector<Disk> near_;
};

double mass_drawn(const Sample& s, const NewGrain& grain) {
  return mass_of(s.start.materials[grain.material].density, grain.radius, s.domain);
}

void take_out(Sample& s, const Exchange& exchange, GrainChanges& changes) {
  ExchangeAccount& account = s.exchanged;
  for (const Outlet& outlet : exchange.outlets) {
    std::optional<Room> room;
    bool full = false;
    for (std::size_t k = 0; k < s.count; ++k) {
      const DiskRecord& d = s.record[k];
      const auto disk = static_cast<std::int32_t>(k);
      const auto is_of = [&](const MovedGrain& moved) { return moved.disk == disk; };
      if (!outlet.area.holds(d.place) || std::ranges::count(changes.removed, disk) > 0 ||
          std::ranges::any_of(changes.moved, is_of))
        continue;
      const double mass = own_mass(s, d.grain);
      if (!outlet.recycle_to) {
        if (changes.removed.size() + 1 == s.count) continue;  // a sample has a grain at least
        changes.removed.push_back(disk);
        account.removed.add(mass);
        continue;
      }
      if (!room) room.emplace(s, *outlet.recycle_to, changes.added, changes.moved, s.largest_radius);
      const auto place = full ? std::nullopt : room->take(d.radius, exchange.seed);
      full = full || !place;
      if (full) ++account.waiting;
      else {
        changes.moved.push_back({disk, *place, outlet.velocity});
        account.removed.add(mass);
        account.inserted.add(mass);
      }
    }
  }
}

/// The next grain of an inflow, without a place: its population by the shares of their numbers, its size by its law.
NewGrain draw(const Sample& s, const Inflow& inflow, std::size_t n, std::int64_t number, std::uint64_t seed) {
  const auto share = [](const packing::Population& p) {
    return p.ratio ? *p.ratio : static_cast<double>(p.count.value_or(0));
  };
  double total = 0;
  for (const auto& p : inflow.of) total += share(p);
  RandomStream random(seed, Purpose::inflow,
                      (static_cast<std::uint64_t>(n) << 40) + static_cast<std::uint64_t>(number));
  std::size_t which = 0;
  double left = random.uniform() * (total > 0 ? total : static_cast<double>(inflow.of.size()));
  for (; which + 1 < inflow.of.size(); ++which) {
    left -= total > 0 ? share(inflow.of[which]) : 1.0;
    if (left < 0) break;
  }
  const packing::Population& of = inflow.of[which];
  NewGrain grain;
  grain.velocity = inflow.velocity;
  grain.radius = 0.5 * std::visit([&](const auto& law) { return law.draw(number, random); }, of.size);
  grain.material = static_cast<std::int32_t>(index_of(s.start.materials, of.material));
  return grain;
}

double largest_radius(const Inflow& inflow) {
  double largest = 0;
  for (const auto& p : inflow.of)
    largest = std::max(largest, 0.5 * std::visit([](const auto& law) { return law.largest(); }, p.size));
  return largest;
}

/// Grains of an inflow that should be there by now: with half of one due it comes.
std::int64_t due_by(double rate, const Inflow& inflow, double since) {
  const auto due = static_cast<std::int64_t>(std::floor(rate * since + 0.5));
  return std::min(due, inflow.count.value_or(due));
}

void put_in(Sample& s, const Exchange& exchange, std::size_t n, double since, GrainChanges& changes) {
  const Inflow& inflow = exchange.inflow[n];
  ExchangeAccount& account = s.exchanged;
  Batch& through = account.through[n];
  std::optional<Room> room;
  for (;;) {
    if (inflow.rate && through.grains >= due_by(*inflow.rate, inflow, since)) return;
    if (through.grains >= inflow.count.value_or(std::numeric_limits<std::int64_t>::max())) return;
    NewGrain grain = draw(s, inflow, n, account.first_id + through.grains, exchange.seed);
    const double mass = mass_drawn(s, grain);
    if (inflow.mass_rate && through.mass + 0.5 * mass > *inflow.mass_rate * since) return;
    if (!room) room.emplace(s, inflow.area, changes.added, changes.moved, largest_radius(inflow));
    const auto place = room->take(grain.radius, exchange.seed);
    if (!place) {
      account.waiting += inflow.rate ? due_by(*inflow.rate, inflow, since) - through.grains
                                     : std::llround((*inflow.mass_rate * since - through.mass) / mass);
      return;
    }
    grain.place = *place;
    changes.added.push_back(grain);
    through.add(mass);
    account.inserted.add(mass);
  }
}

void require_area(const Area& area, const Domain& domain, const char* what) {
  const geometry::Rectangle r = in_container(area, domain), box = in_container({}, domain);
  const double slack = 1e-9 * (box.width() + box.height());
  if (r.x_min < box.x_min - slack || r.x_max > box.x_max + slack || r.y_min < box.y_min - slack ||
      r.y_max > box.y_max + slack || r.width() < 0 || r.height() < 0)
    throw InputError(
        fmt::format("{} lies from x = {:g} to {:g} mm and y = {:g} to {:g} mm, and the container from {:g} to {:g} mm "
                    "and {:g} to {:g} mm; give it edges within",
                    what, 1e3 * r.x_min, 1e3 * r.x_max, 1e3 * r.y_min, 1e3 * r.y_max, 1e3 * box.x_min, 1e3 * box.x_max,
                    1e3 * box.y_min, 1e3 * box.y_max));
}

void check(const Sample& s, const Exchange& exchange) {
  const char* reason = nullptr;
  if (!has_disks_only(s)) reason = "some are no disks";
  else if (!the<Bonds>(s).all.empty()) reason = "some are bonded";
  else if (!s.glued_pairs.empty()) reason = "some are glued";
  else if (!the<RoughWalls>(s).held.empty()) reason = "some go with a rough wall";
  else if (s.mass_scaling != MassScaling::none) reason = "their masses are scaled";
  else if (s.contact.is_cohesive() && !exchange.inflow.empty()) reason = "they cohere, so that none can be added";
  if (reason)
    throw InputError(
        fmt::format("grains can be exchanged only where all are single disks, unbonded, with their own "
                    "masses, and here {}; leave inflow and outlets out",
                    reason));
  for (const Inflow& inflow : exchange.inflow) {
    require_area(inflow.area, s.domain, "the area of an inflow");
    if (inflow.of.empty()) throw InputError("an inflow has no populations to draw grains from");
    for (const auto& p : inflow.of)
      if (index_of(s.start.materials, p.material) == s.start.materials.size())
        throw InputError(
            fmt::format("an inflow brings grains of \"{}\", which is no material of the sample", p.material));
  }
  for (const Outlet& outlet : exchange.outlets)
    if (outlet.recycle_to) require_area(*outlet.recycle_to, s.domain, "the area that an outlet recycles to");
}

/// A step that the lightest and the widest grains that may come allow as well, by a sample of these alone.
void allow_for(Sample& s, const Exchange& exchange) {
  Packing alone;
  alone.materials = s.start.materials;
  alone.domain.thickness = s.domain.thickness;
  double reach = 0;
  for (const Inflow& inflow : exchange.inflow)
    for (const auto& p : inflow.of)
      for (const double diameter : {std::visit([](const auto& law) { return law.smallest(); }, p.size),
                                    std::visit([](const auto& law) { return law.largest(); }, p.size)}) {
        const std::size_t g = alone.grains.size();
        alone.grains.resize(g + 1);
        alone.grains.radius[g] = 0.5 * diameter;
        alone.grains.material[g] = static_cast<std::int32_t>(index_of(s.start.materials, p.material));
        reach += diameter;
        alone.grains.position[g] = {2 * reach, reach};
      }
  if (alone.grains.size() == 0) return;
  alone.domain.wall[right].position = alone.domain.wall[top].position = 4 * reach;
  const Sample probe = make_sample(alone, s.contact, s.integration, *s.kernel);
  if (probe.dt < s.dt) change_step(s, probe.dt);
}

}  // namespace

void begin_exchange(Sample& s, const Exchange& exchange) {
  ExchangeAccount& account = s.exchanged;
  account.inserted = account.removed = {};
  account.waiting = 0;
  account.through.assign(exchange.inflow.size(), {});
  if (exchange.is_none()) return;
  check(s, exchange);
  if (!account.kept) account.next_id = std::ranges::max(s.start.grains.id) + 1;
  account.kept = true;
  account.first_id = account.next_id;
  allow_for(s, exchange);
}

void exchange_grains(Sample& s, const Exchange& exchange, double since, const ThreadPool& pool) {
  if (exchange.is_none()) return;
  s.exchanged.waiting = 0;
  GrainChanges changes;
  take_out(s, exchange, changes);
  for (std::size_t n = 0; n < exchange.inflow.size(); ++n) put_in(s, exchange, n, since, changes);
  change_grains(s, changes, pool);
}

double grains_due(const Sample& s, const Exchange& exchange, double time) {
  constexpr std::int64_t some = 1000;
  double due = 0;
  for (std::size_t n = 0; n < exchange.inflow.size(); ++n) {
    const Inflow& inflow = exchange.inflow[n];
    double mass = 0;
    for (std::int64_t k = 0; inflow.mass_rate && k < some; ++k) mass += mass_drawn(s, draw(s, inflow, n, k, 0)) / some;
    const double all = time * (inflow.rate ? *inflow.rate : *inflow.mass_rate / mass);
    due += std::min(all, static_cast<double>(inflow.count.value_or(std::numeric_limits<std::int64_t>::max())));
  }
  return due;
}

}  // namespace arenite::dem
