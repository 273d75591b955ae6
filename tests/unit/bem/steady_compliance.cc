// What a steady compliance displaces, beside the substrate that rolls on below standing tractions.

#include "bem/steady_compliance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "bem/grid_compliance.h"
#include "bem/model.h"
#include "bem/settings.h"
#include "bem/steady_model.h"
#include "contact/cells.h"
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
    c.relaxation = {{{1, relaxation_time}, {.3, .1 * relaxation_time}},
                    contact::Relaxation::Bulk::elastic};
    c.indenter.radius = radius;
    c.friction.coefficient = .35;
    c.load.normal_force = 4. / 3 * 3e6 / .91 * std::pow(half_length, 3) / radius;
    c.tractive_rolling.emplace();
    c.tractive_rolling->speed = way * half_length / relaxation_time;
    c.of<contact::Cells>().per_radius = 3;
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

/// The grid that rolls on sees 16 half lengths ahead, and rolls over 30.
double difference_from_rolling_on(const Case& c, bem::Body body) {
    const auto rolled = bem::make_substrate(c, 1, body, 8);
    const ContactPoints on_rolled = rolled->relaxed().points();
    const int n_cells = static_cast<int>(30 * *c.of<contact::Cells>().per_radius);
    const SurfaceField u = settled(*rolled, c.tractive_rolling->speed, n_cells);
    const auto steady = bem::steady_compliance(c, 1, body);
    return difference(u, on_rolled, displaced(*steady, load_on(steady->points())),
                      steady->points());
}

// Where a part relaxes both take tractions for linear along the way: what is left is what the grid
// that rolls on does not see ahead, and what 20 ways have not yet forgotten.
constexpr double not_forgotten = 1e-4;

TEST(SteadyCompliance, IsWhereRollingOnEnds) {
    for (const double way : {.01, .5}) {
        EXPECT_LT(difference_from_rolling_on(relaxing(way), bem::Body::half_space), not_forgotten);
        EXPECT_LT(difference_from_rolling_on(cylinder(way), bem::Body::half_space), not_forgotten);
    }
}

TEST(SteadyComplianceSlow, IsWhereRollingOnALayerEnds) {
    Case layer = relaxing(.5);
    layer.layer.thickness = 1.3 * half_length;
    layer.layer.base = Case::Base::half_space;
    layer.layer.ground = {9e6, .2};
    layer.indenter.material = {5e6, .4};
    EXPECT_LT(difference_from_rolling_on(layer, bem::Body::layer), not_forgotten);
    Case line = cylinder(.5);
    line.layer.thickness = 1.3 * half_length;
    for (const auto base : {Case::Base::bonded, Case::Base::frictionless}) {
        line.layer.base = base;
        EXPECT_LT(difference_from_rolling_on(line, bem::Body::layer), not_forgotten);
    }
}

// Where all relaxes as one its substrate takes displacements for linear: second order in the cell.
TEST(SteadyCompliance, OfOneRelaxationIsWhereRollingOnEndsToTheSecondOrder) {
    std::vector<double> error;
    for (const double cells : {3., 7., 12.}) {
        Case c = cylinder(.5);
        c.relaxation->bulk = contact::Relaxation::Bulk::proportional;
        c.of<contact::Cells>().per_radius = cells;
        error.push_back(difference_from_rolling_on(c, bem::Body::half_space));
    }
    EXPECT_LT(error[2], 5e-4);
    EXPECT_NEAR(std::log(error[0] / error[2]) / std::log(12. / 3), 2, .4);
    EXPECT_LT(error[1], error[0]);
}

// Slow: relaxed; fast: as stiff as at once, but for one part in the way over the contact, and its
// inverse.
TEST(SteadyCompliance, SlowOrFastItIsElastic) {
    Case c = relaxing(1);
    c.relaxation = {{{2, relaxation_time}}};
    const auto at = [&](double way) {
        c.tractive_rolling->speed = way * half_length / relaxation_time;
        return bem::steady_compliance(c, 1, bem::Body::half_space);
    };
    const auto middle = at(1);
    const SurfaceField t = load_on(middle->points());
    const auto elastic = bem::half_space_compliance({{}, c.substrate}, middle->points(), 1);
    SurfaceField u = displaced(*elastic, t);
    EXPECT_LT(difference(u, middle->points(), displaced(*at(1e-5), t), middle->points()), 1e-4);
    for (auto* field : components(u))
        for (double& value : *field) value /= 3;
    EXPECT_LT(difference(u, middle->points(), displaced(*at(1e6), t), middle->points()), 1e-4);
    EXPECT_GT(difference(u, middle->points(), displaced(*middle, t), middle->points()), .1);
}

// t' du/dx <= 0: no load takes energy out of what flows below it.
TEST(SteadyCompliance, NoTractionsTakeEnergyOutOfTheMaterial) {
    const auto steady = bem::steady_compliance(relaxing(.5), 1, bem::Body::half_space);
    const ContactPoints& points = steady->points();
    for (int sample = 0; sample < 20; ++sample) {
        SurfaceField t = load_on(points);
        for (auto* field : components(t))
            for (std::size_t i = 0; i < points.size(); ++i)
                (*field)[i] *= std::sin(1.7 * (sample + 1) * static_cast<double>(i));
        const SurfaceField u = displaced(*steady, t);
        double work = 0;
        for (int d = 0; d < 3; ++d)
            for (std::size_t i = 1; i + 1 < points.size(); ++i)
                work += (*components(t)[d])[i] *
                        ((*components(u)[d])[i - 1] - (*components(u)[d])[i + 1]);
        EXPECT_GT(work, 0) << sample;
    }
}

TEST(SteadyCompliance, OfAFileOrAPeriodIsNotKnown) {
    Case c = relaxing(1);
    c.of<bem::Settings>().influence = "coefficients.dat";
    EXPECT_EQ(bem::steady_compliance(c, 1, bem::Body::half_space), nullptr);
    c.of<bem::Settings>().influence.reset();
    c.period = 1;
    EXPECT_EQ(bem::steady_compliance(c, 1, bem::Body::layer), nullptr);
}

}  // namespace
}  // namespace tricontact::steady_compliance_test
