#pragma once
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/random.hpp"
#include "model/packing.hpp"
#include "support/pressed_crystal.hpp"

namespace arenite::test {

/// Disks of two materials and sizes pressed together at random between four walls, at the largest load of a cycle, with
/// forces that are in balance to rounding. Found by relaxing soft disks in a container that shrinks: no code of the
/// program's discrete elements has a part in it.
class LaboratorySample {
 public:
  explicit LaboratorySample(std::size_t grains, std::uint64_t seed = 1, double mean_force = 1300)
      : random_(seed, Purpose::test, 61) {
    packing.materials = {{"POM", 1410, 27.35e6, 0.0150e-6}, {"HDPE", 950, 6.43e6, 0.0258e-6}};
    packing.domain.thickness = 0.06;
    scatter(grains);
    while (press() < 1.5e-3) shrink(0.997);
    list_contacts();
    drop_rattlers();
    put_forces(mean_force);
  }

  /// Normal force on the lower wall, N.
  double load() const {
    double sum = 0;
    for (std::size_t c = 0; c < packing.contacts.size(); ++c)
      if (packing.contacts.is_wall(c) && packing.contacts.wall_side(c) == bottom) sum += packing.contacts.fn[c];
    return sum;
  }

  Packing packing;

 private:
  Grains& g() { return packing.grains; }
  double width() { return packing.domain.wall[right].position; }

  void scatter(std::size_t n) {
    g().resize(n);
    double area = 0;
    for (std::size_t i = 0; i < n; ++i) {
      g().id[i] = static_cast<std::int64_t>(i) + 1;
      g().material[i] = static_cast<std::int32_t>(i % 2);
      g().radius[i] = i % 2 == 0 ? 8.2e-3 : 6.0e-3;
      area += std::numbers::pi * g().radius[i] * g().radius[i];
    }
    packing.domain.wall[right].position = packing.domain.wall[top].position = std::sqrt(area / 0.7);
    for (auto& p : g().position) p = {random_.uniform(0, width()), random_.uniform(0, width())};
  }

  void shrink(double by) {
    packing.domain.wall[right].position *= by, packing.domain.wall[top].position *= by;
    for (auto& p : g().position) p = by * p;
  }

  /// Calls see(i, j or wall partner, normal into i, overlap) for everything that overlaps.
  template <class See> void each_overlap(const See& see) {
    const auto n = static_cast<std::int32_t>(g().size());
    for (std::int32_t i = 0; i < n; ++i) {
      const auto a = static_cast<std::size_t>(i);
      for (std::int32_t j = i + 1; j < n; ++j) {
        const auto b = static_cast<std::size_t>(j);
        const Vec2 d = g().position[a] - g().position[b];
        if (const double over = g().radius[a] + g().radius[b] - norm(d); over > 0) see(i, j, (1 / norm(d)) * d, over);
      }
      for (int side = 0; side < sides; ++side)
        if (const double over = g().radius[a] - packing.domain.depth(side, g().position[a]); over > 0)
          see(i, wall_partner(side), inward_normal(side), over);
    }
  }

  /// Moves overlapping disks apart; returns the mean overlap over the mean radius that is left.
  double press() {
    std::vector<Vec2> way(g().size()), speed(g().size());
    double mean = 0;
    for (int round = 0; round < 4000; ++round) {
      std::fill(way.begin(), way.end(), Vec2{});
      double sum = 0, count = 0;
      each_overlap([&](std::int32_t i, std::int32_t j, Vec2 n, double over) {
        way[static_cast<std::size_t>(i)] += over * n;
        if (j >= 0) way[static_cast<std::size_t>(j)] -= over * n;
        sum += over, count += 1;
      });
      mean = count > 0 ? sum / count / 7e-3 : 0;
      double most = 0;
      for (std::size_t i = 0; i < g().size(); ++i) {
        speed[i] = 0.8 * speed[i] + 0.3 * way[i];
        g().position[i] += speed[i];
        most = std::max(most, norm(way[i]));
      }
      if (most < 1e-9) break;
    }
    return mean;
  }

  void list_contacts() {
    each_overlap([&](std::int32_t i, std::int32_t j, Vec2 n, double over) {
      const double r = g().radius[static_cast<std::size_t>(i)];
      packing.contacts.add(i, j, n, over, 0, r - 0.5 * over,
                           j >= 0 ? g().radius[static_cast<std::size_t>(j)] - 0.5 * over : 0);
    });
  }

  void drop_rattlers() {
    for (bool again = true; again;) {
      std::vector<int> touches(g().size(), 0);
      const Contacts all = packing.contacts;
      for (std::size_t c = 0; c < all.size(); ++c) {
        ++touches[static_cast<std::size_t>(all.i[c])];
        if (!all.is_wall(c)) ++touches[static_cast<std::size_t>(all.j[c])];
      }
      packing.contacts = {};
      for (std::size_t c = 0; c < all.size(); ++c) {
        const bool loose = touches[static_cast<std::size_t>(all.i[c])] < 3 ||
                           (!all.is_wall(c) && touches[static_cast<std::size_t>(all.j[c])] < 3);
        if (!loose) packing.contacts.add(all.i[c], all.j[c], all.normal[c], all.fn[c], 0, all.arm_i[c], all.arm_j[c]);
      }
      again = packing.contacts.size() < all.size();
    }
  }

  /// Near to those of the soft disks, with shares of friction, and in balance.
  void put_forces(double mean_force) {
    Contacts& contacts = packing.contacts;
    double mean = 0;
    for (const double f : contacts.fn) mean += f / static_cast<double>(contacts.size());
    std::vector<double> wanted;
    for (const double f : contacts.fn) {
      const double fn = mean_force * f / mean * (1 + 0.25 * random_.normal());
      wanted.push_back(fn), wanted.push_back(0.15 * fn * random_.normal());
    }
    put_balanced_forces(packing, wanted);
  }

  RandomStream random_;
};

}  // namespace arenite::test
