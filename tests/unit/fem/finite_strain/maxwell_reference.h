#pragma once

#include <algorithm>
#include <boost/numeric/odeint.hpp>
#include <functional>

#include "contact/substrates/relaxation.h"
#include "tests/unit/fem/finite_strain/strained_block.h"

namespace tricontact::test {

/// The continuous law of Reese and Govindjee, integrated in the multiplicative split itself: in the
/// intermediate configuration without spin,
///   F_i' = D_i F_i,   D_i = dev(C_e)/(2 tau),   C_e = F_e' F_e,   F_e = F_bar F_i^-1.
struct MaxwellReference {
    std::function<Tensor(double)> motion;  ///< F, of the volume 1
    contact::Relaxation relaxation;        ///< one branch
    double shear_modulus, c01_ratio;       ///< relaxed [Pa]; c01/(c10 + c01)

    struct Result {
        Tensor stress;      ///< deviatoric [Pa]
        double dissipated;  ///< [J/m^3]
    };
    /// From rest until `end` [s], to 1e-11.
    Result integrate(double end) const {
        namespace odeint = boost::numeric::odeint;
        using State = std::array<double, 10>;  // F_i, dissipated
        const auto [ratio, time] = relaxation.branches.at(0);
        const double c10 = shear_modulus / 2 * (1 - c01_ratio);
        const double c01 = shear_modulus / 2 * c01_ratio;
        const auto tensor = [](auto& state) {
            return Eigen::Map<std::conditional_t<
                std::is_const_v<std::remove_reference_t<decltype(state)>>, const Tensor, Tensor>>(
                state.data());
        };
        const auto rates = [&, ratio = ratio, time = time](const State& x, State& dx, double t) {
            const Tensor f_e = motion(t) * tensor(x).inverse();
            const Tensor flow = dev(f_e.transpose() * f_e) / (2 * time);
            tensor(dx) = flow * tensor(x);
            // Mandel stress : D_i.
            dx[9] = ratio * mooney_rivlin(f_e.transpose() * f_e, c10, c01).cwiseProduct(flow).sum();
        };
        State x{};
        tensor(x) = Tensor::Identity();
        const auto stepper =
            odeint::make_controlled(1e-11, 1e-11, odeint::runge_kutta_fehlberg78<State>());
        // The rate of strain may jump within: pieces, and short steps after it.
        constexpr int pieces = 14;
        for (int k = 0; k < pieces; ++k)
            odeint::integrate_adaptive(stepper, rates, x, end * k / pieces, end * (k + 1) / pieces,
                                       1e-3 * end);
        const Tensor f = motion(end), f_e = f * tensor(x).inverse();
        return {mooney_rivlin(f * f.transpose(), c10, c01) +
                    ratio * mooney_rivlin(f_e * f_e.transpose(), c10, c01),
                x[9]};
    }
};

}  // namespace tricontact::test
