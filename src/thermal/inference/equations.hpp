#pragma once
#include <cstdint>
#include <memory>
#include <vector>

#include "model/packing.hpp"
#include "thermal/inference/contact_forces.hpp"

namespace arenite::inference {

/// Sums of squares of linear equations: sum of weight (row . x - right)^2, kept as normal equations H x = b. Rows come
/// in small dense blocks that share their columns.
class NormalEquations {
 public:
  explicit NormalEquations(int unknowns) : right_(static_cast<std::size_t>(unknowns)) {}

  /// Equations in the unknowns `columns` (each once): rows one after the other, columns.size() numbers each.
  void add(const std::vector<int>& columns, const std::vector<double>& rows, const std::vector<double>& right,
           const std::vector<double>& weight);
  void add_diagonal(int unknown, double weight, double right);

  /// The sum of squares at x.
  double squares(const std::vector<double>& x) const;
  /// The minimum. With a cone, unknowns 2 c and 2 c + 1 (c < contacts) are fn and ft of a contact and obey
  /// |ft| <= mu fn; found by an interior-point method (Mehrotra 1992).
  std::vector<double> solve() const;
  std::vector<double> solve_in_cone(int contacts, double mu) const;
  /// Diagonal of the inverse of H.
  std::vector<double> inverse_diagonal() const;
  /// Number of eigenvalues of H below `threshold` times its largest diagonal entry, by Sylvester's law of inertia.
  int small_eigenvalues(double threshold) const;

  int unknowns() const { return static_cast<int>(right_.size()); }

  /// Of the lower triangle of H, as Eigen takes it; those of one place add up.
  struct Entry {
    int i, j;
    double w;
    int row() const { return i; }
    int col() const { return j; }
    double value() const { return w; }
  };

 private:
  struct Factorised;
  const Factorised& factorised() const;

  std::vector<Entry> lower_;
  std::vector<double> right_;
  double constant_ = 0;                               // the sum of squares at zero
  mutable std::shared_ptr<const Factorised> factor_;  // for solution and errors alike; none after equations were added
};

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

/// Throws InputError with everything that is wrong with grains, contacts, walls and options; `factors` where those
/// count.
void check_problem(const ForceProblem& problem, const ForceOptions& options, bool factors);

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
  /// change the direction, N.
  void add_balance(const Touches& touches, const std::vector<double>& force, double error);
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

/// What is known of proposed contacts, one value each: the normal force inferred with all of them in the equations, its
/// standard error, and by how much the two surfaces overlap in the picture (below 0: they are apart).
struct ContactEvidence {
  std::vector<double> fn, fn_error;  ///< N
  std::vector<double> overlap;       ///< m
  std::vector<int> kind;             ///< contacts that share a stiffness (a pair of materials, a wall), from 0
  double widest_gap = 0;             ///< to which contacts were proposed, m
};

struct Presence {
  std::vector<double> probability;  ///< that the contact is there
  std::vector<double> idle;  ///< that it neither is there nor lost a force on the way, so that no equation needs it
  double expected = 0, error = 0;  ///< number of contacts that are there
  double error_scale = 1;  ///< by which forces of contacts that are not there scatter more than their errors say
};

/// Probability of every proposed contact. Forces and overlaps of all of them are taken as a mixture: contacts that are
/// not there have forces that scatter about zero, and gaps of any width that was proposed; those that lost their force
/// on the way likewise, with forces below zero; those that are there have forces of a law of its own (steps of 0.3 mean
/// forces and wider, so that it goes on smoothly to weak forces, where the two cannot be told apart one by one) and
/// overlaps linear in their force, as strong contacts of their kind show. Shares, law and scatter are those that make
/// the data likeliest (expectation maximisation). The sum of probabilities counts what noise hides, and counts out what
/// it feigns.
Presence presence(const ContactEvidence& evidence);

/// 1 for the contacts taken as there: the likeliest, as many as are expected, so that misses and false alarms cancel.
std::vector<std::uint8_t> taken_as_present(const Presence& presence);

}  // namespace arenite::inference
