#include "inference/finish.hpp"

#include <cmath>

namespace arenite::inference {

InferredForces finish(const ForceProblem& problem, const ForceOptions& options, const NormalEquations& equations, const Unknowns& unknowns,
                      const std::vector<std::vector<Touch>>& touches, const std::vector<double>& force) {
  InferredForces out;
  out.contacts = problem.packing.contacts;
  for (std::size_t g = 0; g < touches.size(); ++g)
    for (const Touch& t : touches[g]) {
      const auto c = static_cast<std::size_t>(t.contact);
      const bool first = static_cast<std::size_t>(out.contacts.i[c]) == g;
      if (first) out.contacts.nx[c] = t.normal.x, out.contacts.ny[c] = t.normal.y;
    }
  const std::vector<double> variance = equations.inverse_diagonal();
  for (std::size_t c = 0; c < unknowns.contacts; ++c) {
    out.contacts.fn[c] = force[2 * c], out.contacts.ft[c] = force[2 * c + 1];
    out.fn_error.push_back(unknowns.force * std::sqrt(variance[2 * c]));
    out.ft_error.push_back(unknowns.force * std::sqrt(variance[2 * c + 1]));
    out.spurious.push_back(std::abs(force[2 * c]) < options.spurious_below * out.fn_error[c] ? 1 : 0);
  }
  out.imbalance = imbalances(problem.packing, touches, force, options.gravity);
  return out;
}

}  // namespace arenite::inference
