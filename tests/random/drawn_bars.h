#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "contact/case.h"

namespace tricontact::random_cases {

/// A case for runs beside finer ones: one model, coarse, few steps.
struct DrawnRun {
    contact::Case c;
    std::string body, loading;               ///< for people
    bool has_closed_form = false;            ///< of d and a on the half-space
    std::optional<double> exact_shift = {};  ///< of its path's end, which has not slipped [m]

    std::string text() const { return c.models.front() + ' ' + body + ' ' + loading; }
};

DrawnRun drawn_run(std::uint64_t seed);
/// The same of fem: coarse elements, or those of its own choice.
DrawnRun drawn_fem_run(std::uint64_t seed);

/// Four steps for each of a case's: of rolling, of a path, of pressing. Turning points become 16
/// steps per quarter.
void quarter_steps(contact::Case& f);

}  // namespace tricontact::random_cases
