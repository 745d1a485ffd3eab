#include "ledger/claims/claims.hpp"

namespace arenite::ledger {

const std::vector<Claim>& claims() {
  static const std::vector<Claim> list{
      {"T8", "chapter 4, figure 4.3", "The coordination number rises from about 4.3 to about 4.9 as N_HDPE/N_POM goes from 1 to 10",
       {"thesis-ch4", "thesis-ch4-r"}, "coordination", judge_t8},
      {"P1", "paper III.A, figure 4", "The particle fraction lies between 0.82 and 0.89 and rises with gamma; at gamma 5 it is highest at theta 2.7; below, theta matters little",
       {"paper", "paper-choices"}, "density", judge_p1},
      {"P2", "paper III.B, figure 5", "Z and Z_l rise with gamma, Z_l from 4 to 14; Z_s lies between 3.1 and 4.2, first falls and then rises; Z_ls rises nearly in a line, Z_ss rises, Z_sl and Z_ll fall; Z_ll is below 1 where theta is small and gamma large",
       {"paper", "paper-choices"}, "coordination", judge_p2},
      {"P3", "paper III.C, figure 6", "Mean and standard deviation of single-pore volume rise nearly in a line with 1/gamma; the pdf's peak moves to larger pores as gamma falls",
       {"paper", "paper-choices"}, "pores", judge_p3},
      {"P4", "paper III.C, figures 7 and 8", "The mean single void of partly filled samples is largest at medium S_m; its CV rises to S_m of about 0.4, drops below 1 and rises again; the peak of the pdf at small voids vanishes above 0.4",
       {"paper"}, "voids", judge_p4},
      {"P5", "paper IV.A, figure 9", "Full samples: the largest stresses are about twice the mean; the matrix lies below, large grains above the mean, and their pdf is narrower than that of small ones",
       {"paper", "paper-choices"}, "stress-full", judge_p5},
      {"P6", "paper IV.A, figure 11", "Full samples: the mean stress in large grains is about 1.07 of the sample's whatever gamma; in small grains it falls with gamma, to below 1",
       {"paper", "paper-choices"}, "means", judge_p6},
      {"P7", "paper IV.A, figure 12b", "Full samples: the variance of stress in large grains is linear in the standard deviation of single-pore volume, one line for all theta",
       {"paper", "paper-choices"}, "variance-pores", judge_p7},
      {"P8", "paper IV.A, figure 12a", "Full samples: the variance of stress in large grains falls with Z_ls",
       {"paper"}, "variance-contacts", judge_p8},
      {"P9", "paper IV.B, figures 14 and 15", "Partly filled samples: tails of stress are exponential in large and small grains; their slope s grows with S_m, and gamma's effect on s grows with S_m; the matrix's pdf is broad and without a peak at low S_m",
       {"paper"}, "tails", judge_p9},
      {"P10", "paper IV.B, figure 13", "Partly filled samples: the highest stresses are in small grains; the less matrix, the more of it lies above the mean",
       {"paper"}, "stress-partial", judge_p10},
      {"P11", "paper II.D", "The response is linear at the applied strain",
       {"paper-linearity"}, "", judge_p11},
      {"P12", "paper IV, not shown", "q of the q-Gaussian grows with gamma; excess kurtosis in large grains is highest at the largest gamma",
       {"paper", "paper-choices"}, "shape", judge_p12},
  };
  return list;
}

}  // namespace arenite::ledger
