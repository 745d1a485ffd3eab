#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "core/error.hpp"
#include "recipe/recipe_key_parts.hpp"

namespace arenite::study {

void declare(ParameterVisitor& v, dem::ContactParameters& contact) {
  v.choice({"normal", "Normal force at an overlap h."}, contact.normal,
           {{"linear", "spring k_eff h and dashpot"}, {"hertz", "spring growing with h^(3/2)"}});
  v.choice({"stiffness_rule", "Stiffness of a contact of two materials."}, contact.stiffness_rule,
           {{"thesis", "k for like grains, k_i k_j/(k_i + k_j) for unlike ones"},
            {"series", "two springs in series, of 2 k_i and 2 k_j"}});
  v.choice({"wall_stiffness", "Stiffness of a contact with a wall."}, contact.wall_stiffness,
           {{"stiffest", "that of the stiffest material"}, {"grain", "that of the grain"}, {"series", "by the series rule"}});
  v.number({"restitution", "Ratio of speeds after and before a head-on collision; sets the damping of each pair."},
           contact.restitution, "", range::above(0, 1));
  v.number({"normal_damping", "Damping coefficient alpha_n of every pair, instead of the one that restitution asks for."},
           contact.normal_damping, "N s/m", range::not_negative);
  v.flag({"attractive_dashpot", "Damping may pull at separation; false: contacts without adhesion never pull."},
         contact.attractive_dashpot);
  v.choice({"friction_law", "Tangential force."}, contact.friction_law,
           {{"none", "smooth grains"},
            {"regularised_coulomb", "-min(gamma_s |v_s|, mu |F_n|) sign(v_s): no friction at true rest"},
            {"cundall_strack", "spring with Coulomb's cap: holds static friction"}});
  v.number({"friction", "Coefficient mu between grains."}, contact.friction, "", range::not_negative);
  v.number({"wall_friction", "Coefficient mu at the walls; unless given, that of the grains."}, contact.wall_friction, "",
           range::not_negative);
  v.number({"sliding_viscosity", "gamma_s of the regularised law; unless given, the normal damping of the pair."},
           contact.sliding_viscosity, "N s/m", range::not_negative);
  v.number({"tangential_stiffness_ratio", "k_t/k_n of the Cundall-Strack spring."}, contact.tangential_stiffness_ratio, "",
           range::positive);
  v.choice({"arms", "Lever arms of contact forces."}, contact.arms,
           {{"contact_point", "to the middle of the overlap"}, {"full_radius", "the radii"}});
  v.choice({"adhesion", "Adhesion between glued grains."}, contact.adhesion,
           {{"none", "no glue"},
            {"geometrical", "-gamma sqrt(r_eff h), reversible"},
            {"geometrical_breaking", "the same, lost for good once a contact opens"}});
  v.number({"surface_energy", "gamma of the adhesion."}, contact.surface_energy, "kN/mm", range::not_negative);
  v.require(contact.adhesion == dem::Adhesion::none || contact.surface_energy > 0, {"surface_energy", "adhesion"},
            "must be above 0 kN/mm where adhesion acts");
  v.choice({"effective_radius", "r_eff of the adhesion."}, contact.effective_radius,
           {{"four_reduced", "4 r_i r_j/(r_i + r_j)"}, {"sum", "r_i + r_j"}, {"geometric_mean", "2 sqrt(r_i r_j)"}});
  v.choice({"friction_cap", "Coulomb's cap where adhesion pulls."}, contact.friction_cap,
           {{"raised_by_adhesion", "mu (F_n + |F_c|)"}, {"as_printed", "mu (F_n - |F_c|)"}});
  v.pairs({"glued_pairs", "Pairs of grains (indices from 0) that are glued, instead of all pairs in the glued region."},
          contact.glued_pairs);
}

void declare(ParameterVisitor& v, dem::IntegrationParameters& integration) {
  v.choice({"integrator", "Scheme for Newton's equations."}, integration.integrator,
           {{"velocity_verlet", "second order, the sturdiest"},
            {"leapfrog", "second order, velocities half a step off"},
            {"gear5", "Gear's fifth-order predictor and corrector; needs small steps where damping is strong"}});
  v.number({"time_step", "Time step; one beyond the stable step is refused. Unless given, safety sets it, and masses of a stage that do not allow it shorten it."},
           integration.time_step, "s", range::positive);
  v.number({"safety", "Time step as a share of the shortest contact time, pi sqrt(m_eff/k)."}, integration.safety, "",
           range::above(0, 1));
  v.flag({"rotations", "Grains turn; false: they only move."}, integration.rotations);
  v.flag({"track_energy", "Account for dissipation and work at every step (slower)."}, integration.track_energy);
  // A name from elsewhere (--kernel) comes here without having been read, so it may be none of these.
  static const std::vector<std::string> kernels{"auto", "portable", "avx2", "avx512"};
  const auto found = std::find(kernels.begin(), kernels.end(), integration.kernel);
  if (found == kernels.end()) {
    throw InputError(fmt::format("there is no kernel \"{}\"; take one of: {}", integration.kernel, fmt::join(kernels, ", ")));
  }
  int kernel = static_cast<int>(found - kernels.begin());
  v.choice({"kernel", "Machine code of the contact loop."}, kernel,
           {{"auto", "the fastest of this processor"},
            {"portable", "the same bits on every x86-64 processor"},
            {"avx2", "256-bit vectors"},
            {"avx512", "512-bit vectors"}});
  integration.kernel = kernels[static_cast<std::size_t>(kernel)];
}

}  // namespace arenite::study
