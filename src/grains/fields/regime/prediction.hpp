#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "grains/dem/laws/laws.hpp"
#include "grains/dem/parameters.hpp"
#include "grains/dem/stage.hpp"
#include "model/packing.hpp"

// What a stage of loading will be like, before it is run. SI units.
namespace arenite::dem {
template <int D> class EngineIn;
using Engine = EngineIn<2>;
}  // namespace arenite::dem

namespace arenite::fields {

/// How long two bodies on a linear spring touch, without damping, s: pi sqrt(m/k), of their reduced mass, kg, and
/// stiffness, N/m.
double collision_time(double reduced_mass, double stiffness);

/// I = rate d sqrt(rho/P) of a shear or closing rate, 1/s, of grains of mean diameter d and density rho under the
/// pressure P (GDR MiDi 2004): the time that a grain takes to fall into a gap over the time of a change of neighbours.
double inertial_number(double rate, double diameter, double density, double pressure);

/// What it says of a deformation: "quasi-static" below 1e-3, "dense flow" up to 0.1, "inertial" above.
std::string_view flow_regime(double inertial_number);

/// Overlap of two equal grains of diameter d that are pressed together with a force, m; at most d.
double overlap_under(const dem::NormalLaw& law, double stiffness, double diameter, double force);

/// Stiffness number d/h of the overlap h under the force P L d that falls on a grain of length L in a pressure P: k/(P
/// L) of a linear law (Combe and Roux 2003). Grains count as hard above 1e4.
double stiffness_number(const dem::NormalLaw& law, double stiffness, double diameter, double thickness,
                        double pressure);

/// The pair whose collision is shortest: two grains alike, or a grain and a wall.
struct ShortestCollision {
  double time = 0;    ///< s
  double radius = 0;  ///< m
  std::int32_t material = 0;
  bool with_wall = false;
};
template <int D>
ShortestCollision shortest_collision(const PackingIn<D>& packing, const dem::ContactParameters& contact);

/// Why the time step is as long as it is.
enum class StepLimit { collision, stiffness, damping, given };
/// Of a sample whose shortest collision takes so long, s.
template <int D>
StepLimit step_limit(const dem::EngineIn<D>& engine, const dem::IntegrationParameters& integration, double collision);

/// Steps of a stage that can be counted one by one: whole numbers up to here are exact in a double.
inline constexpr double most_steps = 9007199254740992.0;

/// Time that a stage lasts as its recipe asks, s; 0 where it ends at equilibrium.
double time_asked(const dem::Stage& stage);
/// What is wrong with as many steps as that takes; empty where they can be counted.
std::string too_many_steps(const dem::Stage& stage, double time_step);

struct StagePrediction {
  std::string name;
  double time_step = 0;  ///< s
  double duration = 0;   ///< s of the sample's time
  std::int64_t steps = 0;
  std::int64_t increment_steps = 0;  ///< of the longest increment; 0 where `exact`
  bool exact = false;                ///< steps follow from a duration; else they are an estimate
  double seconds = 0;                ///< of one processor
  double inserted = 0;               ///< grains that its inflows bring, if all find room
  double pressure = 0;               ///< Pa, the largest that its sides or its weight exert; 0: none known
  std::optional<double> inertial_number, stiffness_number, overlap;  ///< overlap: over the diameter
  std::int64_t states = 1;                                           ///< that are stored
  std::optional<double> strain;  ///< that it reaches: of shear, or of the axis along which sides move, closing positive
  std::optional<double> height;  ///< m, of the sample in the end; an estimate, of a box without boundaries inside
};

/// A sample as a whole.
struct Bulk {
  double diameter = 0;  ///< mean, m
  double density = 0;   ///< of the grains, kg/m^3
  double solid_fraction = 0;
  double stiffness = 0;  ///< of the softest pair of its materials, N/m
  double width = 0, height = 0, thickness = 0;
  double larger = 1;  ///< how much wider it is than the sample that was made
};
Bulk bulk_of(const Packing& packing, const dem::ContactParameters& contact);

/// The pressures of a stage, Pa: the largest, and the one that confines it. Sides that only move or stand keep what the
/// stage before left.
struct Pressures {
  double largest = 0, confining = 0;
};

/// What a stage will be like that the engine has begun. Throws InputError for one of too many steps. `bulk` and
/// `pressures` are those that the stage before left, and then its own; `steady_drag`, 1/s, acts in every stage.
StagePrediction predict_stage(const dem::Engine& engine, const dem::ContactParameters& contact, double steady_drag,
                              const dem::Stage& stage, Bulk& bulk, Pressures& pressures);

/// What is legal, but costly or unphysical, a sentence each: about a time step, s, and what limits it beside the
/// shortest collision.
std::vector<std::string> doubts_about_step(double time_step, StepLimit limit, const ShortestCollision& collision,
                                           const dem::ContactParameters& contact);

/// About a stage that is predicted.
std::vector<std::string> doubts_about(const StagePrediction& prediction, const dem::Stage& stage);

}  // namespace arenite::fields
