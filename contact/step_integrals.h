#pragma once

#include <cmath>

namespace tricontact::contact {

/// Integrals over a step of duration x relaxation times of a variable that starts at e, is driven
/// by w in all at a constant rate, and decays:
///   e(s) = e exp(-s x) + w mean(s x) s,   0 <= s <= 1,   mean(x) = (1 - exp(-x))/x.
/// What a dashpot dissipates is <e, e> ee + 2 <e, w> ew + <w, w> ww; the variable's mean is
/// e mean + w drift.
/// All to rounding of 1.
struct StepIntegrals {
    explicit StepIntegrals(double x) {
        const double once = -std::expm1(-x);
        mean = x == 0 ? 1 : std::isinf(x) ? 0 : once / x;
        drift = drift_of(x);
        ee = -std::expm1(-2 * x) / 2;
        ew = once * mean / 2;
        ww = drift - mean * mean / 2;
    }
    double ee, ew, ww, mean, drift;

  private:
    // (1 - mean)/x = (x - 1 + exp(-x))/x^2, 1/2 at x = 0. The series leaves less than rounding
    // below 0.05, the direct form loses three digits there and fewer beyond.
    static double drift_of(double x) {
        constexpr double series_below = 0.05;
        if (std::isinf(x)) return 0;
        if (x >= series_below) return (x + std::expm1(-x)) / (x * x);
        double term = 0.5, sum = 0;
        for (int n = 3; n <= 11; ++n) {
            sum += term;
            term *= -x / n;
        }
        return sum;
    }
};

}  // namespace tricontact::contact
