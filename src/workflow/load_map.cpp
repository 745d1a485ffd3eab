#include "workflow/load_map.hpp"

#include <cmath>
#include <numbers>

#include "core/hash.hpp"
#include "core/version.hpp"
#include "io/read_file.hpp"
#include "workflow/field_numbers.hpp"
#include "workflow/stage_keys.hpp"

namespace arenite::study {

FieldResult sample_of_map(PhaseMap map, const raster::CavityRules& rules) {
  check(map);
  std::size_t particle = 0;
  for (const Phase p : map.phase) particle += p == Phase::particle;
  // Without particles the unit of volume is a node.
  const double grains = static_cast<double>(map.grain_class.size());
  const double nodes_per_grain = grains > 0 && particle > 0 ? static_cast<double>(particle) / grains : 1;
  FieldResult sample;
  sample.name = "map";
  sample.numbers = map_numbers(map, rules, map.dx * std::sqrt(nodes_per_grain / std::numbers::pi));
  sample.map = std::move(map);
  return sample;
}

void count_lengths_in_nodes(FieldResult& sample) {
  Numbers& map = sample.numbers["map"];
  map.erase("dx_m");
  map["lengths"] = "in nodes, since --dx was not given";
}

void sign(FieldResult& result, const std::filesystem::path& source, const std::string& asked, const Load& load) {
  HashBuilder hash;
  hash.add("map", content_hash(io::read_file(source))).add("options", asked);
  result.provenance.version = version;
  result.provenance.stage = load.name;
  result.provenance.input_hash = load_key(load, hash.hex());
  result.provenance.options = {{"map", source.filename().string()}, {"options", asked}};
}

}  // namespace arenite::study
