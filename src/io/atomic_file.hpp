#pragma once
#include <filesystem>
#include <string_view>

namespace arenite::io {

/// Writes `bytes` to `path` all or nothing: beside it as ".name.tmp", flushed to the disk, then renamed. Whatever
/// happens before the rename (full disk, no permission, a kill), a file that was there stays as it was. Two processes
/// that write the same path take turns; what a killed one left is taken over. The folder must exist.
/// Throws InputError (place, reason, mend) when the system refuses.
void write_atomically(const std::filesystem::path& path, std::string_view bytes);

}  // namespace arenite::io
