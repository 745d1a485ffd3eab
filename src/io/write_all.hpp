#pragma once
#include <cstddef>
#include <string_view>

namespace arenite::io {

/// Writes all bytes, however often the system takes a part of them or is interrupted. 0, or the `errno` that it failed with;
/// `written`, if given, is then how many bytes went out.
int write_all(int descriptor, std::string_view bytes, std::size_t* written = nullptr);

}  // namespace arenite::io
