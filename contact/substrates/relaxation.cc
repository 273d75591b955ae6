#include "contact/substrates/relaxation.h"

#include <fmt/format.h>

#include <cmath>

#include "contact/error.h"

namespace tricontact::contact {

double Relaxation::instantaneous_ratio() const {
    double sum = 1;
    for (const Branch& branch : branches) sum += branch.ratio;
    return sum;
}

std::complex<double> Relaxation::dynamic_ratio(double omega) const {
    std::complex<double> sum = 1;
    for (const Branch& branch : branches) {
        const std::complex<double> x(0, omega * branch.time);
        sum += branch.ratio * x / (1. + x);
    }
    return sum;
}

void check(const Relaxation& relaxation) {
    for (const auto& [ratio, time] : relaxation.branches) {
        if (!(ratio > 0) || !std::isfinite(ratio))
            throw InputError(
                fmt::format("substrate.relaxation: a modulus of {:.6g} times the relaxed one; "
                            "moduli of branches "
                            "must be positive and finite, or G(t) would grow with time; correct it",
                            ratio));
        if (!(time > 0) || !std::isfinite(time))
            throw InputError(
                fmt::format("substrate.relaxation: a relaxation time of {:.6g} s; times must be "
                            "positive and finite; correct it",
                            time));
    }
}

RelaxationStep::RelaxationStep(const Relaxation& relaxation, double duration) {
    for (const auto& [ratio, time] : relaxation.branches) {
        const double x = duration / time;
        const double mean = x == 0 ? 1 : std::isinf(x) ? 0 : -std::expm1(-x) / x;
        decay.push_back(std::exp(-x));
        gain.push_back(ratio * mean);
        stiffness += ratio * mean;
    }
}

}  // namespace tricontact::contact
