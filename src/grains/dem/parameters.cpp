#include "grains/dem/parameters.hpp"

#include <algorithm>
#include <string_view>

#include "core/mapped.hpp"
#include "core/problems.hpp"
#include "core/text.hpp"
#include "grains/dem/integrators/integrators.hpp"
#include "grains/dem/laws/friction_coefficients.hpp"

namespace arenite::dem {

using Visitor = ParameterVisitor;

namespace {

/// A number along each axis; none stand for none.
template <int D> void declare_vector(Visitor& v, const Key& key, std::optional<Vec<D>>& value, std::string_view unit) {
  std::vector<double> parts;
  for (int axis = 0; value && axis < D; ++axis) parts.push_back((*value)[axis]);
  v.numbers(key, parts, unit, range::any);
  const bool whole = parts.size() == static_cast<std::size_t>(D);
  v.require(parts.empty() || whole, {key.name},
            D == 2 ? "must be two numbers, along x and along y" : "must be three numbers, along x, y and z");
  value =
      whole ? std::optional(by_axis<D>([&](int axis) { return parts[static_cast<std::size_t>(axis)]; })) : std::nullopt;
}
/// The same where none stand for 0.
template <int D> void declare_vector(Visitor& v, const Key& key, Vec<D>& value, std::string_view unit) {
  std::optional<Vec<D>> given = value == Vec<D>{} ? std::nullopt : std::optional(value);
  declare_vector<D>(v, key, given, unit);
  value = given.value_or(Vec<D>{});
}

void declare_spin(Visitor& v, double& spin) {
  v.number({"spin", "Angular velocity, counter-clockwise."}, spin, "deg/s", range::any);
}
void declare_spin(Visitor& v, Vec3& spin) {
  declare_vector<3>(v, {"spin", "Angular velocity about each axis."}, spin, "deg/s");
}

}  // namespace

void ContactParameters::declare(Visitor& v) {
  v.member({"normal", "Normal force at an overlap h."}, normal);
  v.choice({"stiffness_rule", "Stiffness of a contact of two materials."}, stiffness_rule,
           {{"thesis", "k for like grains, k_i k_j/(k_i + k_j) for unlike ones"},
            {"series", "two springs in series, of 2 k_i and 2 k_j"}});
  v.choice({"wall_stiffness", "Stiffness of a contact with a wall."}, wall_stiffness,
           {{"stiffest", "that of the stiffest material"},
            {"grain", "that of the grain"},
            {"series", "by the series rule"}});
  v.number({"restitution", "Ratio of speeds after and before a head-on collision; sets the damping of each pair."},
           restitution, "", range::above(0, 1));
  v.number({"normal_damping",
            "Damping coefficient alpha_n of every pair, instead of the one that follows from restitution."},
           normal_damping, "N s/m", range::not_negative);
  v.flag({"attractive_dashpot",
          "The dashpot may attract while grains separate; false: contacts without adhesion are never tensile."},
         attractive_dashpot);
  v.member({"friction_law", "Tangential force."}, friction_law);
  declare_friction(v, friction, wall_friction);
  v.number(
      {"sliding_viscosity",
       "gamma_s, tangential damping coefficient of the friction law; if not given, the normal damping of the pair."},
      sliding_viscosity, "N s/m", range::not_negative);
  v.number({"tangential_stiffness_ratio", "k_t/k_n, for friction laws with a tangential spring."},
           tangential_stiffness_ratio, "", range::positive);
  v.member({"rolling", "Moment between two grains that rotate relative to each other."}, rolling);
  v.member({"bonds", "Cement between two grains, from the stage that creates it."}, bonds);
  v.member({"cohesion", "Attraction between all grains, touching or not: adhesion without glue, or liquid bridges."},
           cohesion);
  v.choice({"arms", "Lever arms of contact forces."}, arms,
           {{"contact_point", "to the middle of the overlap"}, {"full_radius", "the radii"}});
  v.member({"adhesion", "Adhesion between glued grains."}, adhesion);
  v.number({"surface_energy", "gamma of the adhesion."}, surface_energy, "kN/mm", range::not_negative);
  v.require(!adheres() || surface_energy > 0, {"surface_energy", "adhesion"},
            "must be above 0 kN/mm where adhesion acts");
  v.choice({"effective_radius", "r_eff of the adhesion."}, effective_radius, elasticity::words(effective_radius));
  v.choice({"friction_cap", "Coulomb limit in the presence of adhesion."}, friction_cap,
           {{"raised_by_adhesion", "mu (F_n + |F_c|)"}, {"as_printed", "mu (F_n - |F_c|)"}});
  v.pairs({"glued_pairs", "Pairs of grains (indices from 0) that are glued, instead of all pairs in the glued region."},
          glued_pairs);
}

void IntegrationParameters::declare(Visitor& v) {
  v.choice({"integrator", "Scheme for Newton's equations."}, integrator, mapped(integrators, &Integrator::word));
  v.number({"time_step",
            "Time step; an unstable one is refused. If not given, it follows from safety, and mass scaling of a stage "
            "may shorten it."},
           time_step, "s", range::positive);
  v.number({"safety", "Time step as a fraction of the shortest contact time, pi sqrt(m_eff/k)."}, safety, "",
           range::above(0, 1));
  v.flag({"rotations", "Grains rotate; false: they only translate."}, rotations);
  v.flag({"track_energy", "Compute dissipation and work at every step (slower)."}, track_energy);
  // A name from elsewhere (--kernel) comes here without having been read, so it may be none of these.
  static const std::vector<Word> kernels{{"auto", "the fastest on this processor"},
                                         {"portable", "the same bits on every x86-64 processor"},
                                         {"avx2", "256-bit vectors"},
                                         {"avx512", "512-bit vectors"}};
  const auto found = std::ranges::find(kernels, kernel, &Word::word);
  if (found == kernels.end())
    throw refusal("there is no kernel \"{}\"; choose one of: {}", kernel, list_of(mapped(kernels, &Word::word)));
  int chosen = static_cast<int>(found - kernels.begin());
  v.choice({"kernel", "Machine code of the contact loop."}, chosen, kernels);
  kernel = kernels[static_cast<std::size_t>(chosen)].word;
}

template <int D> void BoundaryMotionIn<D>::declare(Visitor& v) {
  v.text({"name", "Name of the boundary.", true}, name);
  declare_vector<D>(v, {"velocity", "Along each axis."}, velocity, "mm/s");
  declare_spin(v, spin);
  declare_vector<D>(v,
                    {"centre",
                     "Centre of rotation at the start of the stage; it moves with the velocity. Unless given, the mean "
                     "of the points."},
                    centre, "mm");
  v.flag({"absent", "The boundary is absent in this stage: a gate that opens."}, absent);
  v.number({"mass",
            "With a mass it moves under its weight, the force and the grains, starting from the given velocity or from "
            "its previous one."},
           mass, "kg", range::positive);
  declare_vector<D>(v, {"force", "Along each axis, on a boundary with a mass."}, force, "N");
  v.require(mass || force == Vec<D>{}, {"force", "mass"}, "moves only a boundary with a mass; write mass = \"... kg\"");
}
template struct BoundaryMotionIn<2>;
template struct BoundaryMotionIn<3>;

}  // namespace arenite::dem
