#include "grains/dem/engine.hpp"

#include <fmt/core.h>
#include <xxhash.h>

#include <algorithm>

#include "core/error.hpp"
#include "core/processor.hpp"
#include "grains/dem/bodies/bodies.hpp"
#include "grains/dem/bonds.hpp"
#include "grains/dem/boundaries/boundaries.hpp"
#include "grains/dem/neighbours.hpp"
#include "grains/dem/setup.hpp"
#include "grains/dem/walls.hpp"

namespace arenite::dem {

const Kernel& find_kernel(const std::string& asked) {
  const KernelChoice<Kernel> choice{portable_kernel, &avx2_kernel, &avx512_kernel};
  if (asked == "auto") return choice.best();
  if (const Kernel* kernel = choice.named(asked)) return *kernel;
  if (asked == avx2_kernel.name || asked == avx512_kernel.name)
    throw InputError(
        fmt::format("kernel \"{}\" is not supported by this processor; \"auto\" chooses the best one", asked));
  throw InputError(fmt::format("kernel \"{}\" is not one of auto, portable, avx2, avx512", asked));
}

namespace {

/// Threads that pay: two of them meet several times a step, which costs as much as some hundred disks.
int useful_threads(int asked, std::size_t disks) {
  constexpr std::size_t fewest_disks = 1000;
  return static_cast<int>(std::clamp<std::size_t>(disks / fewest_disks, 1, static_cast<std::size_t>(asked)));
}

}  // namespace

Engine::Engine(const Packing& start, const ContactParameters& contact, const IntegrationParameters& integration)
    : machine_(new Machine{make_sample(start, contact, integration, find_kernel(integration.kernel)),
                           ThreadPool(useful_threads(integration.threads, start.grains.size()))}) {}
Engine::~Engine() = default;
Engine::Engine(Engine&&) noexcept = default;
Engine& Engine::operator=(Engine&&) noexcept = default;

void synchronise(Sample& s) {
  s.balance.open = false;
  if (s.lag == 0 && !s.settled) return;
  // All is read before anything is set, for rates of walls hang on the places and velocities of disks.
  const Domain now = domain_now(s);
  std::vector<Motion<2>> moved;
  for (std::size_t b = 0; b < s.body.size(); ++b) moved.push_back(motion_of(s, s.count + b));
  for (std::size_t k = 0; k < s.count; ++k) {
    if (is_part(s, k)) continue;
    const Motion<2> own = motion_of(s, k);
    s.record[k].place = place_of(s, k);
    s.velocity.put(k, own.velocity);
    s.omega[k] = own.omega;
  }
  for (std::size_t b = 0; b < s.body.size(); ++b) s.body[b].own = moved[b];
  for (std::size_t b = 0; b < s.boundary.size(); ++b)
    s.boundary[b].rate = s.domain.boundaries[b].velocity = now.boundaries[b].velocity;
  for (int side = 0; side < sides; ++side) {
    s.wall[side].rate = now.wall[side].velocity;
    s.domain.wall[side].position = now.wall[side].position;
  }
  s.lag = 0;
  s.settled = false;
}

void Engine::set_gravity(Vec2 g) {
  Sample& s = machine_->sample;
  if (g.x == s.gravity.x && g.y == s.gravity.y) return;
  synchronise(s);
  s.gravity = g;
}

void Engine::set_drag(double rate) {
  Sample& s = machine_->sample;
  if (rate == s.drag) return;
  if (!(rate >= 0)) throw InputError(fmt::format("drag {} 1/s must be >= 0", rate));
  synchronise(s);
  s.drag = rate;
}

void Engine::set_mass_scaling(MassScaling masses) {
  Sample& s = machine_->sample;
  if (masses == s.mass_scaling) return;
  synchronise(s);
  book_change(s, &Energies::dissipated_drag, &Energies::kinetic, [&] {
    give_masses(s, masses);
    make_heavy_enough(s);
    allow_step(s, masses == MassScaling::uniform ? "scaled masses" : "its own masses");
  });
}

void Engine::set_shear_rate(double rate) {
  Sample& s = machine_->sample;
  if (rate == s.shear_rate) return;
  if (!s.domain.periodic[0] || !s.domain.periodic[1])
    throw InputError("a cell that is sheared must be periodic in x and y");
  check_still_cell(s, {}, true);
  synchronise(s);
  change_shear_rate(s, rate);
  refresh_ghosts(s);
}

void Engine::set_inertial_number(double number) {
  if (!(number > 0)) throw InputError(fmt::format("inertial number {} must be above 0", number));
  machine_->sample.inertial_number = number;
}

void Engine::set_friction(std::optional<double> mu) {
  if (mu && !(*mu >= 0)) throw InputError(fmt::format("friction {} must be a number >= 0", *mu));
  apply_friction(machine_->sample, mu);
}

void Engine::set_glue(bool on) {
  Sample& s = machine_->sample;
  if (on == s.glue) return;
  book_change(s, &Energies::dissipated_breakage, adhesive_energy<2>, [&] {
    s.glue = on;
    bond_touching_pairs(s);
  });
  s.balance.open = false;
}

void Engine::make_bonds() {
  Sample& s = machine_->sample;
  if (!s.contact.has_bonds()) throw InputError("bonds cannot be created if contact.bonds is \"none\"");
  synchronise(s);
  list_anew(s, machine_->pool);
  bond_near_pairs(s);
  list_anew(s, machine_->pool);
  const double wanted = s.integration.safety * shortest_bond_time(s);
  if (!s.integration.time_step && wanted < s.dt) change_step(s, wanted);
  allow_step(s, "its bonds");
}

BondCount Engine::bond_count() const {
  const Sample& s = machine_->sample;
  const auto count = [&](BondBreak how) {
    return static_cast<std::size_t>(std::ranges::count(s.bonds, how, &Bond::broken));
  };
  return {count(BondBreak::none), count(BondBreak::tension), count(BondBreak::bending), count(BondBreak::shear),
          bond_energy(s)};
}

CohesionCount Engine::cohesion_count() const {
  const std::vector<CohesivePair> pairs = cohesive_pairs(machine_->sample);
  return {pairs.size(), static_cast<std::size_t>(std::ranges::count_if(pairs, acts_across_gap))};
}

void Engine::set_drives(const WallDrives& asked) {
  Sample& s = machine_->sample;
  const WallDrives drives = under_programmes(s, asked);
  if (std::ranges::equal(drives, s.wall, {}, {}, &WallBody::drive)) return;
  check_still_cell(s, drives, false);
  synchronise(s);
  book_change(s, &Energies::dissipated_drag, servo_energy, [&] { apply_drives(s, drives); });
}

double Engine::time() const { return time_of(machine_->sample); }
std::int64_t Engine::step() const { return machine_->sample.step; }
double Engine::time_step() const { return machine_->sample.dt; }
StepBounds Engine::bounds() const { return step_bounds(machine_->sample); }
std::string Engine::kernel() const { return machine_->sample.kernel->name; }
std::size_t Engine::grain_count() const { return dem::grain_count(machine_->sample); }
std::int64_t Engine::list_builds() const { return machine_->sample.builds; }
double Engine::critical_drag() const { return dem::critical_drag(machine_->sample); }
double Engine::skin() const { return machine_->sample.skin; }
const IntegrationParameters& Engine::integration() const { return machine_->sample.integration; }
double Engine::shear_strain() const { return machine_->sample.sheared; }
const Domain& Engine::domain() const { return machine_->sample.domain; }
bool Engine::is_cohesive() const { return machine_->sample.contact.is_cohesive(); }
Packing Engine::packing() const { return packing_of(machine_->sample); }
Energies Engine::energies() const { return energies_of(machine_->sample); }
Equilibrium Engine::equilibrium() const { return equilibrium_of(machine_->sample); }
std::uint64_t Engine::state_hash() const {
  const auto bytes = save();
  return XXH3_64bits(bytes.data(), bytes.size());
}
std::vector<std::uint8_t> Engine::save() const { return save_sample(machine_->sample); }
void Engine::restore(const std::vector<std::uint8_t>& bytes) { restore_sample(machine_->sample, bytes); }

}  // namespace arenite::dem
