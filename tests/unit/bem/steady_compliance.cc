// What a steady compliance displaces, beside the substrate that rolls on below standing tractions.

#include "bem/steady_compliance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "bem/model.h"
#include "bem/steady_model.h"
#include "contact/substrates/substrate.h"

namespace tricontact::steady_compliance_test {
namespace {

using contact::Case;
using contact::ContactPoints;
using contact::Material;
using contact::SurfaceField;

constexpr double radius = .07, half_length = 4e-3, relaxation_time = .3;

/// A body on relaxing rubber, which it rolls over in `way` half lengths a relaxation time. The bulk
/// is elastic: a part relaxes, whose substrate takes the same steps as the steady compliance.
Case relaxing(double way) {
    Case c;
    c.substrate = {3e6, .3};
    c.relaxation = {{{2, relaxation_time}, {.7, .1 * relaxation_time}},
                    contact::Relaxation::Bulk::elastic};
    c.indenter.radius = radius;
    c.friction_coefficient = .35;
    c.load.normal_force = 4. / 3 * 3e6 / .91 * std::pow(half_length, 3) / radius;
    c.tractive_rolling.emplace();
    c.tractive_rolling->speed = way * half_length / relaxation_time;
    c.bem.cells_per_radius = 3;
    return c;
}

/// A cylinder, in one row of cells that are long.
Case cylinder(double way) {
    Case c = relaxing(way);
    c.indenter.shape = Case::Shape::cylinder;
    c.indenter.length = 400 * half_length;
    c.load.normal_force = *c.load.normal_force / half_length * 3. / 16 * 3.1416 * c.indenter.length;
    return c;
}

/// Cells around the centre carry tractions, 0 elsewhere.
SurfaceField load_on(const ContactPoints& points) {
    SurfaceField t(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double x = points.x[i] / half_length, y = points.y[i] / half_length;
        if (x * x + (points.n_y > 1 ? y * y : 0) > .5) continue;
        t.down[i] = 1 + x;
        t.in_surface.set(i, {1 - .7 * x + y, .3 + y - x * x});
    }
    return t;
}

SurfaceField displaced(const contact::Compliance& compliance, const SurfaceField& t) {
    SurfaceField u(t.down.size()), other(t.down.size());
    compliance.normal(t.down, u.down);
    compliance.tangential(t.in_surface, u.in_surface);
    compliance.tangential_from_normal(t.down, other.in_surface);
    compliance.normal_from_tangential(t.in_surface, other.down);
    for (int d = 0; d < 3; ++d)
        for (std::size_t i = 0; i < t.down.size(); ++i)
            (*components(u)[d])[i] += (*components(other)[d])[i];
    return u;
}

/// After the substrate has rolled on below the same tractions for `n_cells`.
SurfaceField settled(contact::Substrate& substrate, double speed, int n_cells) {
    const ContactPoints& points = substrate.relaxed().points();
    const SurfaceField t = load_on(points);
    SurfaceField traction(points.size()), u(points.size());
    for (int step = 0; step <= n_cells; ++step) {
        contact::advect(points, traction);
        contact::advect(points, u);
        substrate.advect();
        substrate.begin(points.spacing[0] / speed, traction, u);
        traction = t;
        u = displaced(substrate.compliance(), t);
        for (int d = 0; d < 3; ++d)
            for (std::size_t i = 0; i < points.size(); ++i) {
                double& value = (*components(u)[d])[i];
                value = (value - (*components(substrate.offset())[d])[i]) / substrate.stiffness();
            }
        substrate.end(t, u);
    }
    return u;
}

/// Largest difference of displacements within a half length of the centre, over the largest there.
double difference(const SurfaceField& one, const ContactPoints& on_one, const SurfaceField& other,
                  const ContactPoints& on_other) {
    double worst = 0, largest = 0;
    const int aside_x = (on_one.n_x - on_other.n_x) / 2, aside_y = (on_one.n_y - on_other.n_y) / 2;
    for (int j = 0; j < on_other.n_y; ++j)
        for (int i = 0; i < on_other.n_x; ++i) {
            const std::size_t k = static_cast<std::size_t>(j) * on_other.n_x + i,
                              l = static_cast<std::size_t>(j + aside_y) * on_one.n_x + i + aside_x;
            EXPECT_NEAR(on_one.x[l], on_other.x[k], 1e-9 * half_length);
            for (int d = 0; d < 3; ++d) {
                const double u = (*components(one)[d])[l];
                worst = std::max(worst, std::abs(u - (*components(other)[d])[k]));
                largest = std::max(largest, std::abs(u));
            }
        }
    return worst / largest;
}

/// The grid that rolls on reaches `ahead` further half lengths ahead.
double difference_from_rolling_on(const Case& c, bem::Body body, double ahead, int n_cells) {
    const auto rolled = bem::make_substrate(c, 1, body, ahead);
    const ContactPoints on_rolled = rolled->relaxed().points();
    const SurfaceField u = settled(*rolled, c.tractive_rolling->speed, n_cells);
    const auto steady = bem::steady_compliance(c, 1, body);
    return difference(u, on_rolled, displaced(*steady, load_on(steady->points())),
                      steady->points());
}

TEST(SteadyCompliance, IsWhereRollingOnEnds) {
    for (const double way : {.01, .3, 1.}) {
        std::printf("half %g %g\n", way, difference_from_rolling_on(relaxing(way), bem::Body::half_space, 20, 120));
        std::printf("half %g %g\n", way, difference_from_rolling_on(cylinder(way), bem::Body::half_space, 20, 120));
    }
        std::printf("half line %g %g\n", 20., difference_from_rolling_on(cylinder(20), bem::Body::half_space, 200, 1200));
        std::printf("half line %g %g\n", 20., difference_from_rolling_on(cylinder(20), bem::Body::half_space, 400, 2400));
    Case layer = relaxing(1);
    layer.layer.thickness = 1.3 * half_length;
    std::printf("layer %g\n", difference_from_rolling_on(layer, bem::Body::layer, 20, 120));
    layer.layer.base = Case::Base::frictionless;
    std::printf("glides %g\n", difference_from_rolling_on(layer, bem::Body::layer, 20, 120));
    layer.layer.base = Case::Base::half_space;
    layer.layer.ground = {9e6, .2};
    std::printf("ground %g\n", difference_from_rolling_on(layer, bem::Body::layer, 20, 120));
    std::printf("ground %g\n", difference_from_rolling_on(layer, bem::Body::layer, 40, 120));
    layer.indenter.material = {5e6, .4};
    std::printf("ground, indenter %g\n", difference_from_rolling_on(layer, bem::Body::layer, 20, 120));
    layer = cylinder(1);
    layer.layer.thickness = 1.3 * half_length;
    std::printf("layer line %g\n", difference_from_rolling_on(layer, bem::Body::layer, 20, 120));
    layer.indenter.material = {5e6, .4};
    std::printf("layer line indenter %g\n", difference_from_rolling_on(layer, bem::Body::layer, 20, 120));
    layer = relaxing(1);
    layer.relaxation->bulk = contact::Relaxation::Bulk::proportional;
    std::printf("as one %g\n", difference_from_rolling_on(layer, bem::Body::half_space, 20, 120));
    layer.bem.cells_per_radius = 6;
    std::printf("as one %g\n", difference_from_rolling_on(layer, bem::Body::half_space, 20, 240));
    layer.bem.cells_per_radius = 12;
    std::printf("as one %g\n", difference_from_rolling_on(layer, bem::Body::half_space, 20, 480));
}

}  // namespace
}  // namespace tricontact::steady_compliance_test
