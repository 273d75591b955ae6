#include "bem/plane_layer_influence.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "contact/base/error.h"

// Line contact: docs/explanation/cylinder.md, and docs/explanation/models/bem-layer.md for the
// layers. Under strips without end only waves across them are left, so that Hankel transforms
// become cosine and sine transforms over k. A line load on a half-space displaces as ln s, without
// a datum at infinity; on layers the rigid ground is one. What of the compliance C behaves as 1/k
// is therefore subtracted with its long waves cut off, C0 (1 - exp(-2 k b))/k, whose transforms are
// the logarithm and the arc tangent of `even_part` and `odd_part`. The rest is smooth in k and
// falls as exp(-2 k b).

namespace tricontact::bem {

namespace {

using theory::LayerStack;

// From ∫ exp(-k c) cos(k s) dk = c/(c^2 + s^2) and ∫ exp(-k c) sin(k s) dk = s/(c^2 + s^2), both
// over k > 0, by integration over c from 0: the factor (1 - exp(-k c))/k appears on the left, on
// the right the logarithm and the arc tangent below. Both are integrated over the strip once more.
/// ∫_0^inf (1 - exp(-k c)) cos(k s)/k dk = ln(1 + c^2/s^2)/2, integrated over s from 0.
double even_part(double s, double c) {
    return s == 0 ? 0 : s / 2 * std::log1p(c * c / (s * s)) + c * std::atan(s / c);
}

/// ∫_0^inf (1 - exp(-k c)) sin(k s)/k dk = atan(c/s), integrated over s; even in s.
double odd_part(double s, double c) {
    return (s == 0 ? 0 : s * std::atan(c / s)) + c / 2 * std::log(s * s + c * c);
}

using theory::HarmonicDerivatives;
using theory::InteriorResponse;
using theory::InteriorWaves;
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

Amplitudes plane_amplitudes(const InteriorWaves& w) {
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
        Amplitudes& of = out.emplace_back(plane_amplitudes(layers[d]));
        const Amplitudes less = plane_amplitudes(plain[d]);
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

const LayerStack& checked_in_plane_strain(const LayerStack& stack) {
    theory::check(stack);
    if (stack.half_space)
        throw contact::InputError(
            "bem-layer: in plane strain an elastic half-space below the layers displaces without "
            "bound; take a rigid ground (substrate.base), or a body of finite length");
    return stack;
}

}  // namespace

PlaneLayerInfluence::PlaneLayerInfluence(const LayerStack& stack,
                                         const std::optional<contact::Material>& indenter,
                                         double width_x, double width_y, double reach)
    : half_width_(width_x / 2), hold_(0), twice_thickness_(0), scale_{} {
    const auto& top = checked_in_plane_strain(stack).sheets.front();
    twice_thickness_ = 2 * top.thickness;
    if (stack.base == theory::LayerBase::frictionless)
        hold_ = LayerKernel::frictionless_hold * stack.thickness();
    scale_ = theory::half_space_compliance_at(top.material, std::numbers::pi);
    for (const Wave& wave :
         layer_waves(stack, std::max({reach + half_width_, hold_, top.thickness}))) {
        const auto c = theory::surface_compliance(stack, wave.k),
                   h = theory::half_space_compliance_at(top.material, wave.k);
        const double seen = -std::expm1(-wave.k * twice_thickness_);
        const double factor =
            wave.weight / std::numbers::pi * 2 * std::sin(wave.k * half_width_) / wave.k;
        waves_.push_back(
            {wave.k, factor * (c.normal - seen * h.normal), factor * (c.along - seen * h.along),
             factor * (c.across - seen * h.across), factor * (c.coupling - seen * h.coupling)});
    }
    if (indenter) indenter_.emplace(contact::MaterialPair{{}, *indenter}, width_x, width_y);
}

InfluenceCoefficients PlaneLayerInfluence::closed_part(double x) const {
    const double left = x - half_width_, right = x + half_width_;
    double even = even_part(right, twice_thickness_) - even_part(left, twice_thickness_);
    const double odd = odd_part(right, twice_thickness_) - odd_part(left, twice_thickness_);
    InfluenceCoefficients k{};
    k.zz = scale_.normal * even;
    if (hold_ > 0)
        even -= even_part(hold_ + half_width_, twice_thickness_) -
                even_part(hold_ - half_width_, twice_thickness_);
    k.xx = scale_.along * even;
    k.yy = scale_.across * even;
    k.xz = -scale_.coupling * odd;
    return k;
}

InfluenceCoefficients PlaneLayerInfluence::at(double x) const {
    InfluenceCoefficients sum = closed_part(x);
    for (const StripWave& wave : waves_) {
        const double cosine = std::cos(wave.k * x);
        const double held = hold_ > 0 ? cosine - std::cos(wave.k * hold_) : cosine;
        sum.zz += wave.normal * cosine;
        sum.xx += wave.along * held;
        sum.yy += wave.across * held;
        sum.xz -= wave.coupling * std::sin(wave.k * x);
    }
    if (indenter_) {
        const InfluenceCoefficients other = indenter_->at(x, 0);
        sum.zz += other.zz;
        sum.xx += other.xx;
        sum.yy += other.yy;
        sum.xz -= other.xz;  // its surface faces the other way
    }
    return sum;
}

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
        const auto half_space = theory::half_space_compliance_at(top_, k);
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
