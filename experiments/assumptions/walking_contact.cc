// The contact spots: their diameter and stiffness.
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "contact/number_text.h"
#include "contact/sentence.h"
#include "experiments/assumptions/walking_parts.h"

namespace tricontact::experiments {

namespace {

using contact::quantity;
using contact::Sentence;
using contact::significant;

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
    return calculate("hertz_diameter", "D_c, Hertz", "(6 F_N R_c/E*)^(1/3), F_N = m g/(2 sqrt(2))",
                     "(5.2.4)", "m", hertz_given(rig), hertz_diameter_of);
}

Criterion hertz_ratio(const WalkingRig& rig) {
    std::vector<Given> given = hertz_given(rig);
    given.push_back(diameter(rig));
    return {
        calculate("hertz_diameter_ratio", "D_c Hertz/D_c", "(6 F_N R_c/E*)^(1/3)/D_c", "(5.2.4)",
                  "1", std::move(given), [](const auto& x) { return hertz_diameter_of(x) / x[6]; }),
        Criterion::Relation::at_least, 1 / largest_factor, "estimates within a factor of two"};
}

Criterion wear_ratio(const WalkingRig& rig) {
    return {
        calculate("wear_diameter_ratio", "D_c wear/D_c", "2 sqrt(a b) of the wear spots over D_c",
                  "(5.2.5)", "1", {{"D_wear", *rig.contact.wear_diameter, "m"}, diameter(rig)},
                  [](const auto& x) { return x[0] / x[1]; }),
        Criterion::Relation::at_most, largest_factor, "estimates within a factor of two"};
}

Given time(const WalkingRig& rig) {
    return {"tau", rig.oscillation->time, "s"};
}

Calculation diameter_of_frequency(const WalkingRig& rig) {
    std::vector<Given> given = material_given(rig);
    given.push_back(mass(rig));
    given.push_back(time(rig));
    return calculate("contact_diameter", "D_c, frequency", "k_x/G*, k_x = m/tau^2",
                     "(5.2.6), (5.2.7)", "m", std::move(given), [](const auto& x) {
                         return x[4] / (x[5] * x[5]) / effective_shear_modulus_of(x);
                     });
}

Calculation stiffness_of_time(const WalkingRig& rig) {
    return calculate("contact_stiffness", "k_x", "m/tau^2", "(5.2.30)", "N/m",
                     {mass(rig), time(rig)}, [](const auto& x) { return x[0] / (x[1] * x[1]); });
}

Calculation stiffness_of_means(const WalkingRig& rig) {
    return calculate("contact_stiffness_of_means", "k_x, means", "m (Omega_exp/omega_sim)^2",
                     "(5.2.38)", "N/m",
                     {mass(rig),
                      {"Omega_exp", rig.oscillation->frequency, "Hz"},
                      {"omega_sim", rig.oscillation->simulated, "1"}},
                     [](const auto& x) { return x[0] * std::pow(x[1] / x[2], 2); });
}

Calculation characteristic_time(const WalkingRig& rig) {
    return calculate("characteristic_time", "tau, means", "omega_sim/Omega_exp", "(5.2.35)", "s",
                     {{"omega_sim", rig.oscillation->simulated, "1"},
                      {"Omega_exp", rig.oscillation->frequency, "Hz"}},
                     [](const auto& x) { return x[0] / x[1]; });
}

Calculation relative_error(const Calculation& stiffness) {
    const auto [value, error] = stiffness.result;
    return calculate("stiffness_error", "s(k_x)/k_x", "propagated through " + stiffness.formula,
                     "(A.1.4)", "1", {{"k_x", {value}, "N/m"}, {"s(k_x)", {error}, "N/m"}},
                     [](const auto& x) { return x[1] / x[0]; });
}

// k_z/k_x
Calculation stiffness_ratio(const WalkingRig& rig) {
    return calculate(
        "kappa2", "kappa_2", "k_z/k_x = E*/G*", "(5.2.29)", "1", material_given(rig),
        [](const auto& x) { return effective_modulus_of(x) / effective_shear_modulus_of(x); });
}

Calculation slenderness(const WalkingRig& rig) {
    return calculate("kappa3", "kappa_3", "a/b", "tables 4.3.1, 4.3.2", "1",
                     {{"a", half_height(rig).result, "m"}, {"b", half_width(rig).result, "m"}},
                     [](const auto& x) { return x[0] / x[1]; });
}

Calculation weight_ratio(const WalkingRig& rig) {
    return calculate("kappa4", "kappa_4", "m g/(k_x b)", "(5.2.8)", "1",
                     {mass(rig),
                      {"k_x", tangential_stiffness(rig).result, "N/m"},
                      {"b", half_width(rig).result, "m"}},
                     [](const auto& x) { return x[0] * gravity / (x[1] * x[2]); });
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
             "A round edge of {} pressed for the first time has a contact of {} diameter, {} times "
             "as stiff as one of D_c = {}.",
             quantity(s.rig.specimen.edge_radius.value, "m", 3), quantity(s.hertz, "m", 2),
             significant(s.ratio, 2), quantity(s.rig.contact.diameter.value, "m", 2));
     }},
    {[](const EdgeSubject& s) { return s.ratio < 1 / largest_factor; },
     [](const EdgeSubject& /*s*/) {
         return std::string(
             "The evaluation rests on contacts that are not fresh edges, as by wear.");
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
                               largest_relative_error, "kappa_1, kappa_4 and kappa_6 inherit it"}}};
    if (rig.oscillation)
        a.background = {characteristic_time(rig), stiffness, stiffness_of_means(rig)};
    const StiffnessSubject subject{rig, a.criteria.front().calculation.result.value};
    if (!error_is_known(subject))
        a.missing = {rig.oscillation ? "standard errors of specimen.mass and oscillation.time"
                                     : "standard errors of contact.diameter and of the materials"};
    a.consequence = told(stiffness_sentences, subject);
    return a;
}

}  // namespace tricontact::experiments
