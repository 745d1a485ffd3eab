#pragma once
#include <array>
#include <optional>

#include "io/hdf5_reader.hpp"
#include "io/hdf5_writer.hpp"

namespace arenite::io {

/// A number of a struct, stored as an attribute of this name.
template <class Owner>
struct Scalar {
  const char* name;
  double Owner::*member;
  std::optional<double> without = {};  ///< of files that do not have it; none: such a file is refused
};

template <class Owner, std::size_t n>
void write_scalars(const Hdf5Writer& at, const std::array<Scalar<Owner>, n>& scalars, const Owner& from) {
  for (const auto& s : scalars) at.set(s.name, from.*s.member);
}

template <class Owner, std::size_t n>
void read_scalars(const Hdf5Reader& at, const std::array<Scalar<Owner>, n>& scalars, Owner& into) {
  for (const auto& s : scalars) into.*s.member = s.without && !at.has_attribute(s.name) ? *s.without : at.number(s.name);
}

}  // namespace arenite::io
