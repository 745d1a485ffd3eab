#include "report/number_words.hpp"

#include <string>

#include "model/field_quantities.hpp"
#include "model/voxel_quantities.hpp"

namespace arenite::report {
namespace {

struct Called {
  const char *key, *name, *symbol = "";
};
constexpr Called called[] = {{"sigma_norm", "\u03c3_{norm}"},
                             {"psi6", "local order \u03c8_{6}"},
                             {"a_c", "a_{c}"},
                             {"a_c_signed", "a_{c}, signed"},
                             {"a_c_noise", "noise of a_{c}"},
                             {"phi", "\u03c6"},
                             {"a_n", "a_{n}"},
                             {"a_t", "a_{t}"},
                             {"theta_c", "\u03b8_{c}"},
                             {"theta_n", "\u03b8_{n}"},
                             {"P0", "P_{0}"},
                             {"alpha", "\u03b1"},
                             {"beta", "\u03b2"},
                             {"S_m", "S_{m}"},
                             {"Z_l", "Z_{l}"},
                             {"Z_s", "Z_{s}"},
                             {"Z_ll", "Z_{ll}"},
                             {"Z_ls", "Z_{ls}"},
                             {"Z_sl", "Z_{sl}"},
                             {"Z_ss", "Z_{ss}"},
                             {"r2", "R^{2}"},
                             {"line_r2", "R^{2} of a line"},
                             {"q_gaussian", "q-Gaussian"},
                             {"p_value", "p-value"},
                             {"cv", "coefficient of variation"},
                             {"rms", "r.m.s."},
                             {"dx", "node spacing"},
                             {"lockin", "lock-in"},
                             {"fn_error", "s.e. of F_{n}"},
                             {"ft_error", "s.e. of F_{t}"},
                             {"thinnest_neck_nodes", "nodes across the thinnest neck"},
                             {"smallest_grain_nodes", "nodes across the smallest grain"},
                             {"modulus", "apparent modulus", "E"},
                             {"stress", "stress", "\u03c3"},
                             {"solid_fraction", "solid fraction", "\u03c6"},
                             {"pressure", "pressure", "p"},
                             {"deviator", "deviator", "q"}};

}  // namespace

Numbers number_words() {
  Numbers words = Numbers::tree();
  for (const FieldQuantity& q : field_quantities())
    if (q.unit == "Pa") words[q.name] = Numbers::list({std::string(q.symbol), ""});
  for (const VoxelQuantity& q : voxel_quantities())
    if (q.unit == "Pa") words[q.name] = Numbers::list({std::string(q.symbol), ""});
  for (const Called& one : called) words[one.key] = Numbers::list({one.name, one.symbol});
  return words;
}

}  // namespace arenite::report
