// The substrate's material: elastic at the speed of the drive, uncoupled, and what was fitted.
#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <optional>

#include "contact/base/error.h"
#include "contact/base/root.h"
#include "experiments/assumptions/rolling_parts.h"
#include "theory/layer/layer_compliance.h"

namespace tricontact::experiments {

namespace {

constexpr double largest_loss = 0.01;

constexpr Inputs viscous_inputs{&Rig::v,   &Rig::w,   &Rig::a_reference,
                                &Rig::eta, &Rig::E_2, &Rig::nu_2};
constexpr Inputs maxwell_inputs = viscous_inputs + Inputs{&Rig::G_ratio};

double shear_modulus_of(const RigData& r) {
    return contact::Material{r.E_2, r.nu_2}.shear_modulus();
}

// omega eta/G_1.
double viscous_ratio_of(const RigData& r) {
    return 2 * std::numbers::pi * r.v / (4 * r.w * r.a_reference) * r.eta / shear_modulus_of(r);
}

// omega tau, tau = eta/G_2.
double period_ratio_of(const RigData& r) {
    return viscous_ratio_of(r) / r.G_ratio;
}

constexpr Formula shear_modulus("shear_modulus", "G_1", "E_2/(2 (1 + nu_2))", "section 5.1.5", "Pa",
                                {&Rig::E_2, &Rig::nu_2}, shear_modulus_of);

constexpr Formula viscous_ratio("viscous_ratio", "omega eta/G_1",
                                "2 pi v/(4 w a) eta/G_1, G_1 = E_2/(2 (1 + nu_2))", "(5.1.17)", "1",
                                viscous_inputs, viscous_ratio_of);

constexpr Formula elastic_speed("elastic_speed", "v_max", "0.01 v/(omega eta/G_1)", "(5.1.17)",
                                "m/s", viscous_inputs, [](const RigData& r) {
                                    return largest_loss * r.v / viscous_ratio_of(r);
                                });

constexpr Formula loss_modulus("loss_modulus", "G''/(omega eta)",
                               "1/(1 + (omega tau)^2), tau = eta/G_2", "standard solid", "1",
                               maxwell_inputs, [](const RigData& r) {
                                   const double t = period_ratio_of(r);
                                   return 1 / (1 + t * t);
                               });

constexpr Formula loss_modulus_as_printed(
    "loss_modulus_as_printed", "G''/(omega eta), print",
    "omega tau/(1 + (omega tau)^2), from G'' = G_2 (omega tau)^2/(1 + (omega tau)^2)", "(5.1.16)",
    "1", maxwell_inputs, [](const RigData& r) {
        const double t = period_ratio_of(r);
        return t / (1 + t * t);
    });

constexpr Formula dundurs_beta(
    "dundurs_beta", "|beta|",
    "1/2 |(1 - 2 nu_2)/G_2 - (1 - 2 nu_1)/G_1|/[(1 - nu_1)/G_1 + (1 - nu_2)/G_2]", "(2.1.1)", "1",
    materials, [](const RigData& r) { return std::abs(materials_of(r).dundurs_beta()); });

constexpr Formula layer_coupling("layer_coupling", "|C_13|/sqrt(C_11 C_33)",
                                 "surface compliances of the bonded layer at the wave number 1/a",
                                 "docs/explanation/models/bem-layer.md", "1",
                                 {&Rig::b, &Rig::a, &Rig::E_2, &Rig::nu_2}, [](const RigData& r) {
                                     const auto c =
                                         theory::layer_compliance(layer_with(r), 1 / r.a);
                                     return std::abs(c.coupling) / std::sqrt(c.along * c.normal);
                                 });

Calculation coupling_effect(double coupled, double uncoupled) {
    return relative_difference(
        "coupling_effect", "|U_stat coupled/U_stat uncoupled - 1|",
        fmt::format("shift at F_T = {} mu F_N, pressed with friction", coupling_tangential_ratio),
        "boundary elements on the layer", {"U_stat coupled", {coupled}, "m"},
        {"U_stat uncoupled", {uncoupled}, "m"});
}

// The modulus for which the layer has the half-space's U_max.
double layer_modulus_of(const RigData& r) {
    const double wanted = hertz_of(r).unit_shift;
    const auto excess = [&](double log_factor) {
        RigData layer = r;
        layer.E_2 = r.E_2 * std::exp(log_factor);
        return std::log(*layer_of(layer).unit_shift / wanted);
    };
    // A layer is stiffer than its half-space, by a factor below exp(3) = 20: the bracket.
    return r.E_2 * std::exp(contact::bracketed_root(excess, -3., 0.5, 40));
}

constexpr const char* of_layer_modulus = "E_2,layer: the layer's U_max equals mu d E*/G* of E_2";
constexpr const char* layer_source = "(3.1.5), exact contact with a bonded layer";
constexpr Inputs both_inputs = hertz_inputs + Inputs{&Rig::b};

constexpr Formula layer_modulus("layer_modulus", "E_2,layer", of_layer_modulus, layer_source, "Pa",
                                both_inputs, layer_modulus_of);
constexpr Formula fitted_modulus_error("fitted_modulus_error", "E_2/E_2,layer - 1",
                                       of_layer_modulus, layer_source, "1", both_inputs,
                                       [](const RigData& r) {
                                           return r.E_2 / layer_modulus_of(r) - 1;
                                       });

// What the solver's tolerance leaves of a shift.
constexpr double least_effect = 1e-5;

/// Of |beta|, of |C_13| over the mean of C_11 and C_33, and of the effect on the static shift.
std::string coupling_sentences(double beta, double layer, std::optional<double> effect) {
    std::string text = fmt::format(
        "Two half-spaces of these materials would couple by |beta| = {}. On the bonded layer the "
        "coupling compliance |C_13| is {} of sqrt(C_11 C_33) at the wave number 1/a.",
        significant(beta, 2), percent_text(layer, 2));
    if (effect && *effect < least_effect)
        text += fmt::format(" Coupling changes the static shift by less than {}.",
                            percent_text(least_effect, 1));
    else if (effect)
        text += fmt::format(" Coupling changes the static shift by {}{}.", percent_text(*effect, 2),
                            *effect <= accepted_difference ? " only" : "");
    return text;
}

/// The criterion where the model has a shift for both; empty where it has none.
std::optional<double> effect_of_coupling(const Rig& rig, const StaticShift& static_shift,
                                         Assumption& a) {
    const bool knows_roller = rig.kind == Rig::Kind::body || roller_is_rigid(rig);
    if (!static_shift || !knows_roller) return {};
    try {
        a.criteria.push_back({coupling_effect(static_shift(rig, true), static_shift(rig, false)),
                              Criterion::Relation::at_most, accepted_difference, accepted_reason});
    } catch (const contact::NotConverged&) {
        return {};
    }
    return a.deciding_value();
}

}  // namespace

Assumption elastic_substrate(const Rig& rig) {
    if (rig.c.relaxation && rig.c.relaxation->branches.size() > 1) return relaxed_substrate(rig);
    Assumption a{.name = "elastic_substrate",
                 .title = "Elastic substrate",
                 .claim = "The substrate is elastic at the speed of the drive",
                 .background = known(rig, {&shear_modulus, &elastic_speed, &loss_modulus})};
    if (!decide(a, rig, viscous_ratio, Criterion::Relation::at_most, largest_loss,
                "bounds the loss angle of the standard solid"))
        return a;
    // G'' = omega eta/(1 + (omega tau)^2) <= omega eta, whatever G_2 is.
    a.consequence = fmt::format(
        "Viscous stresses are at most {} of the elastic ones; up to a drive speed of {} they stay "
        "below {}.",
        percent_text(a.deciding_value(), 2),
        quantity(calculate(rig, elastic_speed).result.value, "m/s", 3),
        percent_text(largest_loss, 1));
    if (is_thesis_rig(rig) && rig.G_ratio.is_known()) {
        const Calculation& print =
            a.background.emplace_back(calculate(rig, loss_modulus_as_printed));
        a.consequence += fmt::format(
            " The loss modulus as printed in (5.1.16) has a square too many: a slow dash-pot gives "
            "G'' = omega eta, the print {} of that (with G_2 = {} G_1).",
            percent_text(print.result.value, 2), significant(rig.G_ratio, 2));
    }
    return a;
}

Assumption uncoupled(const Rig& rig, const StaticShift& static_shift) {
    // The effect on the shift decides: |beta| tells of half-spaces, and only how large it may be.
    Assumption a{.name = "uncoupled",
                 .title = "Normal and tangential contact uncoupled",
                 .claim = "Normal and tangential contact do not couple",
                 .background = known(rig, {&dundurs_beta, &layer_coupling})};
    const auto effect = effect_of_coupling(rig, static_shift, a);
    if (!effect) a.missing = {"the effect of the layer's coupling on the shift"};
    a.consequence = coupling_sentences(calculate(rig, dundurs_beta).result.value,
                                       calculate(rig, layer_coupling).result.value, effect);
    return a;
}

Assumption fitted_constants(const Rig& rig) {
    Assumption a{
        .name = "fitted_constants",
        .title = "Fitted constants",
        .claim = is_thesis_rig(rig)
                     ? "E_2, fitted to static shifts by the half-space, is the rubber's"
                     : "E_2, if fitted to static shifts by the half-space, is the substrate's"};
    if (!roller_is_rigid(rig)) {
        a.missing = {theory_of_elastic_roller};
        return a;
    }
    const Calculation error = calculate(rig, fitted_modulus_error),
                      modulus = calculate(rig, layer_modulus);
    a.criteria = {{error, Criterion::Relation::at_most, accepted_difference, accepted_reason}};
    a.background = {modulus};
    a.consequence = fmt::format(
        "A half-space evaluation of static shifts would give {} for a layer of {}: {} too {}. The "
        "fitted mu stays right as long as the shift's curve over F_T/(mu F_N) keeps its shape.",
        quantity(rig.E_2, "Pa", 3), quantity(modulus.result.value, "Pa", 3),
        percent_text(std::abs(error.result.value), 2), error.result.value > 0 ? "high" : "low");
    return a;
}

}  // namespace tricontact::experiments
