#pragma once
#include <string>
#include <vector>

#include "report/study/study_figures.hpp"

namespace arenite::test {

/// gamma 1 and 2, two seeds each, width 0.2 or full; z is 10 gamma + seed.
inline campaign::CollectedTable study_table() {
  campaign::CollectedTable t;
  t.keys = {{"gamma", ""}, {"cement", ""}, {"seed", ""}};
  t.names = {"z", "s"};
  int run = 0;
  for (const char* gamma : {"2", "1"})
    for (const char* cement : {"", "full"})
      for (const char* seed : {"1", "3"})
        t.rows.push_back(
            {std::to_string(run++),
             "done",
             {gamma, cement, seed},
             1,
             {campaign::Estimate{10 * std::stod(gamma) + std::stod(seed)}, campaign::Estimate{std::stod(gamma) / 4}}});
  return t;
}

inline const report::NumbersOf no_numbers = [](const std::string&, const std::string&, const report::Figure&) {
  return Numbers{};
};

inline std::vector<report::Figure> figures_of(const std::string& keys) {
  return report::read_figures("[[figures]]\nid = \"f\"\ntitle = \"F\"\n" + keys, "figures.toml");
}

}  // namespace arenite::test
