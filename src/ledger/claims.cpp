#include "ledger/claims/claims.hpp"

namespace arenite::ledger {

const std::vector<Claim>& claims() {
  static const std::vector<Claim> list{
      {"T8", "chapter 4, figure 4.3", "The coordination number rises from about 4.3 to about 4.9 as N_HDPE/N_POM goes from 1 to 10",
       {"thesis-ch4", "thesis-ch4-r"}, "coordination", judge_t8},
  };
  return list;
}

}  // namespace arenite::ledger
