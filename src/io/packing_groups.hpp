#pragma once
#include "io/hdf5_reader.hpp"
#include "io/hdf5_writer.hpp"
#include "model/packing.hpp"

// A packing and its parts as groups, whichever result holds them.
namespace arenite::io {

void write_materials(const Hdf5Writer& at, const Materials& materials);
Materials read_materials(const Hdf5Reader& at);
bool same(const Materials& a, const Materials& b);

void write_domain(const Hdf5Writer& at, const Domain& domain);
Domain read_domain(const Hdf5Reader& group);

/// Arrays of grains: without a `sample` those that name them, with one all that moves and what differs from the sample.
void write_grains(const Hdf5Writer& at, const Grains& grains, const Grains* sample);
Grains read_grains(const Hdf5Reader& group, const Hdf5Reader& sample);

void write_contacts(const Hdf5Writer& at, const Contacts& contacts);
/// Refuses contacts of grains that do not exist.
Contacts read_contacts(const Hdf5Reader& group, const Grains& grains);

/// A whole packing as the group "packing", and back.
void write_packing(const Hdf5Writer& at, const Packing& packing);
Packing read_packing(const Hdf5Reader& group);

}  // namespace arenite::io
