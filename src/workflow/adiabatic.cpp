#include "workflow/adiabatic.hpp"

#include <fmt/format.h>

#include "thermal/thermography/lockin.hpp"

namespace arenite::study {

Adiabatic::Adiabatic(double diffusivity, double frequency, double side) : length(thermography::diffusion_length(diffusivity, frequency)), pixel(side) {}

double Adiabatic::lost() const { return thermography::swing_lost_to_diffusion(length, pixel); }

std::string Adiabatic::sentence() const {
  return fmt::format("heat diffuses {:.3g} pixels far within a cycle, not far less than one: the finest detail of the swing is not adiabatic; raise the load frequency",
                     length / pixel);
}

}  // namespace arenite::study
