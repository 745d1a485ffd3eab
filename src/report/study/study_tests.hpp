#pragma once
#include <filesystem>
#include <vector>

#include "campaign/collect.hpp"
#include "grains/fields/laboratory/test_kind.hpp"
#include "report/figures/drawing.hpp"
#include "report/figures/headlines.hpp"

namespace arenite::report {

/// What the runs of a study show as one experiment.
struct StudyTests {
  struct Figure {
    figures::Head head;
    figures::Drawing drawing;
  };
  fields::TestKind kind = fields::TestKind::none;  ///< of the test that its runs end with
  std::vector<Figure> laws;  ///< mu(I), discharge against opening and the like; none, where none fits

  /// What one asks first of such a test and the laws do not show.
  std::vector<figures::Headline> headlines() const;
};

/// Of the runs in a study's folder that are done; where keys beside the one of the law are swept, there is a curve for
/// each value of one of them. A run that says nothing of its test is left out.
StudyTests tests_of_study(const std::filesystem::path& study, const campaign::CollectedTable& table);

}  // namespace arenite::report
