#pragma once

namespace arenite::statistics {

/// Share of Student's t distribution below t. `freedom` > 0 need not be whole; infinity gives the normal distribution.
double student_share(double t, double freedom);

/// The t below which the share p lies, p in (0, 1).
double student_quantile(double p, double freedom);

/// Share of Fisher's F distribution above f: how often groups that are alike differ as much.
double fisher_share_above(double f, double freedom_between, double freedom_within);

}  // namespace arenite::statistics
