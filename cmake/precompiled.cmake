# Headers of other people's libraries that most sources read, compiled once for each target with its own flags. Nothing of src/ is among
# them, so that a change of ours compiles what includes it and nothing else.
set(arenite_common_headers <algorithm> <array> <cmath> <cstdint> <filesystem> <functional> <map> <memory> <numeric> <optional> <span>
  <string> <string_view> <vector> <fmt/format.h>)
# GCC 12 suspects its own std::string of reading too far in these.
set_source_files_properties(src/grains/texture/distribution.cpp src/io/table/laboratory_table.cpp
  src/solid/stress/numbers.cpp PROPERTIES SKIP_PRECOMPILE_HEADERS ON)
