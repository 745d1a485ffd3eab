#pragma once
#include <cstddef>
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

  /// fn (0) or ft (1) of its contact, from those of all contacts; and the force on the grain.
  double of_contact(const std::vector<double>& force, std::size_t component) const {
    return force[2 * static_cast<std::size_t>(contact) + component];
  }
  Vec2 force_of(const std::vector<double>& force) const {
    return of_contact(force, 0) * normal + of_contact(force, 1) * perpendicular(normal);
  }
};

using Touches = std::vector<std::vector<Touch>>;  ///< of every grain

/// With normals between the centres given (periodic images included); a wall's normal is its own.
Touches touches_of_grains(const Packing& packing, const std::vector<Vec2>& centre);

/// Unknowns of an inference: fn and ft of contact c are 2 c and 2 c + 1, in units of `force`; where centres are
/// refined, the changes of centre g along x and y are 2 (contacts + g) and the next, in units of `move`; where factors
/// are fitted, the changes of the grains' scales and of the materials' come next; the shift that all pixels share, in
/// units of `shift`, is the last.
struct Unknowns {
  std::size_t contacts = 0, grains = 0;
  double force = 1;  ///< N
  double move = 0;   ///< m; 0: centres stay
  std::size_t own_factors =
      0;  ///< grains whose factor is fitted beside that of their material; 0: those of a material are alike
  std::size_t scales = 0;  ///< materials whose factor is fitted; 0: factors stay
  double shift = 0;        ///< K, by which all pixels may be shifted together; 0: they are not

  int count() const { return common_shift() + (shift > 0 ? 1 : 0); }
  int centre(std::size_t g) const { return static_cast<int>(2 * (contacts + g)); }
  int own_factor(std::size_t g) const { return static_cast<int>(2 * contacts + (move > 0 ? 2 * grains : 0) + g); }
  int scale(std::size_t material) const { return own_factor(own_factors + material); }
  int common_shift() const { return scale(scales); }
};

/// The columns of a grain's equations: its touches' forces and, where centres move, its own and its partners' centres.
std::vector<int> columns_of(const Unknowns& unknowns, std::size_t grain, const std::vector<Touch>& touches);

/// Adds to a row (in the order of `columns_of`) what a turn of touch k's normal by 1 rad does, through the centres.
void add_turn(const Unknowns& unknowns, const std::vector<Touch>& touches, std::size_t k, double per_radian,
              double* row);

/// Mean stiffness over each contact's (springs in series): what its squared force counts in the elastic energy.
std::vector<double> compliances(const Packing& packing);

/// The equations of an inference: what forces obey beside the data. The packing must outlive them.
class ForceEquations : public NormalEquations {
 public:
  ForceEquations(const Packing& of, const Unknowns& with)
      : NormalEquations(with.count()),
        packing(of),
        unknowns(with) {}

  /// Forces and couple of every grain vanish to `error` (N). `force` is the present estimate, of which turning normals
  /// change the direction, N. Where factors are fitted, `scale` (one a material) are the present ones, and what is out
  /// of balance counts as the data show it, scale times force: counted in newtons it would be less with all forces
  /// smaller and all factors larger, which no data tell from what they are but a load that is known badly.
  void add_balance(const Touches& touches, const std::vector<double>& force, double error,
                   const std::vector<double>& scale = {});
  void add_walls(const std::vector<WallLoad>& walls);
  /// Elastic energy of the contacts: sum of compliance (f/(prior unit))^2.
  void add_energy(double prior);
  /// Within the cone, if the options ask for it.
  std::vector<double> solution(const ForceOptions& options) const;
  /// What both ways of inference hand back: forces `force` (N), errors from the inverse of these equations.
  InferredForces finish(const ForceOptions& options, const Touches& touches, const std::vector<double>& force) const;

  const Packing& packing;
  const Unknowns unknowns;
};

}  // namespace arenite::inference
