#pragma once
#include <string>
#include <string_view>

namespace arenite::report {

/// Puts `with` in the place of a mark of a page's template; throws std::logic_error where the template lacks it.
void replace_once(std::string& text, std::string_view mark, const std::string& with);

/// Text as HTML shows it.
std::string html_text(std::string_view plain);

}  // namespace arenite::report
