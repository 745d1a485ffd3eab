#pragma once
#include <array>
#include <concepts>
#include <cstdint>
#include <functional>
#include <limits>
#include <vector>

#include "core/threads.hpp"
#include "grains/dem/bounds.hpp"
#include "grains/dem/contact_list.hpp"
#include "model/packing.hpp"
#include "model/result.hpp"

namespace arenite {
class Problems;
}

namespace arenite::dem {

template <int D> struct Kinematics;
template <int D> struct Mover;

/// All that a part of a sample may say: whatever a sample can have beside single disks (or spheres), walls and their
/// contacts is a part. This one says nothing; parts begin with it and say what they have to (PartsOf in parts.hpp lists
/// them). A part keeps its own state; everything of the sample it is handed.
template <int D> struct PartOf {
  using S = SampleIn<D>;
  std::size_t first_force = 0;  ///< where the part's own forces begin among those of parts; set with the list

  // Making a sample: what is wrong with the input; what a part has before the disks are placed, which may put other
  // disks in the place of the caller's grains (S::start); what follows from the disks; what the packing remembers, once
  // the list is there.
  static void check(Problems&, const PackingIn<D>&, const ContactParameters&, const IntegrationParameters&) {}
  void make(S&, const PackingIn<D>& /*given*/) {}
  void set_up(S&) {}
  void recall(S&) {}

  // The list of contacts. How far a part reaches beyond touch, m, and with what it pulls two disks of a slot together,
  // N; the least side of a periodic cell that it fits, m; the farthest way of what it has since the list was built, m.
  double reach() const { return 0; }
  double pull_of(std::size_t /*slot*/) const { return 0; }
  double least_cell(const S&) const { return 0; }
  double way_since_listed(const S&) const { return 0; }
  // Before a list is replaced: throws CannotGoOn for what has gone wrong since it was built; puts what has left a
  // periodic cell back.
  void check_list(const S&) const {}
  void wrap(S&) {}
  // While a list is made: the disks have new numbers; slots behind those of pairs; partners of a disk beside the walls;
  // slots behind all others, and places for what it remembers of a slot, which it takes over from the slot of a former
  // list. After that in a running sample.
  void number(S&) {}
  void list_pairs(S&, const ThreadPool&) {}
  void find_near(const S&, std::size_t /*disk*/, std::vector<std::int32_t>& /*partners*/) const {}
  void list_others(S&) {}
  bool remembers() const { return false; }
  void take_over(std::size_t /*slot*/, std::size_t /*former*/) {}
  void renew(S&) {}
  // Whether a part lets two disks meet, holds a grain on a wall (on which side, else -1), joins two disks of the start
  // however deep they lie in each other; whether a slot stands for a polygon.
  bool lets_meet(const S&, std::int32_t /*i*/, std::int32_t /*j*/) const { return true; }
  int holding_side(std::int32_t /*grain*/) const { return -1; }
  bool joins(std::int32_t /*a*/, std::int32_t /*b*/) const { return false; }
  bool is_foot(const S&, std::size_t /*slot*/) const { return false; }
  // Puts images that a part has beside the ghosts where they are.
  void refresh(S&) {}

  // Forces beside those of contacts: how many have a place in the list of forces; calls of `see(i, j, n)` for the two
  // disks that the n-th of them joins.
  std::size_t force_count() const { return 0; }
  void each_force(const std::function<void(std::int32_t, std::int32_t, std::size_t)>&) const {}
  // Before the forces of contacts are evaluated; adds to them afterwards; adds to the forces on walls, and to the sums
  // of force times branch.
  void before_forces(S&) {}
  void add_forces(S&, const ThreadPool&) {}
  void add_to_walls(S&) const {}
  void add_moments(const S&, std::array<Vec<D>, D>&) const {}
  // How a disk meets a partner that is neither disk nor wall (false of other slots), and how fast that turns, rad/s.
  bool meet(const S&, std::size_t /*slot*/, Kinematics<D>&) const { return false; }
  Turning<D> spin_of(const S&, std::int32_t /*partner*/) const { return {}; }

  // Rates that bound the time step: 1/s^2 and 1/s that a part adds to those of the contacts; those of movers that it
  // has, if these are higher; its shortest contact time, s; the steepest slope that it adds to a contact, N/m.
  double steepest_slope() const { return 0; }
  Rates added_rates(const S&) const { return {}; }
  void raise_rates(const S&, const SlopesOf<D>&, Rates&) const {}
  double shortest_time(const S&, const std::function<double(double)>& /*tangent*/) const {
    return std::numeric_limits<double>::infinity();
  }

  // Motion. Before an integrator starts and after it has; before a step and after its motion; after its forces.
  void prepare(S&) {}
  void begin(S&) {}
  void before_step(S&) {}
  void after_step(S&) {}
  void after_forces(S&) {}
  // Whether it drives the sample, so that its force-controlled walls have to follow.
  bool drives(const S&) const { return false; }
  // Before a change of load: the step under way is not booked on; what moves for itself beside disks, as it is at the
  // present, is noted before anything is brought there, and then put there with the domain of the present.
  void break_step(S&) {}
  void note_present(S&) {}
  void go_to_present(S&, const DomainIn<D>& /*now*/) {}
  // A cell whose shear becomes faster, by so many m/s at a height; disks with new masses; coefficients of listed
  // contacts that follow from these.
  void shear(S&, const std::function<double(double)>& /*faster_at*/) {}
  void take_masses(S&) {}
  void renew_dashpots(S&) {}
  // A kick of what moves for itself beside disks, s; the way that it makes in a time, s; then what goes with walls or
  // bodies (false if the list has become stale). Whether all disks go so.
  void kick(S&, double /*kick*/, double /*ahead*/) {}
  void move(S&, double /*time*/) {}
  bool follow(S&, const SweepTask<D>&, const ThreadPool&) { return true; }
  bool moves_all_disks(const S&) const { return false; }
  // The domain as it is at the time of the places.
  void bring_to_now(const S&, DomainIn<D>&) const {}

  // Grains of several disks, of which single disks know nothing. The caller's grains, where `start` has others; the
  // body (-1: none) and the caller's grain of a disk of `start`; how many bodies there are, and what they are like.
  const GrainsIn<D>* given() const { return nullptr; }
  std::int32_t body_of(std::int32_t /*disk*/) const { return -1; }
  std::int32_t grain_of(std::int32_t disk) const { return disk; }
  std::size_t bodies() const { return 0; }
  void put_mover(std::size_t /*body*/, Mover<D>&) const {}
  void put_load(const S&, std::size_t /*body*/, Load<D>&) const {}
  void put_levers(const S&, std::size_t /*slot*/, Levers<D>&) const {}

  // Calls of `see(i, j, size)` for the disks that forces beside contacts join which act, with their sizes, N. The
  // fastest point of what moves as it is told, m/s. Whether it gives way to the sample along an axis, and nothing else
  // holds this there, so that it may go on as a whole for ever.
  void each_joint(const S&, const std::function<void(std::int32_t, std::int32_t, double)>&) const {}
  double fastest_point(const S&) const { return 0; }
  bool lets_drift(const S&, int /*axis*/) const { return false; }

  // Energies of now; a contact of a report and the report itself; every bit that decides its future, in a state that is
  // stored, and what of that belongs to the slots of the list.
  void add_energy(const S&, Energies&) const {}
  void report_contact(const S&, std::size_t /*slot*/, bool /*swapped*/, PackingIn<D>&) const {}
  void report(const S&, PackingIn<D>&) const {}
  // After the state has been restored.
  void go_on(S&) {}
  template <class Members> void transfer(S&, Members&) {}
  template <class Members> void transfer_listed(S&, Members&) {}
};

/// What takes no member anywhere: stands for those of save.cpp in the concept.
struct NoMembers {
  template <class... Member> void operator()(Member&...) {}
  static bool reads() { return false; }
  static void expect(bool /*sound*/) {}
};

/// What the engine calls of each part.
template <class P, int D>
concept Part = requires(P p, const P q, SampleIn<D>& s, const SampleIn<D>& now, const ThreadPool& pool,
                        const PackingIn<D>& given, Problems& problems, const ContactParameters& contact,
                        const IntegrationParameters& integration, PackingIn<D>& out, Energies& energies,
                        std::vector<std::int32_t>& partners, std::array<Vec<D>, D>& moments, Kinematics<D>& kinematics,
                        const SlopesOf<D>& slopes, Rates& rates, const SweepTask<D>& task, DomainIn<D>& domain,
                        Mover<D>& mover, Load<D>& load, Levers<D>& levers, std::size_t n, std::int32_t k, double x,
                        NoMembers& members) {
  // checks
  P::check(problems, given, contact, integration), p.make(s, given), p.set_up(s), p.recall(s);
  // lists
  { q.reach() } -> std::same_as<double>;
  { q.pull_of(n) } -> std::same_as<double>;
  { q.least_cell(now) } -> std::same_as<double>;
  { q.way_since_listed(now) } -> std::same_as<double>;
  q.check_list(now), p.wrap(s), p.number(s), p.list_pairs(s, pool), q.find_near(now, n, partners), p.list_others(s);
  p.take_over(n, n), p.renew(s), p.refresh(s);
  { q.remembers() } -> std::same_as<bool>;
  { q.lets_meet(now, k, k) } -> std::same_as<bool>;
  { q.holding_side(k) } -> std::same_as<int>;
  { q.joins(k, k) } -> std::same_as<bool>;
  { q.is_foot(now, n) } -> std::same_as<bool>;
  // adds to forces
  { p.first_force } -> std::same_as<std::size_t&>;
  { q.force_count() } -> std::same_as<std::size_t>;
  q.each_force([](std::int32_t, std::int32_t, std::size_t) {});
  p.before_forces(s), p.add_forces(s, pool), q.add_to_walls(s), q.add_moments(now, moments);
  { q.meet(now, n, kinematics) } -> std::same_as<bool>;
  { q.spin_of(now, k) } -> std::same_as<Turning<D>>;
  // adds to rates
  { q.steepest_slope() } -> std::same_as<double>;
  { q.added_rates(now) } -> std::same_as<Rates>;
  q.raise_rates(now, slopes, rates);
  {
    q.shortest_time(now, [](double) { return 0.0; })
    } -> std::same_as<double>;
  // moves
  p.break_step(s), p.note_present(s), p.go_to_present(s, domain), p.take_masses(s), p.renew_dashpots(s);
  p.shear(s, [](double) { return 0.0; });
  q.each_joint(now, [](std::int32_t, std::int32_t, double) {});
  { q.fastest_point(now) } -> std::same_as<double>;
  { q.lets_drift(now, 0) } -> std::same_as<bool>;
  p.prepare(s), p.begin(s), p.before_step(s), p.after_step(s), p.after_forces(s), p.kick(s, x, x), p.move(s, x);
  { q.drives(now) } -> std::same_as<bool>;
  { p.follow(s, task, pool) } -> std::same_as<bool>;
  { q.moves_all_disks(now) } -> std::same_as<bool>;
  q.bring_to_now(now, domain);
  // grains of several disks
  { q.given() } -> std::same_as<const GrainsIn<D>*>;
  { q.body_of(k) } -> std::same_as<std::int32_t>;
  { q.grain_of(k) } -> std::same_as<std::int32_t>;
  { q.bodies() } -> std::same_as<std::size_t>;
  q.put_mover(n, mover), q.put_load(now, n, load), q.put_levers(now, n, levers);
  // weighs in energy, reports, stores
  q.add_energy(now, energies), q.report_contact(now, n, true, out), q.report(now, out);
  p.go_on(s), p.transfer(s, members), p.transfer_listed(s, members);
};

}  // namespace arenite::dem
