#pragma once
#include "core/parameters.hpp"

namespace arenite {
enum class AmplitudeConvention;
}

/// Every key of a film's recipe, and of its parts where they stand alone.
namespace arenite::recipe {

struct FilmRecipe;
struct FilmSection;
struct LockinSection;
struct LockinAlone;
struct StepSection;
struct PictureSection;
struct CorrectionSection;
struct ForcesSection;

void declare(ParameterVisitor& visitor, FilmRecipe& recipe);
void declare(ParameterVisitor& visitor, FilmSection& section);
void declare(ParameterVisitor& visitor, LockinSection& lockin);
void declare(ParameterVisitor& visitor, LockinAlone& lockin);
/// Whether values of an oscillation are its amplitude or peak to peak.
void declare(ParameterVisitor& visitor, const Key& key, AmplitudeConvention& convention);
void declare(ParameterVisitor& visitor, StepSection& step);
void declare(ParameterVisitor& visitor, PictureSection& picture);
void declare(ParameterVisitor& visitor, CorrectionSection& correction);
void declare(ParameterVisitor& visitor, ForcesSection& forces);

}  // namespace arenite::recipe
