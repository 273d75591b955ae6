// Whether the strains under a sphere are small enough for linear elasticity.
#include <fmt/format.h>

#include <cmath>
#include <cstdlib>

#include "experiments/assumptions/rolling_parts.h"

namespace tricontact::experiments {

namespace {

// Fitted to finite elements by the linear and the neo-Hookean law on bonded incompressible layers
// (scripts/finite_strain_fit.sh, which also tells what the fit leaves).
constexpr const char* strain_source = "fit to finite elements, docs/explanation/rig.md";
constexpr double thickest = 0.14, thinnest = 0.7;  // a/b
constexpr double least_friction = 0.3, most_friction = 0.9;
constexpr double largest_slope = 0.22;  // a/R
constexpr double least_poisson = 0.49;
// Standard errors over a/R: what the fit leaves (rms .0036, .0002) and the mesh of the runs.
constexpr double shift_scatter = 0.012, indentation_scatter = 0.001;

constexpr Inputs strain_inputs = layer_inputs + Inputs{&Rig::mu};

struct Slenderness {
    double over_radius, over_thickness;  ///< a/R, a/b of the linear layer
};

Slenderness slenderness_of(const RigData& r) {
    const double a = layer_of(r).contact_radius;
    return {a / r.R, a / r.b};
}

constexpr Formula strain_measure("strain_measure", "a/R", "a of the linear layer", exact_layer, "1",
                                 strain_inputs,
                                 [](const RigData& r) { return slenderness_of(r).over_radius; });

/// U_stat by the linear law over that at finite strains, minus 1, at coupling_tangential_ratio.
double shift_off(const RigData& r) {
    const auto [slope, t] = slenderness_of(r);
    const double mu = r.mu;
    const auto quadratic = [mu](double c0, double c1, double c2) {
        return c0 + mu * (c1 + mu * c2);
    };
    return slope *
           (quadratic(.2377, -.0584, .0169) +
            t * t * (quadratic(-.8616, 2.1312, -1.3926) + t * quadratic(.3143, -1.3043, .9219)));
}

/// The same of d.
double indentation_off(const RigData& r) {
    const auto [slope, t] = slenderness_of(r);
    return -slope * (.0478 - t * t * (.1945 - .181 * t));
}

/// The linear law's over the quantity at finite strains, minus 1, and its size.
struct StrainError {
    Calculation error, size;
};

StrainError strain_error(const Rig& rig, const std::string& name, const std::string& ratio,
                         const char* formula, double scatter, double (*off)(const RigData&)) {
    constexpr Inputs inputs = strain_inputs + Inputs{&Rig::delta};
    Rig fitted = rig;
    fitted.delta = {0, scatter};
    const auto error = [off](const RigData& r) {
        return off(r) + r.delta * slenderness_of(r).over_radius;
    };
    return {calculate(fitted, name, ratio + " - 1", formula, strain_source, "1", inputs, error),
            calculate(fitted, name + "_error", "|" + ratio + " - 1|", formula, strain_source, "1",
                      inputs, [error](const RigData& r) { return std::abs(error(r)); })};
}

/// What the fit does not reach; empty where it holds.
std::string out_of_fit(const Rig& rig) {
    const auto [slope, t] = slenderness_of(rig);
    const auto outside = [](const char* symbol, double value, double low, double high) {
        return fmt::format(
            "an estimate for {} = {}: it is known from {} to {}; tricontact "
            "deviation --finite-strain computes it",
            symbol, significant(value, 3), low, high);
    };
    if (rig.nu_2 < least_poisson) return outside("nu_2", rig.nu_2, least_poisson, .5);
    if (t < thickest || t > thinnest) return outside("a/b", t, thickest, thinnest);
    if (slope > largest_slope) return outside("a/R", slope, 0, largest_slope);
    if (rig.mu < least_friction || rig.mu > most_friction)
        return outside("mu", rig.mu, least_friction, most_friction);
    return {};
}

}  // namespace

Assumption small_strains(const Rig& rig) {
    using enum Criterion::Relation;
    Assumption a{.name = "small_strains",
                 .title = "Small strains",
                 .claim = "The substrate's strains are small: linear elasticity holds"};
    if (!roller_is_rigid(rig)) {
        a.missing = {theory_of_elastic_roller};
        return a;
    }
    a.background = {calculate(rig, strain_measure)};
    if (std::string why = out_of_fit(rig); !why.empty()) {
        a.missing = {std::move(why)};
        return a;
    }
    for (const StrainError& one :
         {strain_error(rig, "strain_shift", "U_stat linear/U_stat",
                       "a/R f(a/b, mu) + delta a/R, f fitted", shift_scatter, shift_off),
          strain_error(rig, "strain_indentation", "d linear/d", "a/R f(a/b) + delta a/R, f fitted",
                       indentation_scatter, indentation_off)}) {
        a.criteria.push_back({one.size, at_most, accepted_difference, accepted_reason});
        a.background.push_back(one.error);
    }
    const auto part = [&](std::size_t i, double off) {
        const Estimate& e = a.criteria[i].calculation.result;
        return fmt::format("{} % too {}", with_error(100 * e.value, 100 * e.standard_error, 2),
                           off > 0 ? "high" : "low");
    };
    a.consequence = fmt::format(
        "Beside a neo-Hookean rubber linear elasticity puts the static shift at F_T = {} mu F_N "
        "{}, "
        "the indentation {}. What rolling adds to the shift is off by more: tricontact deviation "
        "--finite-strain computes it.",
        coupling_tangential_ratio, part(0, shift_off(rig)), part(1, indentation_off(rig)));
    return a;
}

}  // namespace tricontact::experiments
