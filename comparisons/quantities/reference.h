#pragma once

#include <cmath>
#include <optional>
#include <string>

#include "contact/case.h"
#include "contact/history.h"

namespace tricontact::theory {
struct RolledLaw;
}

namespace tricontact::comparisons {

/// True when F_N (or d) and F_T stay constant while rolling: what all closed forms assume.
bool constant_loads(const contact::Case& c);

/// 0 <= ratio <= 1: where the closed forms are defined.
bool in_unit_range(double ratio);

/// f_T = F_T/(mu F_N) of a history after loading; 0 without friction.
double tangential_ratio(const contact::History& history);
/// The same of a case's load, friction holding this contact; NaN of a fraction of a limit, and of a
/// force under another law than Coulomb's whose `bound` in all is not known (NaN).
double tangential_ratio(const contact::Case& c, const contact::FrictionLaw::Total& contact);
/// Whether that is more than what rounding leaves of no force.
inline bool is_loaded(double tangential_ratio) {
    return std::abs(tangential_ratio) >= 1e-9;
}
/// w = W/a over the model's own contact radius.
double amplitude_ratio(const contact::History& history);

/// What theory says of a case's body on the half-space: frictionless contact, static shift, and the
/// exact solution of the method of dimensionality reduction (MDR) for oscillating rolling, see
/// theory/rolling/body_rolling.h; of a line contact Hertz, Cattaneo and the exact solution of
/// theory/oscillating_cylinder.h. Ratios are dimensionless.
struct Reference {
    contact::HalfSpaceScales hertz{};
    /// Of surfaces that attract each other AdhesiveForms instead; where there are none, nominal
    /// scales, as of a flat or conforming contact, and no solution.
    bool is_nominal = false;
    double tangential_ratio = 0;          ///< f_T; NaN: a fraction of a limit that theory has not
    double amplitude_ratio = 0;           ///< w over the radius of `hertz`
    double static_shift_ratio = 0;        ///< u_stat; 0 if f_T is out of range or it is unavailable
    bool static_shift_is_relaxed = true;  ///< see there
    std::optional<double> peak_pressure;  ///< [Pa], where the pressure is largest at the centre
    std::optional<double> mdr_mapping;    ///< kappa of MDR; empty where kappa is undefined
    /// Below: with rolling at constant loads and w <= 1 only.
    std::optional<double> limit_tangential_ratio;  ///< f_T,lim of the body's pressure
    std::optional<double> limit_amplitude_ratio;   ///< w_lim at this f_T
    std::optional<double> shakedown_shift_ratio;   ///< u_sd, below the limit only
    std::optional<double> stick_ratio;  ///< c_sd/a of a line contact, likewise; c/a without rolling
};
Reference reference(const contact::Case& c);

/// What contact::HalfSpaceScales::peak_pressure is of the case's body: the peak, the pressure at
/// the centre, or the mean.
const char* pressure_name(const contact::Case& c);

/// "contact radius", or "half width" of a line contact.
std::string size_name(const contact::Case& c);

/// kappa carries the error of f_T divided by w u; below this product only noise is left of it.
inline constexpr double least_mapping_product = 1e-5;

/// The law of friction by which the case's rolled body has a kappa: of smooth paraboloids and
/// spheres on rigid interfaces, see theory::RolledLaw. Null for others.
const theory::RolledLaw* mapped_law(const contact::Case& c);

/// Mapping parameter kappa of f = f_static(u) - kappa w u (Wetter (2016), 3.2.16, of Coulomb's
/// law). Empty unless 0 <= w, f, u <= 1 and w u > least_mapping_product.
std::optional<double> mapping_parameter(const theory::RolledLaw& law, double w, double f, double u);

/// Ratcheting slope eta = Du/(w - w_lim) (Wetter (2016), 3.3.1); empty unless w > w_lim.
std::optional<double> ratcheting_slope(double increment_ratio, double w, double w_lim);

/// MDR and BEM: models that do not see the thickness.
bool is_half_space(const std::string& model);

/// Whether the half-spaces of the case's materials couple normal and tangential contact.
bool half_spaces_couple(const contact::Case& c);

/// Whether the model's elasticity is that of a file of influence coefficients: what the case says
/// of the bodies decides neither coupling nor thickness.
bool is_tabulated(const contact::Case& c, const std::string& model);

/// Whether the model couples normal and tangential contact in this case, or may: MDR's springs
/// never do, bem does by Dundurs' beta, or as its file of influence coefficients says.
bool couples(const contact::Case& c, const std::string& model);

/// Whether the model solves what the closed forms of uncoupled, elastic half-spaces are about.
bool is_uncoupled_half_space(const contact::Case& c, const std::string& model);

/// Whether the static shift is that of elastic bodies: always, unless the substrate relaxes. Then
/// the hold time under F_T has to outlast its slowest branch, e^-7 = 1e-3 being left.
bool static_shift_is_relaxed(const contact::Case& c);

/// What the closed form of the static shift is called: "Cattaneo and Mindlin".
std::string static_theory(const contact::Case& c);

}  // namespace tricontact::comparisons
