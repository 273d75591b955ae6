#pragma once

#include <map>
#include <string>
#include <utility>

#include "tests/random/drawn_law.h"

namespace tricontact {

/// What is said of rigs whose law of friction is drawn at random.
struct LawCounts {
    struct Rigs {
        int all = 0, named = 0, open = 0, wrong = 0;  ///< open: the true law is among those left
    };
    struct Intervals {
        int all = 0, held = 0;
    };
    std::map<std::string, Rigs> rigs;            ///< by law, and "all"
    std::map<std::string, Intervals> intervals;  ///< of the true law's numbers, and "all"
};

inline double truth_of_law(const experiments::FreeParameter& p, const experiments::LawFit& fit,
                           const contact::Case& truth) {
    if (p.key == "substrate.young") return truth.substrate.young;
    if (p.key == "friction.shear_strength") return *truth.friction.shear_strength;
    if (p.key == "friction.pressure_exponent") return *truth.friction.pressure_exponent;
    double mu = *truth.friction.coefficient;
    if (truth.friction.pressure_exponent)  // mu is that at the pressure of reference
        mu *= std::pow(
            *fit.input.rig.friction.reference_pressure / *truth.friction.reference_pressure,
            *truth.friction.pressure_exponent - 1);
    return mu;
}

/// The laws that are drawn are those compared. Noise of 1 or 2 %, stated or not, in turn.
inline LawCounts count_law_rigs(std::uint64_t seed, int n, const std::vector<std::string>& laws) {
    Random random(seed);
    const contact::ModelMakers makers;
    LawCounts counts;
    for (int i = 0; i < n; ++i) {
        const DrawnLawRig rig = drawn_law_rig(random, laws, i % 2 ? .01 : .02, i / 2 % 2);
        const auto found = experiments::compare_laws(rig.input, laws, {makers, 1});
        const auto& of_truth = *std::find_if(found.laws.begin(), found.laws.end(),
                                             [&](const auto& f) { return f.law->name == rig.law; });
        for (const std::string& row : {rig.law, std::string("all")}) {
            LawCounts::Rigs& count = counts.rigs[row];
            ++count.all;
            if (found.named)
                ++(found.laws[*found.named].law->name == rig.law ? count.named : count.wrong);
            else
                ++(of_truth.is_excluded() ? count.wrong : count.open);
        }
        for (std::size_t k = 0; k < of_truth.found.free.size(); ++k) {
            const auto& p = of_truth.found.free[k];
            const auto& [low, high] = of_truth.found.parameters[k].likelihood;
            const double value = truth_of_law(p, of_truth, rig.truth);
            for (const std::string& row : {p.symbol, std::string("all")}) {
                ++counts.intervals[row].all;
                counts.intervals[row].held += low <= value && value <= high;
            }
        }
    }
    return counts;
}

}  // namespace tricontact
