#include "report/page.hpp"

#include "io/atomic_file.hpp"
#include "report/number_block.hpp"
#include "report/page_document.hpp"
#include "report/page_template.hpp"
#include "report/template_marks.hpp"

namespace arenite::report {

std::string page(const PageData& data) {
  const PageDocument document = page_document(data);
  std::string text(page_template());
  replace_once(text, "__TITLE__", html_text(data.title));
  replace_once(text, "__DOCUMENT__", packed_text({reinterpret_cast<const std::uint8_t*>(document.json.data()), document.json.size()}));
  replace_once(text, "__NUMBERS__", document.numbers);
  return text;
}

void write_page(const std::filesystem::path& path, const PageData& data) { io::write_atomically(path, page(data)); }

}  // namespace arenite::report
