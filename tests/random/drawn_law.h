#pragma once

#include <random>
#include <string>
#include <vector>

#include "contact/model_makers.h"
#include "experiments/identification/identification_models.h"
#include "experiments/identification/law_comparison.h"
#include "tests/random/law_rig.h"
#include "tests/random/random_rig.h"

namespace tricontact {

/// A rig under a law of friction drawn at random, with tables measured on it.
struct DrawnLawRig {
    std::string law;  ///< of io::measurement_laws()
    contact::Case truth;
    experiments::IdentificationInput input;
};

/// One of the laws. Static shifts under four loads, limits of sliding under six, indentations;
/// noise of `noise` of the largest value of each table, stated or not. Both parts of a sum have a
/// third of friction at least; exponents are .35 to .75, beside a strength also 1.4 to 1.9.
inline DrawnLawRig drawn_law_rig(Random& random, const std::vector<std::string>& laws, double noise,
                                 bool states_errors) {
    using Measurement = experiments::IdentificationInput::Measurement;
    constexpr int n_loads = 4, n_forces = 6, n_limits = 8, n_depths = 10;
    DrawnLawRig rig;
    rig.law = laws[std::uniform_int_distribution<std::size_t>(0, laws.size() - 1)(random)];
    contact::Case& c = rig.truth;
    c.indenter.radius = between(random, {5e-3, 40e-3});
    c.substrate = {std::exp(between(random, {std::log(.5e6), std::log(5e6)})), .5};
    const double largest = between(random, {.5, 5}), least = largest / between(random, {8, 20});
    const auto load = [&](int i, int n) { return least * std::pow(largest / least, i / (n - 1.)); };
    const LawRig pressed(c.indenter.radius, c.substrate.young, {});
    const double a = pressed.contact_radius(load(1, 3));
    const double mean = load(1, 3) / (std::numbers::pi * a * a), mu = between(random, {.3, 1.5});
    const double share = between(random, {.33, .67}), n = between(random, {.35, .75});
    c.friction = {};
    if (rig.law == "coulomb") c.friction.coefficient = mu;
    if (rig.law == "shear-strength") c.friction.shear_strength = mu * mean;
    if (rig.law == "strength-and-coulomb") {
        c.friction.coefficient = (1 - share) * mu;
        c.friction.shear_strength = share * mu * mean;
    }
    if (rig.law == "power") {
        c.friction.coefficient = mu;
        c.friction.pressure_exponent = n;
        c.friction.reference_pressure = mean;
    }
    if (rig.law == "strength-and-power")
        c.friction = {.coefficient = (1 - share) * mu,
                      .shear_strength = share * mu * mean,
                      .pressure_exponent = random() % 2 ? n : between(random, {1.4, 1.9}),
                      .reference_pressure = mean};
    const LawRig real(c.indenter.radius, c.substrate.young, [f = c.friction](double p) {
        const double by_pressure =
            f.pressure_exponent
                ? *f.reference_pressure * std::pow(p / *f.reference_pressure, *f.pressure_exponent)
                : p;
        return f.shear_strength.value_or(0) + f.coefficient.value_or(0) * by_pressure;
    });
    experiments::IdentificationInput::Table shifts{.measurement = Measurement::static_shift},
        depths{.measurement = Measurement::force_indentation},
        limits{.measurement = Measurement::sliding_force};
    for (int i = 0; i < n_loads; ++i)
        for (int k = 1; k <= n_forces; ++k) {
            const double normal = load(i, n_loads);
            const double force = .9 * real.limit(normal) * k / n_forces;
            shifts.normal_forces.push_back(normal);
            shifts.given.push_back(force);
            shifts.observed.push_back(real.shift(normal, force));
        }
    const double deepest = std::pow(real.contact_radius(largest), 2) / c.indenter.radius;
    for (int i = 1; i <= n_depths; ++i) {
        depths.given.push_back(deepest * i / n_depths);
        depths.observed.push_back(real.load_at_depth(depths.given.back()));
    }
    for (int i = 0; i < n_limits; ++i) {
        limits.given.push_back(load(i, n_limits));
        limits.observed.push_back(real.limit(limits.given.back()));
    }
    std::normal_distribution<double> gauss;
    for (auto* table : {&shifts, &depths, &limits}) {
        const double error =
            noise * *std::max_element(table->observed.begin(), table->observed.end());
        for (double& value : table->observed) value += error * gauss(random);
        if (states_errors) table->standard_errors.assign(table->observed.size(), error);
        rig.input.tables.push_back(*table);
    }
    rig.input.rig = c;
    rig.input.rig.friction = {.coefficient = 1};
    rig.input.rig.load.normal_force = largest;
    rig.input.models = {"half-space"};
    rig.input.rig.substrate.young *= between(random, {.6, 1.6});  // where the search starts
    rig.input.parameters = experiments::free_parameters(rig.input, {"substrate.young"});
    return rig;
}

}  // namespace tricontact
