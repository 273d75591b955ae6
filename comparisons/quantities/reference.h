#pragma once

#include <optional>
#include <string>

#include "contact/case.h"
#include "contact/history.h"

namespace tricontact::comparisons {

/// True when F_N (or d) and F_T stay constant while rolling: what all closed forms assume.
bool constant_loads(const contact::Case& c);

/// 0 <= ratio <= 1: where the closed forms are defined.
bool in_unit_range(double ratio);

/// f_T = F_T/(mu F_N) of a history after loading; 0 without friction.
double tangential_ratio(const contact::History& history);
/// w = W/a over the model's own contact radius.
double amplitude_ratio(const contact::History& history);

/// What theory says of a case's body on the half-space: frictionless contact, static shift, and the
/// exact solution of the method of dimensionality reduction (MDR) for oscillating rolling, see
/// theory/rolling/body_rolling.h; of a line contact Hertz, Cattaneo and the exact solution of
/// theory/oscillating_cylinder.h. Ratios are dimensionless.
struct Reference {
    contact::HalfSpaceScales hertz{};
    bool is_nominal = false;        ///< `hertz` are scales of a nominally flat contact, no solution
    double tangential_ratio = 0;    ///< f_T
    double amplitude_ratio = 0;     ///< w over the Hertz radius
    double static_shift_ratio = 0;  ///< u_stat; 0 if f_T is out of range or nobody knows
    std::optional<double> peak_pressure;  ///< [Pa], where the pressure is largest at the centre
    bool has_mapping = false;             ///< kappa (3.2.16) is defined: paraboloid and sphere
    /// Below: with rolling at constant loads and w <= 1 only.
    std::optional<double> limit_tangential_ratio;  ///< f_T,lim of the body's pressure
    std::optional<double> limit_amplitude_ratio;   ///< w_lim at this f_T
    std::optional<double> shakedown_shift_ratio;   ///< u_sd, below the limit only
    std::optional<double> stick_ratio;             ///< c_sd/a of a line contact, likewise
};
Reference reference(const contact::Case& c);

/// What contact::HalfSpaceScales::peak_pressure is of the case's body: the peak, the pressure at
/// the centre, or the mean.
const char* pressure_name(const contact::Case& c);

/// "contact radius", or "half width" of a line contact.
std::string size_name(const contact::Case& c);

}  // namespace tricontact::comparisons
