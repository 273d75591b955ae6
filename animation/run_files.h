#pragma once

#include <string>
#include <vector>

#include "comparisons/run/film_shots.h"
#include "contact/case.h"

namespace tricontact::animation {

/// What the folder of a finished run holds of one model.
struct RunFiles {
    contact::Case c;
    std::string model;
    std::vector<comparisons::Shot> shots;    ///< the surfaces that were written, in their order
    std::vector<contact::StepRecord> steps;  ///< of all steps, as far as history.csv is read:
                                             ///< phase, offset, shift, tangential force
};

/// Reads it; `model` empty: the last one of the case. Throws contact::InputError where the folder
/// is none of a run, has no such model or no surfaces of it, and where a file is not as it was
/// written.
RunFiles read_run(const std::string& folder, std::string model);

}  // namespace tricontact::animation
