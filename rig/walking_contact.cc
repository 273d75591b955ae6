// The contact spots: their diameter and stiffness.
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "contact/number_text.h"
#include "contact/sentence.h"
#include "rig/walking_formulas.h"
#include "rig/walking_parts.h"

namespace tricontact::rig {

namespace {

using contact::quantity;
using contact::Sentence;
using contact::significant;
using contact::WalkingRig;

constexpr double largest_factor = 2;
constexpr double largest_relative_error = 0.2;

// Four contacts under planes at 45 degrees carry m g together.
double spot_force(double mass) {
    return mass * gravity / (2 * std::numbers::sqrt2);
}

std::vector<Given> hertz_given(const WalkingRig& rig) {
    std::vector<Given> given = material_given(rig);
    given.push_back(
        {"F_N",
         {spot_force(rig.specimen.mass.value), spot_force(rig.specimen.mass.standard_error)},
         "N"});
    given.push_back({"R_c", rig.specimen.edge_radius, "m"});
    return given;
}

double hertz_diameter_of(const std::vector<double>& x) {
    return std::cbrt(6 * x[4] * x[5] / effective_modulus_of(x));
}

Calculation hertz_diameter(const WalkingRig& rig) {
    return calculate({.name = "hertz_diameter",
                      .symbol = "D_c, Hertz",
                      .formula = "(6 F_N R_c/E*)^(1/3), F_N = m g/(2 sqrt(2))",
                      .source = "(5.2.4)",
                      .unit = "m",
                      .given = hertz_given(rig),
                      .function = hertz_diameter_of,
                      .result = {}});
}

Criterion hertz_ratio(const WalkingRig& rig) {
    std::vector<Given> given = hertz_given(rig);
    given.push_back(diameter(rig));
    return {calculate({.name = "hertz_diameter_ratio",
                       .symbol = "D_c Hertz/D_c",
                       .formula = "(6 F_N R_c/E*)^(1/3)/D_c",
                       .source = "(5.2.4)",
                       .unit = "1",
                       .given = std::move(given),
                       .function = [](const auto& x) { return hertz_diameter_of(x) / x[6]; },
                       .result = {}}),
            Criterion::Relation::at_least, 1 / largest_factor, "estimates within a factor of two"};
}

Criterion wear_ratio(const WalkingRig& rig) {
    return {calculate({.name = "wear_diameter_ratio",
                       .symbol = "D_c wear/D_c",
                       .formula = "2 sqrt(a b) of the wear spots over D_c",
                       .source = "(5.2.5)",
                       .unit = "1",
                       .given = {{"D_wear", *rig.contact.wear_diameter, "m"}, diameter(rig)},
                       .function = [](const auto& x) { return x[0] / x[1]; },
                       .result = {}}),
            Criterion::Relation::at_most, largest_factor, "estimates within a factor of two"};
}

Given time(const WalkingRig& rig) {
    return {"tau", rig.oscillation->time, "s"};
}

Calculation diameter_of_frequency(const WalkingRig& rig) {
    std::vector<Given> given = material_given(rig);
    given.push_back(mass(rig));
    given.push_back(time(rig));
    return calculate(
        {.name = "contact_diameter",
         .symbol = "D_c, frequency",
         .formula = "k_x/G*, k_x = m/tau^2",
         .source = "(5.2.6), (5.2.7)",
         .unit = "m",
         .given = std::move(given),
         .function =
             [](const auto& x) { return x[4] / (x[5] * x[5]) / effective_shear_modulus_of(x); },
         .result = {}});
}

Calculation stiffness_of_time(const WalkingRig& rig) {
    return calculate({.name = "contact_stiffness",
                      .symbol = "k_x",
                      .formula = "m/tau^2",
                      .source = "(5.2.30)",
                      .unit = "N/m",
                      .given = {mass(rig), time(rig)},
                      .function = [](const auto& x) { return x[0] / (x[1] * x[1]); },
                      .result = {}});
}

Calculation stiffness_of_means(const WalkingRig& rig) {
    return calculate({.name = "contact_stiffness_of_means",
                      .symbol = "k_x, means",
                      .formula = "m (Omega_exp/omega_sim)^2",
                      .source = "(5.2.38)",
                      .unit = "N/m",
                      .given = {mass(rig),
                                {"Omega_exp", rig.oscillation->frequency, "Hz"},
                                {"omega_sim", rig.oscillation->simulated, "1"}},
                      .function = [](const auto& x) { return x[0] * std::pow(x[1] / x[2], 2); },
                      .result = {}});
}

Calculation characteristic_time(const WalkingRig& rig) {
    return calculate({.name = "characteristic_time",
                      .symbol = "tau, means",
                      .formula = "omega_sim/Omega_exp",
                      .source = "(5.2.35)",
                      .unit = "s",
                      .given = {{"omega_sim", rig.oscillation->simulated, "1"},
                                {"Omega_exp", rig.oscillation->frequency, "Hz"}},
                      .function = [](const auto& x) { return x[0] / x[1]; },
                      .result = {}});
}

Calculation relative_error(const Calculation& stiffness) {
    const auto [value, error] = stiffness.result;
    return calculate({.name = "stiffness_error",
                      .symbol = "s(k_x)/k_x",
                      .formula = "propagated through " + stiffness.formula,
                      .source = "(A.1.4)",
                      .unit = "1",
                      .given = {{"k_x", {value}, "N/m"}, {"s(k_x)", {error}, "N/m"}},
                      .function = [](const auto& x) { return x[1] / x[0]; },
                      .result = {}});
}

// k_z/k_x
Calculation stiffness_ratio(const WalkingRig& rig) {
    return calculate(
        {.name = "kappa2",
         .symbol = "kappa_2",
         .formula = "k_z/k_x = E*/G*",
         .source = "(5.2.29)",
         .unit = "1",
         .given = material_given(rig),
         .function =
             [](const auto& x) { return effective_modulus_of(x) / effective_shear_modulus_of(x); },
         .result = {}});
}

Calculation slenderness(const WalkingRig& rig) {
    return calculate(
        {.name = "kappa3",
         .symbol = "kappa_3",
         .formula = "a/b",
         .source = "tables 4.3.1, 4.3.2",
         .unit = "1",
         .given = {{"a", half_height(rig).result, "m"}, {"b", half_width(rig).result, "m"}},
         .function = [](const auto& x) { return x[0] / x[1]; },
         .result = {}});
}

Calculation weight_ratio(const WalkingRig& rig) {
    return calculate({.name = "kappa4",
                      .symbol = "kappa_4",
                      .formula = "m g/(k_x b)",
                      .source = "(5.2.8)",
                      .unit = "1",
                      .given = {mass(rig),
                                {"k_x", tangential_stiffness(rig).result, "N/m"},
                                {"b", half_width(rig).result, "m"}},
                      .function = [](const auto& x) { return x[0] * gravity / (x[1] * x[2]); },
                      .result = {}});
}

std::string claim_of_diameter(const WalkingRig& rig) {
    const int ways = 1 + (rig.contact.wear_diameter ? 1 : 0) + (rig.oscillation ? 1 : 0);
    if (ways == 1) return "Hertz' formula finds the contact diameter of the evaluation";
    return fmt::format("{} ways find the same contact diameter", ways == 2 ? "Two" : "Three");
}

/// D_c of Hertz over that of the evaluation, beside the rig.
struct EdgeSubject {
    const WalkingRig& rig;
    double hertz = hertz_diameter(rig).result.value;
    double ratio = hertz_ratio(rig).calculation.result.value;
};

constexpr Sentence<EdgeSubject> edge_sentences[] = {
    {contact::always,
     [](const EdgeSubject& s) {
         return fmt::format(
             "A round edge of {} pressed for the first time has a contact of {} "
             "diameter, {} times as stiff as one of D_c = {}.",
             quantity(s.rig.specimen.edge_radius.value, "m", 3), quantity(s.hertz, "m", 2),
             significant(s.ratio, 2), quantity(s.rig.contact.diameter.value, "m", 2));
     }},
    {[](const EdgeSubject& s) { return s.ratio < 1 / largest_factor; },
     [](const EdgeSubject& /*s*/) {
         return std::string(
             "The evaluation rests on contacts that are not fresh edges, as by "
             "wear.");
     }}};

/// The contact stiffness k_x, and its relative standard error.
struct StiffnessSubject {
    const WalkingRig& rig;
    double error = 0;
};

bool error_is_known(const StiffnessSubject& s) {
    return s.error > 0;
}
bool time_has_an_error(const StiffnessSubject& s) {
    return s.rig.oscillation && s.rig.oscillation->time.standard_error > 0;
}

constexpr Sentence<StiffnessSubject> stiffness_sentences[] = {
    {error_is_known,
     [](const StiffnessSubject& s) {
         return fmt::format("The contact stiffness is uncertain by {} %.",
                            significant(100 * s.error, 2));
     }},
    {time_has_an_error, [](const StiffnessSubject& s) {
         const auto& [time, error] = s.rig.oscillation->time;
         return fmt::format("It goes with 1/tau^2, so that the {} % of tau count twice.",
                            significant(100 * error / time, 2));
     }}};

}  // namespace

Assumption contact_diameter(const WalkingRig& rig) {
    Assumption a{.name = "contact_diameter",
                 .title = "Contact diameter",
                 .claim = claim_of_diameter(rig),
                 .criteria = {hertz_ratio(rig)},
                 .background = {hertz_diameter(rig), normal_stiffness(rig),
                                tangential_stiffness(rig), stiffness_ratio(rig), half_height(rig),
                                half_width(rig), slenderness(rig), weight_ratio(rig)},
                 .missing = {},
                 .consequence = told(edge_sentences, EdgeSubject{rig})};
    if (rig.contact.wear_diameter) a.criteria.push_back(wear_ratio(rig));
    if (rig.oscillation) a.background.push_back(diameter_of_frequency(rig));
    return a;
}

Assumption known_stiffness(const WalkingRig& rig) {
    const Calculation stiffness =
        rig.oscillation ? stiffness_of_time(rig) : tangential_stiffness(rig);
    Assumption a{.name = "known_stiffness",
                 .title = "Contact stiffness",
                 .claim = "The contact stiffness is known well enough to tell kappa_1 and kappa_4",
                 .criteria = {{relative_error(stiffness), Criterion::Relation::at_most,
                               largest_relative_error, "kappa_1, kappa_4 and kappa_6 inherit it"}},
                 .background = {},
                 .missing = {},
                 .consequence = {}};
    if (rig.oscillation)
        a.background = {characteristic_time(rig), stiffness, stiffness_of_means(rig)};
    const StiffnessSubject subject{rig, a.criteria.front().calculation.result.value};
    if (!error_is_known(subject))
        a.missing = {rig.oscillation ? "standard errors of specimen.mass and oscillation.time"
                                     : "standard errors of contact.diameter and of the materials"};
    a.consequence = told(stiffness_sentences, subject);
    return a;
}

}  // namespace tricontact::rig
