#pragma once
#include <string>
#include <string_view>

namespace arenite::python {

/// The argument that is the option of this name, for sentences of the library: `slice`, `frame_rate`.
std::string argument_of(std::string_view option);

}  // namespace arenite::python
