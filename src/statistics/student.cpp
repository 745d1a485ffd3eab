#include "statistics/student.hpp"

#include <boost/math/distributions/students_t.hpp>
#include <boost/math/special_functions/beta.hpp>

namespace arenite::statistics {
namespace {

using namespace boost::math::policies;
/// What is not known stays so: no exceptions.
using Quiet = policy<domain_error<ignore_error>, overflow_error<ignore_error>, evaluation_error<ignore_error>, promote_double<false>>;
using Student = boost::math::students_t_distribution<double, Quiet>;

}  // namespace

double student_share(double t, double freedom) { return cdf(Student(freedom), t); }

double student_quantile(double p, double freedom) { return quantile(Student(freedom), p); }

double fisher_share_above(double f, double freedom_between, double freedom_within) {
  return boost::math::ibeta(0.5 * freedom_within, 0.5 * freedom_between, freedom_within / (freedom_within + freedom_between * f), Quiet());
}

}  // namespace arenite::statistics
