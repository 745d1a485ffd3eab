#pragma once
#include <cstdint>

#include "io/hdf5_reader.hpp"
#include "io/hdf5_writer.hpp"
#include "model/result.hpp"

// What every kind of result says about itself.
namespace arenite::io {

void write_provenance(const Hdf5Writer& at, const Provenance& provenance);
Provenance read_provenance(const Hdf5Reader& group);

/// What made a result, its name and how it ended, as the groups "provenance" and "outcome", and back; the file itself says in its
/// attributes what it is.
template <class Result>
void write_origin(const Hdf5Writer& at, const Result& result) {
  at.set("source", "Arenite " + result.provenance.version);
  at.set("stage", result.name);
  at.set("layout", "docs/hdf5.md of Arenite says what lies where; `arenite export --to netcdf` writes arrays over (time, grain)");
  write_provenance(at, result.provenance);
  const auto outcome = at.create_group("outcome");
  outcome.set("name", result.name);
  outcome.set("converged", std::int64_t{result.converged});
  outcome.set("outcome", result.outcome);
}
template <class Result>
void read_origin(const Hdf5Reader& at, Result& result) {
  result.provenance = read_provenance(at.group("provenance"));
  const auto outcome = at.group("outcome");
  result.name = outcome.label("name");
  result.converged = outcome.integer("converged") != 0;
  result.outcome = outcome.label("outcome");
}

void write_history(const Hdf5Writer& at, const char* name, const History& history);
History read_history(const Hdf5Reader& group);

}  // namespace arenite::io
