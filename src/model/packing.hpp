#pragma once
#include "model/contacts.hpp"
#include "model/domain.hpp"
#include "model/grains.hpp"
#include "model/material.hpp"

namespace arenite {

/// Grains in their frame, with the contacts between them where these are known. This is what one stage hands to the
/// next, and what texture, exports and figures read, whether it was simulated or measured.
struct Packing {
  Materials materials;
  Domain domain;
  Grains grains;
  Contacts contacts;
};

}  // namespace arenite
