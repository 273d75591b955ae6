// One row of boundary elements beside the exact line contact: settled shift, traction, limit, and
// the layer in plane strain beside exact pressures and a Fourier integral.

#include "theory/oscillating_cylinder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "bem/model.h"
#include "contact/cells.h"
#include "contact/half_space_scales.h"
#include "contact/run.h"
#include "theory/layer/line_contact.h"

namespace tricontact::bem_oscillating_cylinder_test {
namespace {

using contact::Case;

constexpr double pi = std::numbers::pi;

/// A cylinder so long that (a/L)^2 does not count, loaded per length as the thesis' rig.
Case long_cylinder(double w, double f, double cells) {
    Case c;
    c.indenter.shape = Case::Shape::cylinder;
    c.indenter.radius = 40e-3;
    c.indenter.length = 2;
    c.substrate = {3.6e6, .5};
    c.friction.coefficient = .79;
    c.load.normal_force = 32.3 / 80e-3 * c.indenter.length;
    c.load.tangential_ratio = f;
    c.rolling.emplace();
    c.rolling->amplitude_ratio = w;
    c.rolling->steps = Case::Steps::turning_points;
    c.rolling->periods = 200;
    c.of<contact::Cells>().per_radius = cells;
    return c;
}

struct Exact {
    double stick, shift;  // c_sd/a, u_sd
};

Exact exact_of(const Case& c) {
    const double lambda = contact::line_shift_factor(c);
    const double w = *c.rolling->amplitude_ratio;
    const double stick = theory::line_stick_half_width(w, *c.load.tangential_ratio).value();
    return {stick, theory::line_settled_shift_ratio(w, stick, lambda)};
}

TEST(BemOscillatingCylinder, SettlesAsTheExactSolution) {
    for (const auto& [w, f] : {std::pair(.1, .5), {.26, .3}, {.26, .6}, {.52, .3}, {.77, .1}}) {
        const Case c = long_cylinder(w, f, 100);
        const auto model = bem::make_model(c, 1);
        const auto history = contact::run(c, *model);
        const Exact exact = exact_of(c);
        const auto scales = contact::half_space_scales(c);
        const double shift = history.shift_per_period.back();
        EXPECT_EQ(history.verdict.state, contact::State::shakedown);
        EXPECT_NEAR(shift / scales.unit_shift / exact.shift, 1, 1e-4) << w << ' ' << f;

        const auto surface = model->surface();
        const double unit = c.friction_coefficient() * scales.peak_pressure;
        double square = 0, n_stick = 0;
        for (int i = 0; i < surface.n_x; ++i) {
            const double x = surface.x(i) / scales.contact_radius;
            const double error = surface.tangential_traction_x[i] / unit -
                                 theory::line_shakedown_traction(x, w, exact.stick);
            square += error * error * surface.spacing[0] / scales.contact_radius;
            // What stands below its least bound of the period.
            const double least = std::sqrt(std::max(0., 1 - std::pow(std::abs(x) + w, 2)));
            n_stick +=
                std::abs(x) < 1 - w && surface.tangential_traction_x[i] / unit < .997 * least;
        }
        // Root mean square over the contact. The traction ends in roots between cells: (h/a)^(1/2)
        // on the share h/a.
        EXPECT_LT(std::sqrt(square / 2), 4e-3) << w << ' ' << f;
        const double stick = n_stick / 2 * surface.spacing[0] / scales.contact_radius;
        EXPECT_NEAR(stick, exact.stick, .02) << w << ' ' << f;  // two cells
    }
}

TEST(BemOscillatingCylinder, SettledShiftConverges) {
    std::vector<double> errors;
    for (const double cells : {12., 25., 50.}) {
        const Case c = long_cylinder(.26, .6, cells);
        const auto history = contact::run(c, *bem::make_model(c, 1));
        errors.push_back(std::abs(history.shift_per_period.back() /
                                      contact::half_space_scales(c).unit_shift / exact_of(c).shift -
                                  1));
    }
    EXPECT_LT(errors[2], 1e-4);
    EXPECT_GT(std::log2(errors[0] / errors[2]) / 2, 1);  // edges between cells: no smooth order
}

// The thesis' difference of two ellipses (3.5.24) is 0.4 % of f_T off here; elements say so.
TEST(BemOscillatingCylinder, TellsTheExactTractionFromTheEllipses) {
    const double w = .52, f = .3;
    const Case c = long_cylinder(w, f, 200);
    const auto model = bem::make_model(c, 1);
    contact::run(c, *model);
    const auto surface = model->surface();
    const double centre = surface.tangential_traction_x[surface.n_x / 2] /
                          (c.friction_coefficient() * contact::half_space_scales(c).peak_pressure);
    const double exact = theory::line_shakedown_traction(0, w, exact_of(c).stick);
    const double thesis =
        theory::thesis_line_traction(0, w, theory::thesis_line_stick_half_width(w, f).value());
    EXPECT_NEAR(centre / exact, 1, 5e-4);
    EXPECT_GT(std::abs(thesis / exact - 1), 5e-3);
}

TEST(BemOscillatingCylinder, LimitOfShakedown) {
    for (const double w : {.1, .26, .52, .77}) {
        const double limit = theory::line_shakedown_limit(w);
        for (const double share : {.98, 1.02}) {
            Case c = long_cylinder(w, share * limit, 50);
            c.rolling->periods = 80;
            const auto history = contact::run(c, *bem::make_model(c, 1));
            EXPECT_EQ(history.verdict.state,
                      share < 1 ? contact::State::shakedown : contact::State::ratcheting)
                << w << ' ' << share;
            // Cells at the edge of the overlap, b = 0.23 a for the largest w.
            EXPECT_NEAR(history.limit_tangential_ratio / limit, 1, 1e-3) << w;
        }
    }
}

/// The rig's layer, for ratios of the layer's own half width.
Case on_layer(double w, double cells) {
    Case c = long_cylinder(w, .4, cells);
    c.layer.thickness = 5e-3;
    c.contact.coupling = false;
    c.rolling->amplitude_reference = Case::AmplitudeReference::model;
    return c;
}

theory::LineContact exact_layer(const Case& c) {
    return theory::solve_line_contact(
        {c.substrate, *c.layer.thickness, theory::LayerBase::bonded}, c.indenter.radius,
        {theory::LineControl::Kind::load, *c.load.normal_force / c.indenter.length});
}

/// u_x at the centre under the pressure as a traction, (1/pi) ∫ C11 p^ dk; with p's modes
/// p^(k) = pi Σ f_m (-1)^m J_2m(k a).
double shift_under(const theory::LineContact& line, const theory::ElasticLayer& layer) {
    const double a = line.half_width, last = 400, step = .05;  // of k a; p^ falls as k^(-3/2)
    double sum = 0;
    for (double ka = step / 2; ka < last; ka += step) {
        double transform = 0, sign = 1;
        for (std::size_t m = 0; m < std::min<std::size_t>(line.edge_load_modes.size(), 12); ++m) {
            transform += pi * sign * line.edge_load_modes[m] * std::cyl_bessel_j(2. * m, ka);
            sign = -sign;
        }
        sum += theory::layer_compliance(layer, ka / a).along * transform * step / a;
    }
    return sum / pi;
}

TEST(BemOscillatingCylinder, LayerInPlaneStrain) {
    const Case c = on_layer(.26, 100);
    const auto history = contact::run(c, *bem::make_model(c, 1, bem::Body::layer));
    const auto exact = exact_layer(c);
    const contact::Scales& s = history.scales;
    // Published with the layer's description to the digits given: 2a, p0, d of the rig.
    EXPECT_NEAR(2 * s.contact_radius, 3.861e-3, 2e-6);
    EXPECT_NEAR(s.peak_pressure, .1336e6, 100);
    EXPECT_NEAR(s.indentation, .0647e-3, 1e-7);
    EXPECT_NEAR(s.contact_radius / exact.half_width, 1, 3e-4);
    EXPECT_NEAR(s.peak_pressure / exact.centre_pressure, 1, 1e-4);
    EXPECT_NEAR(s.indentation / exact.indentation, 1, 1e-4);
    EXPECT_NEAR(history.limit_tangential_ratio,
                exact.load_beyond(.26 * exact.half_width) / exact.load, 3e-4);
    const double shift = c.friction_coefficient() *
                         shift_under(exact, {c.substrate, 5e-3, theory::LayerBase::bonded});
    EXPECT_NEAR(s.unit_shift / shift, 1, 3e-4);
    EXPECT_EQ(history.verdict.state, contact::State::shakedown);
}

// As thick as the half-space is deep: only the datum of the displacements is the layer's.
TEST(BemOscillatingCylinder, ThickLayerSettlesAsTheHalfSpace) {
    Case c = long_cylinder(.26, .5, 50);
    const auto half_space = contact::run(c, *bem::make_model(c, 1));
    c.layer.thickness = 1;
    const auto layer = contact::run(c, *bem::make_model(c, 1, bem::Body::layer));
    const auto grown = [](const contact::History& h) {
        return h.shift_per_period.back() - h.static_shift;
    };
    EXPECT_NEAR(grown(layer) / grown(half_space), 1, 1e-3);
    EXPECT_NEAR(layer.limit_tangential_ratio, half_space.limit_tangential_ratio, 1e-4);
}

}  // namespace
}  // namespace tricontact::bem_oscillating_cylinder_test
