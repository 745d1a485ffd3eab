#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace arenite::report {

/// The page without its data, built from web/ when Arenite is built (cmake/web.cmake): HTML with script and styles
/// inside and the marks __TITLE__, __DOCUMENT__ and __NUMBERS__, once each.
std::string_view page_template();

/// The page of a study without its figures: marks __TITLE__ and __FIGURES__, once each.
std::string_view study_template();

/// What stands in the place of a mark of a page's template.
struct Filling {
  std::string_view mark;
  std::string text;
};
/// The template with every mark replaced, in the order in which they stand there. What is put in is never searched for
/// marks: a title may be "__DOCUMENT__". Throws std::logic_error where the template lacks one.
std::string filled(std::string_view page, const std::vector<Filling>& fillings);

/// Text as HTML shows it.
std::string html_text(std::string_view plain);

}  // namespace arenite::report
