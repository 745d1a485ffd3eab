# Headers of other people's libraries that most sources read, compiled once for each target with its own flags. Nothing of src/ is among
# them, so that a change of ours compiles what includes it and nothing else.
set(arenite_common_headers <algorithm> <array> <cmath> <cstdint> <filesystem> <functional> <map> <memory> <numeric> <optional> <span>
  <string> <string_view> <vector> <fmt/format.h>)
