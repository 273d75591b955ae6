#pragma once

#include <cmath>

#include "contact/substrates/material.h"

namespace tricontact::contact {

/// Dundurs' |beta| up to which half-spaces count as uncoupled: for all models, checks and reports.
inline constexpr double negligible_beta = 1e-3;

/// Whether half-spaces of these materials couple normal and tangential contact.
inline bool half_spaces_couple(const MaterialPair& materials) {
    return std::abs(materials.dundurs_beta()) > negligible_beta;
}

}  // namespace tricontact::contact
