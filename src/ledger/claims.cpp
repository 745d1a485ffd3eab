#include "ledger/claims/claims.hpp"

namespace arenite::ledger {

const std::vector<Claim>& claims() {
  static const std::vector<Claim> list{
      {"T1", "chapter 2, table 2.3", "Separation forces give surface energies of 0.268, 0.511, 0.745 and 1.060 kN/mm", {"thesis-ch2"}, "", judge_t1},
      {"T2", "chapter 2, tables 2.1 and 2.2", "The mean contact stiffness of POM is 27.35 kN/mm, of HDPE 6.43 kN/mm", {"thesis-ch2"}, "", judge_t2},
      {"T3", "chapter 3, figure 3.10", "Contact directions of sample #2, all of one diameter, peak at 0, 60 and 120 degrees, whatever the materials", {"thesis-ch3"}, "", judge_t3},
      {"T4", "chapter 3, figures 3.11 and 3.12", "#8 is quasi-isotropic, its POM-POM contacts lean to the axis of compression, those of #12 to about 45 degrees", {"thesis-ch3"}, "", judge_t4},
      {"T5", "chapter 3, table 3.2", "Fewer than half of the grains carry more than the mean stress: of all, of POM, of HDPE", {"thesis-ch3"}, "", judge_t5},
      {"T6", "chapters 3 to 6", "Beyond the mean, stresses and forces fall off exponentially, whatever the material, the type of contact and the zone",
       {"thesis-ch3", "thesis-ch4", "thesis-ch5", "thesis-ch6"}, "", judge_t6},
      {"T7", "chapter 3, sample #12", "The highest stresses are in small grains although large ones carry the strongest forces", {"thesis-ch3"}, "", judge_t7},
      {"T8", "chapter 4, figure 4.3", "The coordination number rises from about 4.3 to about 4.9 as N_HDPE/N_POM goes from 1 to 10", {"thesis-ch4", "thesis-ch4-r"}, "coordination", judge_t8},
      {"T9", "chapter 4, figure 4.3", "z(HDPE-HDPE) rises and z(POM-POM) falls with the ratio; z(POM-ANY) is above z(HDPE-ANY)", {"thesis-ch4"}, "coordination", judge_t9},
      {"T10", "chapters 4 and 5, figures 4.4 and 5.3", "About 40 % of the contacts carry more than the mean force, of all and of each type", {"thesis-ch4", "thesis-ch5"}, "", judge_t10},
      {"T11", "chapter 4, figure 4.6", "Above a ratio of 8 the packing orders triangularly; below it is quasi-isotropic", {"thesis-ch4"}, "", judge_t11},
      {"T12", "chapter 4, figure 4.6", "POM-POM contacts lean to the axis of compression", {"thesis-ch4", "thesis-ch4-r"}, "", judge_t12},
      {"T13", "chapter 5, figure 5.2", "z does not depend on k_A/k_B; half of the contacts are A-B, a quarter each A-A and B-B; z(A-B) is about 1.75",
       {"thesis-ch5", "thesis-ch5-r", "thesis-ch5-smooth"}, "coordination", judge_t13},
      {"T14", "chapter 5, figures 5.5 to 5.7", "The strong network leans to the compression, the weak one does not; weak A-A and B-B contacts are not isotropic either",
       {"thesis-ch5", "thesis-ch5-r", "thesis-ch5-smooth"}, "", judge_t14},
      {"T15", "chapter 6, table 6.1", "48.0, 48.0 and 49.4 % of the grains carry more than the mean stress: all, without adhesion, with adhesion", {"thesis-ch6"}, "", judge_t15},
      {"T16", "chapter 6, figure 6.5", "Contact directions prefer plus and minus 45 degrees", {"thesis-ch6"}, "", judge_t16},
      {"T18", "chapter 3, figure 3.6", "The solid fraction settles between 20 and 90 % of the area (#11)", {"thesis-ch3"}, "", judge_t18},
      {"T19", "chapter 4, figures 4.4 and 4.5", "More HDPE-HDPE and fewer POM-POM contacts exceed the whole network's mean as the ratio grows; POM-POM carry the largest forces", {"thesis-ch4"}, "", judge_t19},
      {"T20", "chapter 5, figures 5.3 and 5.5", "A-B contacts are most of the strong ones, A-A and B-B about a quarter each; A-A lean slightly to the compression", {"thesis-ch5"}, "", judge_t20},
      {"T21", "chapter 6, figure 6.3", "Contacts that pull are few and pull little; strong chains avoid the agglomerate", {"thesis-ch6"}, "", judge_t21},
      {"T22", "chapter 2, section 2.4.3", "Cohesion leaves no trace in the mechanics where k/gamma is above about 50", {"thesis-ch6"}, "", judge_t22},
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
