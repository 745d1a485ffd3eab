#pragma once
#include <cstdint>
#include <vector>

namespace arenite::inference {

/// What is known of proposed contacts, one value each: the normal force inferred with all of them in the equations, its
/// standard error, and by how much the two surfaces overlap in the picture (below 0: they are apart).
struct ContactEvidence {
  std::vector<double> fn, fn_error;  ///< N
  std::vector<double> overlap;       ///< m
  std::vector<int> kind;             ///< contacts that share a stiffness (a pair of materials, a wall), from 0
  double widest_gap = 0;             ///< to which contacts were proposed, m
};

struct Presence {
  std::vector<double> probability;  ///< that the contact is there
  std::vector<double> idle;  ///< that it neither is there nor lost a force on the way, so that no equation needs it
  double expected = 0, error = 0;  ///< number of contacts that are there
  double error_scale = 1;  ///< by which forces of contacts that are not there scatter more than their errors say
};

/// Probability of every proposed contact. Forces and overlaps of all of them are taken as a mixture: contacts that are
/// not there have forces that scatter about zero, and gaps of any width that was proposed; those that lost their force
/// on the way likewise, with forces below zero; those that are there have forces of a law of its own (steps of 0.3 mean
/// forces and wider, so that it goes on smoothly to weak forces, where the two cannot be told apart one by one) and
/// overlaps linear in their force, as strong contacts of their kind show. Shares, law and scatter are those that make
/// the data likeliest (expectation maximisation). The sum of probabilities counts what noise hides, and counts out what
/// it feigns.
Presence presence(const ContactEvidence& evidence);

/// 1 for the contacts taken as there: the likeliest, as many as are expected, so that misses and false alarms cancel.
std::vector<std::uint8_t> taken_as_present(const Presence& presence);

}  // namespace arenite::inference
