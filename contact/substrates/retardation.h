#pragma once

#include <vector>

#include "contact/substrates/relaxation.h"

namespace tricontact::contact {

/// Creep of a relaxing spring beside an elastic one: with the stiffnesses a and G(t)/G_inf, unit
/// load displaces by
///   J(t) = relaxed - sum compliance_i exp(-t/time_i),
/// a generalised Kelvin solid with as many branches as the relaxation, each slower than one of
/// them. Tschoegl (1989), The Phenomenological Theory of Linear Viscoelastic Behavior, ch. 4.
struct Retardation {
    struct Branch {
        double compliance = 0;  ///< [-], > 0
        double time = 0;        ///< [s]
    };

    /// `spring` [-]: a >= 0. Throws InputError for a relaxation that check() refuses.
    Retardation(const Relaxation& relaxation, double spring);

    double relaxed = 1;  ///< 1/(a + 1)
    std::vector<Branch> branches;
};

}  // namespace tricontact::contact
