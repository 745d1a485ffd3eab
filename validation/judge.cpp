#include "validation/judge.hpp"

#include <algorithm>

#include "validation/claims/thesis_choices.hpp"

namespace arenite::validation {

std::vector<std::string> studies_of(char source) {
  std::vector<std::string> names;
  for (const Claim& claim : claims()) {
    if (claim.id[0] != source) continue;
    for (const std::string& name : claim.studies)
      if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  }
  return names;
}

Ledger judge(char source, Results results) {
  Ledger ledger;
  for (const std::string& name : studies_of(source)) {
    const StudyResults& study = results.study(name);
    ledger.studies.push_back({name, study.table().rows.size(), study.done().size()});
  }
  if (source == 'T') measure_with_other_borders(results);
  for (const Claim& claim : claims())
    if (claim.id[0] == source) ledger.claims.push_back({&claim, claim.judge(results)});
  return ledger;
}

}  // namespace arenite::validation
