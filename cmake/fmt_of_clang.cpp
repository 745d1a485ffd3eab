// The distribution's libfmt is compiled by GCC, which gives this template another mangled name than clang 14 asks for.
#include <fmt/format.h>

namespace fmt::detail {
template void vformat_to(buffer<char>&, string_view, basic_format_args<FMT_BUFFER_CONTEXT(char)>, locale_ref);
}  // namespace fmt::detail
