#pragma once

#include <string>
#include <vector>

namespace tricontact::contact {

/// How the coefficient of friction falls with the speed v at which a point slips, from mu at rest:
///   mu_s(v) = mu - sum_k d_k (1 - f_k(v)),
/// f = max(0, 1 - v/(2 v_k)), 1/(1 + v/v_1) and 1/(1 + (v/v_2)^2), or 2^(-v/v_k): each is 1 at
/// rest, 1/2 at its v_k. Polach (2005); Vollebregt and Schuttelaars (2012), J. Sound Vib. 331.
///
/// With a memory mu follows mu_s over a way that it slides,
///   dmu/dt = max(v, v_0)/d_c (mu_s(v) - mu).
struct FrictionRate {
    enum class Law { linear, rational, exponential };

    Law law = Law::exponential;
    std::vector<double> drops;   ///< d_k [-], one or two
    std::vector<double> speeds;  ///< v_k [m/s], one each
    double memory_length = 0;    ///< d_c [m]; 0: mu is mu_s
    double memory_speed = 0;     ///< v_0 [m/s], by which mu heals where nothing slips

    /// mu_s(v) of mu at rest [-].
    double coefficient(double at_rest, double speed) const;
    /// At an infinite v.
    double least(double at_rest) const;
    /// What of the old mu is left after `time` [s] at v, by one implicit step of it.
    double memory(double time, double speed) const;
    /// For people: "falling by 0.12 p (half of it at 0.1 m/s), exponentially".
    std::string fall() const;
};

}  // namespace tricontact::contact
