#pragma once
#include <vector>

#include "model/packing.hpp"
#include "thermal/inference/contact_forces.hpp"
#include "thermal/inference/normal_equations.hpp"

namespace arenite::inference {

/// A contact as one of its grains has it: `normal` points into the grain; the force on it is fn normal + ft t.
struct Touch {
  int contact = 0;
  int partner = -1;  ///< the other grain; -1: a wall
  Vec2 normal;
  double distance = 0;  ///< between the two centres, m; 0 at a wall
};

using Touches = std::vector<std::vector<Touch>>;  ///< of every grain

/// With normals between the centres given (periodic images included); a wall's normal is its own.
Touches touches_of_grains(const Packing& packing, const std::vector<Vec2>& centre);

/// Throws InputError with everything that is wrong with grains, contacts, walls and options; `factors` where those count.
void check_problem(const ForceProblem& problem, const ForceOptions& options, bool factors);

/// Unknowns of an inference: fn and ft of contact c are 2 c and 2 c + 1, in units of `force`; where centres are refined,
/// the changes of centre g along x and y are 2 (contacts + g) and the next, in units of `move`; where materials' factors are
/// fitted, the changes of their scales come last.
struct Unknowns {
  std::size_t contacts = 0, grains = 0;
  double force = 1;        ///< N
  double move = 0;         ///< m; 0: centres stay
  std::size_t scales = 0;  ///< materials whose factor is fitted; 0: factors stay

  int count() const { return scale(scales); }
  int centre(std::size_t g) const { return static_cast<int>(2 * (contacts + g)); }
  int scale(std::size_t material) const { return static_cast<int>(2 * contacts + (move > 0 ? 2 * grains : 0) + material); }
};

/// The columns of a grain's equations: its touches' forces and, where centres move, its own and its partners' centres.
std::vector<int> columns_of(const Unknowns& unknowns, std::size_t grain, const std::vector<Touch>& touches);

/// Adds to a row (in the order of `columns_of`) what a turn of touch k's normal by 1 rad does, through the centres.
void add_turn(const Unknowns& unknowns, const std::vector<Touch>& touches, std::size_t k, double per_radian, double* row);

/// Forces and couple of every grain vanish to `error` (N); weights of grains count where gravity is not zero. `force` is
/// the present estimate, of which turning normals change the direction, N.
void add_balance(NormalEquations& equations, const Unknowns& unknowns, const Packing& packing, const Touches& touches, const std::vector<double>& force,
                 Vec2 gravity, double error);

void add_walls(NormalEquations& equations, const Unknowns& unknowns, const Contacts& contacts, const std::vector<WallLoad>& walls);

/// Mean stiffness over each contact's (springs in series): what its squared force counts in the elastic energy.
std::vector<double> compliances(const Packing& packing);

/// Elastic energy of the contacts: sum of compliance (f/(prior unit))^2.
void add_energy(NormalEquations& equations, const Unknowns& unknowns, const Packing& packing, double prior);

/// What both ways of inference hand back: forces `force` (N), errors from the inverse of `equations`.
InferredForces finish(const ForceProblem& problem, const ForceOptions& options, const NormalEquations& equations, const Unknowns& unknowns,
                      const Touches& touches, const std::vector<double>& force);

}  // namespace arenite::inference
