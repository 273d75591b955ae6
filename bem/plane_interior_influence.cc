#include "bem/plane_interior_influence.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "bem/layer_kernel.h"
#include "bem/layer_waves.h"
#include "bem/plane_layer_influence.h"
#include "theory/layer/interior_waves.h"

namespace tricontact::bem {

namespace {

using theory::HarmonicDerivatives;
using theory::InteriorResponse;
using theory::InteriorWaves;
using theory::LayerStack;
using Amplitudes = PlaneInteriorInfluence::Amplitudes;

using std::numbers::pi;

/// Where an amplitude belongs: component of displacement or stress, direction of the load, and
/// whether it goes with cos(k s), else sin(k s).
struct Place {
    bool is_stress;
    int component, direction;
    bool even;
};
constexpr std::array<Place, PlaneInteriorInfluence::n_fields> places = {{{false, 0, 0, true},
                                                                         {false, 1, 1, true},
                                                                         {false, 2, 2, true},
                                                                         {false, 0, 2, false},
                                                                         {true, 0, 2, true},
                                                                         {true, 1, 2, true},
                                                                         {true, 2, 2, true},
                                                                         {true, 5, 2, false},
                                                                         {false, 2, 0, false},
                                                                         {true, 0, 0, false},
                                                                         {true, 1, 0, false},
                                                                         {true, 2, 0, false},
                                                                         {true, 5, 0, true},
                                                                         {true, 4, 1, true},
                                                                         {true, 3, 1, false}}};

Amplitudes amplitudes(const InteriorWaves& w) {
    const auto &p = w.pressed, &t = w.sheared;
    return {t.u_along,      w.across_u, p.u_z, p.u_along,    p.sigma_along,
            p.sigma_across, p.sigma_z,  p.tau, t.u_z,        t.sigma_along,
            t.sigma_across, t.sigma_z,  t.tau, w.across_tau, w.across_shear};
}

double& value_at(const Place& place, InteriorResponse& response) {
    return place.is_stress ? response.stress[place.component][place.direction]
                           : response.displacement[place.component][place.direction];
}

/// `factor` times what layers have more than the half-space, of the waves of `k`, per depth.
std::vector<Amplitudes> differences(const LayerStack& stack, double k, double factor,
                                    const std::vector<double>& depths) {
    const auto layers = theory::interior_waves(stack, k, depths),
               plain = theory::interior_waves(continued(stack), k, depths);
    std::vector<Amplitudes> out;
    for (std::size_t d = 0; d < depths.size(); ++d) {
        Amplitudes& of = out.emplace_back(amplitudes(layers[d]));
        const Amplitudes less = amplitudes(plain[d]);
        for (std::size_t f = 0; f < of.size(); ++f) of[f] = factor * (of[f] - less[f]);
    }
    return out;
}

/// Antiderivatives in x of the derivatives of L and M (see half_space_interior.h), integrated over
/// all y, L_z being zero at the distance `datum` and M_yy left out: 2 ln(datum/rho) and what
/// follows from it, rho^2 = x^2 + z^2.
HarmonicDerivatives edge(double x, double z, double datum) {
    using namespace theory;
    const double square = x * x + z * z, angle = std::atan2(x, z);
    const double logarithm = std::log(square / (datum * datum));
    HarmonicDerivatives e{};
    e[L_x] = 2 * x * angle - z * logarithm;
    e[L_z] = 2 * x - x * logarithm - 2 * z * angle;
    e[L_xx] = 2 * angle;
    e[L_xz] = -logarithm;
    e[L_xxx] = 2 * z / square;
    e[L_xxz] = -2 * x / square;
    e[M_xx] = -e[L_z];
    e[M_xxx] = logarithm;
    return e;
}

}  // namespace

PlaneInteriorInfluence::PlaneInteriorInfluence(const LayerStack& stack, double width,
                                               std::vector<double> depths, double reach)
    : top_(checked_in_plane_strain(stack).sheets.front().material),
      half_width_(width / 2),
      datum_(2 * stack.sheets.front().thickness),
      depths_(std::move(depths)) {
    const double hold = LayerKernel::hold(stack);
    const double farthest = std::max({reach + half_width_, hold, datum_ / 2});
    for (const auto& [k, weight] : layer_waves(stack, farthest, last_inside_wave)) {
        const double factor = weight / pi * 2 * std::sin(k * half_width_) / k;
        waves_.push_back({k, factor, differences(stack, k, factor, depths_)});
        // 2 ln(datum/rho) = 2 ∫ [cos(k x) exp(-k z) - exp(-k datum)]/k dk
        const double at_datum = weight / pi * width * std::exp(-k * datum_);
        const auto half_space = half_space_at(top_, k);
        rigid_[0] += at_datum * half_space.along;
        rigid_[1] += at_datum * half_space.across;
        rigid_[2] += at_datum * half_space.normal;
    }
    if (hold > 0) hold_at(hold, stack);
}

void PlaneInteriorInfluence::hold_at(double distance, const LayerStack& stack) {
    const InteriorResponse closed = closed_part(0, distance);
    for (const int d : {0, 1}) rigid_[d] = -closed.displacement[d][d];
    for (const StripWave& wave : waves_) {
        const auto surface = differences(stack, wave.k, wave.factor, {0}).front();
        for (const int d : {0, 1}) rigid_[d] -= surface[d] * std::cos(wave.k * distance);
    }
}

InteriorResponse PlaneInteriorInfluence::closed_part(double depth, double x) const {
    HarmonicDerivatives of = edge(x + half_width_, depth, datum_);
    const HarmonicDerivatives less = edge(x - half_width_, depth, datum_);
    for (std::size_t i = 0; i < of.size(); ++i) of[i] -= less[i];
    return theory::half_space_response(top_, depth, of);
}

InteriorResponse PlaneInteriorInfluence::at(std::size_t level, double x) const {
    InteriorResponse sum = closed_part(depths_[level], x);
    for (const StripWave& wave : waves_) {
        const double cosine = std::cos(wave.k * x), sine = std::sin(wave.k * x);
        for (std::size_t f = 0; f < n_fields; ++f)
            value_at(places[f], sum) += wave.amplitude[level][f] * (places[f].even ? cosine : sine);
    }
    for (int d = 0; d < 3; ++d) sum.displacement[d][d] += rigid_[d];
    return sum;
}

}  // namespace tricontact::bem
