# Headers of other people's libraries that most sources read, compiled once for each set of flags. Nothing of src/ is
# among them, so that a change of ours compiles what includes it and nothing else.
set(arenite_common_headers
  <algorithm> <array> <cmath> <cstdint> <filesystem> <functional> <map> <memory> <numeric> <optional> <span> <string>
  <string_view> <vector> <fmt/core.h>)

# For a target without loops over grains, nodes or pixels: -O1 compiles sooner by a quarter, and the loops' precompiled
# headers serve it, with the loops' other flags. Inline functions that it shares with the loops may be linked from it;
# they are copies of strings, lists and nouns, and none is in a kernel (compare what `nm` says of both).
function(compile_cold target)
  set_target_properties(${target} PROPERTIES CXX_VISIBILITY_PRESET hidden)
  target_compile_options(${target} PRIVATE ${CMAKE_CXX_COMPILE_OPTIONS_PIC})
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
  target_precompile_headers(${target} REUSE_FROM arenite_loops)
endfunction()

# GCC 12 suspects its own std::string of reading too far in these.
set_source_files_properties(src/grains/texture/distribution.cpp src/io/table/laboratory_table.cpp
  PROPERTIES SKIP_PRECOMPILE_HEADERS ON)
