#include "thermal/inference/mean_forces.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/error.hpp"
#include "core/mapped.hpp"
#include "thermal/inference/balance.hpp"
#include "thermal/inference/check_problem.hpp"
#include "thermal/inference/normal_equations.hpp"

namespace arenite::inference {
namespace {

/// Sum of normal forces of a grain by its mean stress, N.
double normal_sum(const Packing& packing, std::size_t g, double sigma_hyd) {
  return -2 * std::numbers::pi * packing.grains.radius[g] * packing.domain.thickness * sigma_hyd;
}

bool known(double error) { return error > 0 && std::isfinite(error); }

void add_means(ForceEquations& equations, const Touches& touches, const std::vector<double>& sigma_hyd,
               const std::vector<double>& error) {
  const Packing& packing = equations.packing;
  for (std::size_t g = 0; g < touches.size(); ++g) {
    if (!known(error[g]) || touches[g].empty()) continue;
    const auto columns = mapped(touches[g], [](const Touch& t) { return 2 * t.contact; });
    const double spread = std::abs(normal_sum(packing, g, error[g]));
    equations.add(columns, std::vector<double>(columns.size(), equations.unknowns.force),
                  {normal_sum(packing, g, sigma_hyd[g])}, {1 / (spread * spread)});
  }
}

/// Directions of force that neither means nor balance nor wall loads see.
int null_space(const ForceProblem& problem, const Touches& touches, const std::vector<double>& error) {
  const Packing& packing = problem.packing;
  const Unknowns unknowns{packing.contacts.size(), packing.grains.size(), 1, 0};
  ForceEquations equations(packing, unknowns);
  std::vector<double> same(error.size()), none(2 * unknowns.contacts, 0.0);
  for (std::size_t g = 0; g < error.size(); ++g)
    same[g] = known(error[g]) ? 1 / std::abs(normal_sum(packing, g, 1)) : 0;
  std::vector<WallLoad> walls = problem.walls;
  for (WallLoad& wall : walls) wall.error = 1;
  add_means(equations, touches, same, same);
  equations.add_balance(touches, none, 1);
  equations.add_walls(walls);
  for (int u = 0; u < unknowns.count(); ++u) equations.add_diagonal(u, 0, 0);
  return equations.small_eigenvalues(1e-9);
}

/// MacKay's fixed point: the mean square of deviations from the elastic solution over the number of those directions
/// that the data determine.
double likelier_prior(double prior, const std::vector<double>& x, const std::vector<double>& elastic,
                      const std::vector<double>& compliance, const NormalEquations& equations) {
  const std::vector<double> variance = equations.inverse_diagonal();
  double determined = 0, energy = 0;
  for (std::size_t u = 0; u < x.size(); ++u) {
    determined += 1 - variance[u] * compliance[u / 2] / (prior * prior);
    energy += compliance[u / 2] * (x[u] - elastic[u]) * (x[u] - elastic[u]);
  }
  return determined > 1 ? std::clamp(std::sqrt(energy / determined), 0.03, 10.0) : prior;
}

}  // namespace

InferredForces infer_from_means(const ForceProblem& problem, const std::vector<double>& sigma_hyd,
                                const std::vector<double>& error, const ForceOptions& options) {
  check_problem(problem, options, false);
  const Packing& packing = problem.packing;
  if (sigma_hyd.size() != packing.grains.size() || error.size() != sigma_hyd.size())
    throw InputError("mean stresses need a value and an error for each grain");
  const Touches touches = touches_of_grains(packing, packing.grains.position);
  double sum = 0;
  for (std::size_t g = 0; g < error.size(); ++g)
    if (known(error[g])) sum += std::abs(normal_sum(packing, g, sigma_hyd[g]));
  if (!(sum > 0)) throw InputError("no grain has a mean stress with a standard error");
  const Unknowns unknowns{packing.contacts.size(), packing.grains.size(),
                          sum / static_cast<double>(2 * packing.contacts.size()), 0};
  const std::vector<double> none(2 * unknowns.contacts, 0.0), blind(error.size(), 0.0);
  const auto equations_with = [&](double prior, const std::vector<double>& errors) {
    ForceEquations equations(packing, unknowns);
    add_means(equations, touches, sigma_hyd, errors);
    equations.add_balance(touches, none, options.balance_error * unknowns.force);
    equations.add_walls(problem.walls);
    equations.add_energy(prior);
    return equations;
  };
  double prior = options.prior > 0 ? options.prior : 1;
  if (options.prior <= 0) {
    const std::vector<double> elastic = equations_with(prior, blind).solve(), compliance = compliances(packing);
    for (int round = 0; round < 4; ++round) {
      const ForceEquations tried = equations_with(prior, error);
      prior = likelier_prior(prior, tried.solve(), elastic, compliance, tried);
    }
  }
  const ForceEquations equations = equations_with(prior, error);
  std::vector<double> force = equations.solution(options);
  for (double& f : force) f *= unknowns.force;
  InferredForces out = equations.finish(options, touches, force);
  out.null_space = null_space(problem, touches, error);
  return out;
}

}  // namespace arenite::inference
