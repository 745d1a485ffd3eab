#include "io/result_groups.hpp"

namespace arenite::io {

void write_provenance(const Hdf5Writer& at, const Provenance& provenance) {
  const auto group = at.create_group("provenance");
  group.set("version", provenance.version);
  group.set("stage", provenance.stage);
  group.set("input_hash", provenance.input_hash);
  group.set("seed", provenance.seed);
  group.set("kernel", provenance.kernel);
  group.write_text("recipe", provenance.recipe);
  const auto options = group.create_group("options");
  for (const auto& [key, value] : provenance.options) options.set(key, value);
}

Provenance read_provenance(const Hdf5Reader& group) {
  Provenance provenance;
  provenance.version = group.label("version");
  provenance.stage = group.label("stage");
  provenance.input_hash = group.label("input_hash");
  provenance.seed = group.natural("seed");
  provenance.kernel = group.label("kernel");
  provenance.recipe = group.text("recipe");
  const auto options = group.group("options");
  for (const auto& key : options.attribute_names()) provenance.options.emplace_back(key, options.label(key));
  return provenance;
}

void write_history(const Hdf5Writer& at, const char* name, const History& history) {
  const auto group = at.create_group(name);
  for (const auto& column : history.columns) group.write(column.name, column.values, column.unit);
}

History read_history(const Hdf5Reader& group) {
  History history;
  for (const auto& name : group.names()) history.columns.push_back({name, group.unit(name), group.doubles(name)});
  return history;
}

}  // namespace arenite::io
