#pragma once

#include "contact/base/special_values.h"

namespace tricontact::contact {

/// Preconditioned conjugate gradients on H x = b, H and the preconditioner symmetric and positive
/// definite on the subspace that their users keep to, such as the balance of forces. What a step
/// does to the fields is theirs:
///   is_solved()     the residual r is small enough
///   precondition()  z from r; returns <r, z>
///   turn(beta)      direction d <- z + beta d
///   apply()         H d; returns <d, H d>
///   move(step)      x <- x + step d, r <- r - step H d
/// Returns the number of steps, `most` at the most. Ends too where rounding leaves nothing to be
/// moved.
template <class IsSolved, class Precondition, class Turn, class Apply, class Move>
int conjugate_gradients(int most, IsSolved is_solved, Precondition precondition, Turn turn,
                        Apply apply, Move move) {
    double last = 1;
    for (int k = 0;; ++k) {
        if (is_solved() || k == most) return k;
        const double norm = precondition();
        if (!(norm > 0)) return k;
        turn(k == 0 ? 0 : norm / last);
        last = norm;
        const double step = norm / apply();
        if (!is_positive_and_finite(step)) return k + 1;
        move(step);
    }
}

}  // namespace tricontact::contact
