#pragma once

#include <stdexcept>
#include <string>

namespace tricontact::theory {

/// Throws std::domain_error "theory: name must lie in [0, 1]" if it does not.
inline void check_unit_interval(const char* theory, const char* name, double value) {
    if (!(value >= 0 && value <= 1))
        throw std::domain_error(std::string(theory) + ": " + name + " must lie in [0, 1]");
}

}  // namespace tricontact::theory
