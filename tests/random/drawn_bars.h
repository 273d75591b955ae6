#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "contact/case.h"

namespace tricontact::random_cases {

/// A case for runs beside finer ones: one model, coarse, few steps.
struct DrawnRun {
    contact::Case c;
    std::string text;                        ///< for people: model, body, kind of loading
    bool has_closed_form = false;            ///< of d and a on the half-space
    std::optional<double> exact_shift = {};  ///< of its path's end, which has not slipped [m]
};

DrawnRun drawn_run(std::uint64_t seed);

}  // namespace tricontact::random_cases
