#include "validation/judge.hpp"

#include <sys/stat.h>

#include <algorithm>
#include <ctime>

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

namespace {

/// The day on which a file was written last, UTC; empty if there is none.
std::string day_of(const std::filesystem::path& file) {
  struct stat about {};
  if (::stat(file.c_str(), &about) != 0) return {};
  std::tm date{};
  ::gmtime_r(&about.st_mtime, &date);
  char text[16] = "";
  std::strftime(text, sizeof text, "%Y-%m-%d", &date);
  return text;
}

StudyState state_of(const std::string& name, const StudyResults& study) {
  StudyState state{name, study.table().rows.size(), study.done().size()};
  for (const std::size_t row : study.done()) {
    const std::string day = day_of(Run{&study, row}.folder() / "status");
    if (day.empty()) continue;
    if (state.first_day.empty() || day < state.first_day) state.first_day = day;
    state.last_day = std::max(state.last_day, day);
  }
  return state;
}

}  // namespace

Ledger judge(char source, Results results) {
  Ledger ledger;
  for (const std::string& name : studies_of(source)) {
    const StudyResults& study = results.study(name);
    ledger.studies.push_back(state_of(name, study));
  }
  if (source == 'T') measure_with_other_borders(results);
  for (const Claim& claim : claims())
    if (claim.id[0] == source) ledger.claims.push_back({&claim, claim.judge(results)});
  return ledger;
}

}  // namespace arenite::validation
