#include "report/template_marks.hpp"

#include <stdexcept>

namespace arenite::report {

void replace_once(std::string& text, std::string_view mark, const std::string& with) {
  const std::size_t at = text.find(mark);
  if (at == std::string::npos) throw std::logic_error("the page's template lacks " + std::string(mark));
  text.replace(at, mark.size(), with);
}

std::string html_text(std::string_view plain) {
  std::string text;
  for (const char c : plain) {
    if (c == '<') text += "&lt;";
    else if (c == '&') text += "&amp;";
    else text += c;
  }
  return text;
}

}  // namespace arenite::report
