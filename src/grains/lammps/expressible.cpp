#include "grains/lammps/expressible.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <variant>

#include "grains/lammps/laws.hpp"

namespace arenite::lammps {
namespace {

using Sentences = std::vector<std::string>;

/// Adds a sentence where something is so.
void add(Sentences& to, bool is_so, const char* what, const char* why) {
  if (is_so) to.push_back(fmt::format("LAMMPS cannot run {}: {}", what, why));
}

/// Of a law with dashpots as given.
void add_dashpots(Sentences& to, const dem::ContactParameters& contact) {
  add(to, contact.sliding_viscosity && contact.normal_damping.value_or(0) <= 0, "contact.sliding_viscosity alone",
      "its dashpots have one number, and a share of it for sliding; give contact.normal_damping above 0 as well, or "
      "leave both out");
  if (!contact.normal_damping && damping_over_root(contact) >= largest_tsuji)
    to.push_back(
        fmt::format("LAMMPS cannot run contact.restitution = {:g}: its polynomial for the damping ends at "
                    "{:g} sqrt(m k), and this takes {:.3g}; ask for a higher restitution",
                    contact.restitution, largest_tsuji, damping_over_root(contact)));
}

void add_laws(Sentences& to, const dem::ContactParameters& contact, bool one_size) {
  add(to, contact.adheres(), "adhesion", "glued pairs have no granular style; leave out contact.adhesion");
  add(to, contact.is_cohesive(), "cohesion across gaps", "its granular styles have DMT and JKR in touch alone");
  add(to, contact.has_bonds(), "bonds that break by our law", "its bonds of grains know no such strength");
  add(to, !contact.rolling.is_none(), "rolling resistance",
      "the moments of its rolling springs cannot be asked back, so that the sample would lose them");
  add(to, std::holds_alternative<dem::Hertz>(contact.normal) && !one_size,
      "contact.normal = \"hertz\" of grains of several sizes",
      "its stiffness there hangs on radii, and LAMMPS has one for each two materials; \"hertz_mindlin\" does");
  add_dashpots(to, contact);
}

void add_loading(Sentences& to, const dem::Stage& stage) {
  const auto any = [](const auto& of) { return std::ranges::any_of(of, [](const auto& each) { return each != 0; }); };
  add(to, stage.increments > 1 || stage.snapshots > 1, "increments or states on the way",
      "it is handed one leg of a stage, from its beginning to its end; write a stage for each");
  add(to, stage.cycles || stage.strain_cycles, "cycles",
      "it is handed one increment after another that ends at rest or after a time");
  add(to, !stage.programmes.empty(), "programmes", "their tables are not among its variables");
  add(to, !stage.until.empty(), "`until`", "what it is judged by is measured here, after LAMMPS has ended");
  add(to, stage.shear_rate != 0, "a sheared cell", "its dashpots do not see the flow of the cell as ours do");
  add(to, any(stage.slide), "walls that slide", "the force along them could not be handed back with its springs");
  add(to, any(stage.rough) || any(stage.open), "rough or open walls",
      "they are walls of grains here, which no fix holds");
  add(to, std::ranges::any_of(stage.side, &dem::SideDrive::is_skin), "membranes",
      "it has none that yields under a pressure");
  add(to, !stage.boundaries.empty() || !stage.boundaries_in_space.empty(), "boundaries that move",
      "they are no walls of its granular fixes");
  add(to, !stage.exchange.is_none(), "grains that come and leave", "they are drawn from populations here");
  add(to, stage.bond || stage.glue, "glue and bonds", "they are made here");
}

void add_shapes(Sentences& to, const PackingIn<3>& start) {
  add(to, !start.domain.boundaries.empty(), "boundaries",
      "faces that spheres touch from both sides are no walls there");
}
void add_shapes(Sentences& to, const Packing& start) {
  add(to, !start.grains.shapes.empty(), "clumps and polygons", "its granular styles are of disks and spheres");
  add(to, !start.domain.boundaries.empty(), "boundaries", "lines that grains touch from both sides are no walls there");
  add(to, start.domain.tilt != 0, "a cell that is sheared already", "press it straight");
}

template <int D> void add_cell(Sentences& to, const PackingIn<D>& start, const dem::Stage& stage) {
  for (int axis = 0; axis < D; ++axis) {
    const auto &low = stage.side[2 * axis], &high = stage.side[2 * axis + 1];
    const bool moves = low.kind == dem::SideDrive::Kind::velocity || high.kind == dem::SideDrive::Kind::velocity;
    add(to, start.domain.periodic[axis] && moves && (low.presses() || high.presses()),
        "a periodic side that moves across from one that is pressed", "the cell has one length along an axis");
  }
}

}  // namespace

template <int D>
std::vector<std::string> inexpressible(const PackingIn<D>& start, const dem::ContactParameters& contact,
                                       const dem::IntegrationParameters& integration, const dem::Stage& stage) {
  Sentences found;
  const auto [least, most] = std::ranges::minmax_element(start.grains.radius);
  add_laws(found, contact, start.grains.size() == 0 || *least == *most);
  add(found, integration.track_energy, "integration.track_energy",
      "it keeps no account of what its dashpots dissipate");
  add_shapes(found, start);
  add_loading(found, stage);
  add_cell(found, start, stage);
  return found;
}

template <int D> double narrowest_part(const Container<D>& container, int processes) {
  const Vec<D> size = container.size();
  double least_surface = HUGE_VAL, narrowest = 0;
  for (int across = 1; across <= processes; ++across)
    for (int up = 1; processes % across == 0 && up <= processes / across; ++up) {
      const int deep = processes / (across * up);
      if (across * up * deep != processes || (D == 2 && deep > 1)) continue;
      const std::array<double, 3> part{size[0] / across, size[1] / up, D == 3 ? size[D - 1] / deep : HUGE_VAL};
      const double surface = 1 / part[0] + 1 / part[1] + 1 / part[2];  // of all cuts, over the volume
      if (surface >= least_surface) continue;
      least_surface = surface;
      narrowest = std::ranges::min(part);
    }
  return narrowest;
}
template double narrowest_part(const Container<2>&, int);
template double narrowest_part(const Container<3>&, int);

template std::vector<std::string> inexpressible(const Packing&, const dem::ContactParameters&,
                                                const dem::IntegrationParameters&, const dem::Stage&);
template std::vector<std::string> inexpressible(const PackingIn<3>&, const dem::ContactParameters&,
                                                const dem::IntegrationParameters&, const dem::Stage&);

}  // namespace arenite::lammps
