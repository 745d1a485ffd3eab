#pragma once
#include <array>
#include <vector>

#include "model/contacts.hpp"
#include "model/grains.hpp"

namespace arenite::io {

/// A column of real numbers: name, SI unit ("1" if it has none) and where it lives. Every format takes its columns here.
template <class Owner>
struct Column {
  const char* name;
  const char* unit;
  std::vector<double> Owner::*member;
};

/// What changes from frame to frame; radius, id, material and zone do not.
inline constexpr std::array<Column<Grains>, 6> grain_state_columns{{{"x", "m", &Grains::x},
                                                                    {"y", "m", &Grains::y},
                                                                    {"angle", "rad", &Grains::angle},
                                                                    {"vx", "m/s", &Grains::vx},
                                                                    {"vy", "m/s", &Grains::vy},
                                                                    {"omega", "rad/s", &Grains::omega}}};

inline constexpr std::array<Column<Contacts>, 8> contact_columns{{{"nx", "1", &Contacts::nx},
                                                                  {"ny", "1", &Contacts::ny},
                                                                  {"fn", "N", &Contacts::fn},
                                                                  {"ft", "N", &Contacts::ft},
                                                                  {"arm_i", "m", &Contacts::arm_i},
                                                                  {"arm_j", "m", &Contacts::arm_j},
                                                                  {"overlap", "m", &Contacts::overlap},
                                                                  {"sliding_velocity", "m/s", &Contacts::sliding_velocity}}};

}  // namespace arenite::io
