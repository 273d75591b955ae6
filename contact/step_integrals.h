#pragma once

#include <cmath>

namespace tricontact::contact {

/// Integrals over a step of duration x relaxation times of a variable that starts at e, is driven
/// by w in all at a constant rate, and decays:
///   e(s) = e exp(-s x) + w mean(s x) s,   0 <= s <= 1,   mean(x) = (1 - exp(-x))/x.
/// What a dashpot dissipates is <e, e> ee + 2 <e, w> ew + <w, w> ww; the variable's mean is
/// e mean + w drift.
struct StepIntegrals {
    explicit StepIntegrals(double x) {
        if (x < small) {
            ee = x - x * x + 2 * x * x * x / 3;
            ew = x / 2 - x * x / 2 + 7 * x * x * x / 24;
            ww = x / 3 - x * x / 4 + 7 * x * x * x / 60;
            mean = 1 - x / 2 + x * x / 6;
            drift = 1. / 2 - x / 6 + x * x / 24;
            return;
        }
        const double once = -std::expm1(-x);
        ee = -std::expm1(-2 * x) / 2;
        ew = (once - ee) / x;
        ww = std::isinf(x) ? 0 : (ee - 2 * once + x) / (x * x);
        mean = once / x;
        drift = (1 - mean) / x;
    }
    /// Below, the series' next terms are 1e-13 of their first, above, cancellation costs no more.
    static constexpr double small = 1e-4;
    double ee, ew, ww, mean, drift;
};

}  // namespace tricontact::contact
