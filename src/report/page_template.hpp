#pragma once
#include <string>
#include <string_view>

namespace arenite::report {

/// The page without its data, built from web/ when Arenite is built (cmake/web.cmake): HTML with script and styles
/// inside and the marks __TITLE__, __DOCUMENT__ and __NUMBERS__, once each.
std::string_view page_template();

/// The page of a study without its figures: marks __TITLE__ and __FIGURES__, once each.
std::string_view study_template();

/// Puts `with` in the place of a mark of a page's template; throws std::logic_error where the template lacks it.
void replace_once(std::string& text, std::string_view mark, const std::string& with);

/// Text as HTML shows it.
std::string html_text(std::string_view plain);

}  // namespace arenite::report
