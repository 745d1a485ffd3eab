#include "workflow/measure_spheres.hpp"

#include <fmt/core.h>

#include <string>
#include <utility>
#include <vector>

#include "core/option.hpp"
#include "core/problems.hpp"
#include "core/version.hpp"
#include "grains/texture/spheres/spheres.hpp"
#include "statistics/correlation.hpp"
#include "thermal/imaging/proposed_contacts.hpp"

namespace arenite::workflow {

template <int D> std::string propose_contacts(io::SampleIn<D>& sample, double gap, const std::string& told) {
  PackingIn<D>& packing = sample.packing;
  const double mean_radius = statistics::mean_of_known(packing.grains.radius);
  if (gap > mean_radius)
    throw refusal("{}: {} is wider than the mean radius of the grains, {:.4g} m; grains so far apart do not touch",
                  option("touching"), told, mean_radius);
  packing.contacts = imaging::propose_contacts(packing.grains, packing.domain, {}, {.floor = 1, .pixel = gap});
  return gap > 0 ? "Grains are taken to touch where their surfaces are within " + told + " of each other"
                 : "The files have no contacts: grains are taken to touch where they overlap (" + option("touching") +
                       " gives a gap)";
}
template std::string propose_contacts<2>(io::Sample&, double, const std::string&);
template std::string propose_contacts<3>(io::SampleIn<3>&, double, const std::string&);

namespace {

/// What the contacts with each wall say of its force.
void add_wall_forces(PackingIn<3>& packing) {
  const ContactsIn<3>& contacts = packing.contacts;
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    if (!contacts.is_wall(c)) continue;
    const int side = contacts.wall_side(c);
    const Vec3 force = contacts.force_on_i(c);
    packing.domain.wall[side].force += inward_sign(side) * across(side, force);
    packing.domain.wall[side].shear_force -= along(side, force);
  }
}

}  // namespace

SphereResult measured_stage(io::SampleIn<3> sample, const Measuring& how, const std::string& title) {
  SphereResult stage;
  stage.name = stage.provenance.stage = "measured";
  stage.provenance.version = version;
  stage.provenance.title = title;
  stage.outcome = "measured as its files have it";
  stage.asked.measure = how;
  auto& state = stage.snapshots.emplace_back();
  state.label = "measured";
  state.packing = std::move(sample.packing);
  add_wall_forces(state.packing);
  stage.texture = texture::measure_spheres(state.packing, texture::sphere_options(state.packing, how));
  std::vector<std::string> notes = std::move(sample.notes);
  if (sample.doubled_rows > 0)
    notes.insert(notes.begin(), fmt::format("{} rows repeat a contact that is already listed, and were merged with it.",
                                            sample.doubled_rows));
  for (const auto& note : stage.texture["notes"].get<std::vector<std::string>>()) notes.push_back(note);
  stage.texture["notes"] = notes;
  return stage;
}

}  // namespace arenite::workflow
