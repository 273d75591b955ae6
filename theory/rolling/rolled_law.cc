#include "theory/rolling/rolled_law.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

#include "contact/base/error.h"
#include "contact/base/root.h"
#include "theory/arguments.h"
#include "theory/cattaneo_mindlin.h"
#include "theory/rolling/oscillating_rolling.h"

namespace tricontact::theory {

namespace {

constexpr double inverse_quarter_turn = 2 / std::numbers::pi;
constexpr const char* rolling = "rolling under a shear strength";

double root_beside(double x) {
    return std::sqrt((1 - x) * (1 + x));
}

double strength_force(double u) {
    return inverse_quarter_turn * (std::asin(u) + u * root_beside(u));
}

void check_strength_mapping(double kappa) {
    if (!(kappa > 0 && kappa <= strength_rolling.mdr_mapping))
        throw std::domain_error(std::string(rolling) + ": kappa must lie in (0, 4/pi]");
}

// Springs beside W carry no more than u = sqrt(1 - w^2), and arcsin sqrt(1 - w^2) = arccos w.
double strength_limit(double w, double kappa) {
    check_unit_interval(rolling, "w = W/a", w);
    check_strength_mapping(kappa);
    const double root = root_beside(w);
    return inverse_quarter_turn * (std::acos(w) + w * root) - kappa * w * root;
}

double strength_amplitude(double f, double kappa) {
    check_unit_interval(rolling, "f = F_T/F_lim", f);
    return contact::bracketed_root([=](double w) { return strength_limit(w, kappa) - f; }, 0., 1.);
}

std::optional<double> strength_shift(double w, double f, double kappa) {
    check_unit_interval(rolling, "f = F_T/F_lim", f);
    if (f > strength_limit(w, kappa)) return std::nullopt;
    const auto residual = [=](double u) { return strength_force(u) - kappa * w * u - f; };
    const double highest = root_beside(w);
    // At the limit itself rounding may leave no change of sign: the root is then the end point.
    if (residual(highest) <= 0) return highest;
    return contact::bracketed_root(residual, 0, highest);
}

}  // namespace

constinit const RolledLaw coulomb_rolling{
    .name = "Coulomb's law",
    .form = {"1", " - (1 - u_sd)^(3/2)"},
    .limit_form = "1 - k w (1 - w^2) - w^3",
    .mdr_mapping = theory::mdr_mapping,
    .mdr_text = "3/2",
    .static_force = static_force_ratio,
    .static_slope = [](double u) { return 1.5 * std::sqrt(1 - u); },
    .static_shift = static_shift_ratio,
    .bound = [](double w) { return (1 - w) * (1 + w); },
    .shakedown_limit = theory::shakedown_limit,
    .amplitude_limit = theory::amplitude_limit,
    .settled_shift_ratio = theory::settled_shift_ratio};

constinit const RolledLaw strength_rolling{
    .name = "a shear strength",
    .form = {"2/pi [arcsin u_sd + u_sd (1 - u_sd^2)^(1/2)]", ""},
    .limit_form = "2/pi [arccos w + w (1 - w^2)^(1/2)] - k w (1 - w^2)^(1/2)",
    .mdr_mapping = 2 * inverse_quarter_turn,
    .mdr_text = "4/pi",
    .static_force = strength_force,
    .static_slope = [](double u) { return 2 * inverse_quarter_turn * root_beside(u); },
    .static_shift = [](double f) { return *strength_shift(0, f, strength_rolling.mdr_mapping); },
    .bound = root_beside,
    .shakedown_limit = strength_limit,
    .amplitude_limit = strength_amplitude,
    .settled_shift_ratio = strength_shift};

const RolledLaw* rolled_law(const contact::Friction& friction) {
    if (friction.is_coulomb()) return &coulomb_rolling;
    return friction.is_strength_alone() ? &strength_rolling : nullptr;
}

const RolledLaw& require_rolled_law(const contact::Case& c, const std::string& what,
                                    const std::string& place) {
    c.refuse_extras(what, {contact::Case::Extra::relaxing_indenter});
    const RolledLaw* law = rolled_law(c.friction);
    if (!law)
        throw contact::InputError(
            fmt::format("{}: {} presume Coulomb's law, tau = mu p, or a shear strength, tau = "
                        "tau_0, and the case has tau = {}; give friction.coefficient or "
                        "friction.shear_strength alone",
                        place, what, c.friction.formula()));
    return *law;
}

bool RolledLaw::is_coulomb() const {
    return this == &coulomb_rolling;
}

double RolledLaw::mapping_parameter(double w, double f, double u) const {
    constexpr const char* here = "mapping_parameter";
    check_unit_interval(here, "w = W/a", w);
    check_unit_interval(here, "f = F_T/F_lim", f);
    check_unit_interval(here, "u = U/U_max", u);
    if (w == 0 || u == 0) throw std::domain_error("mapping_parameter: w and u must not vanish");
    return (static_force(u) - f) / (w * u);
}

}  // namespace tricontact::theory
