#include "contact/substrates/relaxation.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "contact/base/error.h"
#include "contact/base/root.h"
#include "contact/base/special_values.h"

namespace tricontact::contact {

namespace {

/// The stiffness a + G(s)/G_inf at the Laplace variable s = -rate, in which each branch has a pole.
/// Positions are told by the distance to the nearest pole above, over it: roots may come close.
class Stiffness {
  public:
    Stiffness(const Relaxation& relaxation, double spring)
        : spring_(spring), branches_(relaxation.branches) {
        std::sort(branches_.begin(), branches_.end(),
                  [](const auto& a, const auto& b) { return a.time > b.time; });
    }
    std::size_t size() const { return branches_.size(); }
    double pole(std::size_t i) const { return 1 / branches_[i].time; }
    /// Distance of the pole below over pole i; 1 below the lowest.
    double widest(std::size_t i) const { return i == 0 ? 1 : 1 - pole(i - 1) / pole(i); }

    /// Times `distance`, so that the pole above is none.
    double scaled(std::size_t i, double distance) const {
        const double rate = pole(i) * (1 - distance);
        double sum = distance * (1 + spring_) - branches_[i].ratio * (1 - distance);
        for (std::size_t k = 0; k < size(); ++k)
            if (k != i) sum += distance * branches_[k].ratio * rate / above(k, i, distance);
        return sum;
    }
    /// Derivative by s.
    double slope(std::size_t i, double distance) const {
        double sum = 0;
        for (std::size_t k = 0; k < size(); ++k) {
            const double to_pole = k == i ? distance : above(k, i, distance) / pole(k);
            sum += branches_[k].ratio / (pole(k) * to_pole * to_pole);
        }
        return sum;
    }

  private:
    /// The rate less pole k, by the same difference as widest(): rounding does not change its sign.
    double above(std::size_t k, std::size_t i, double distance) const {
        return pole(i) * ((1 - pole(k) / pole(i)) - distance);
    }

    double spring_;
    std::vector<Relaxation::Branch> branches_;
};

double root_below(const Stiffness& stiffness, std::size_t i) {
    // Towards the pole below the stiffness grows without limit, towards the one above it falls.
    const double widest = stiffness.widest(i) * (1 - std::numeric_limits<double>::epsilon());
    return bracketed_root([&](double distance) { return stiffness.scaled(i, distance); }, 0.,
                          widest);
}

}  // namespace

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
        if (!is_positive_and_finite(ratio))
            throw InputError(
                fmt::format("substrate.relaxation: a modulus of {:.6g} times the relaxed one; "
                            "moduli of branches "
                            "must be positive and finite, or G(t) would grow with time; correct it",
                            ratio));
        if (!is_positive_and_finite(time))
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

Retardation::Retardation(const Relaxation& relaxation, double spring) : relaxed(1 / (1 + spring)) {
    check(relaxation);
    const Stiffness stiffness(relaxation, spring);
    for (std::size_t i = 0; i < stiffness.size(); ++i) {
        const double distance = root_below(stiffness, i);
        const double rate = stiffness.pole(i) * (1 - distance);
        branches.push_back({1 / (rate * stiffness.slope(i, distance)), 1 / rate});
    }
}

}  // namespace tricontact::contact
