// Bounds that rise with the slip of a step, from none to infinitely steep: the conditions that
// define the one solution, by Newton's method and by gradients.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "contact/base/error.h"
#include "contact/solvers/projected_gradient.h"
#include "contact/solvers/tangential_solver.h"
#include "tests/unit/contact/dense_compliance.h"

namespace tricontact::contact::hardening_test {
namespace {

using contact_test::DenseCompliance;
using Kind = TangentialControl::Kind;
using Controls = std::array<TangentialControl, 2>;

constexpr int n_points = 60;
constexpr double tolerance = 1e-10, contact_compliance = 5;

/// Surfaces that carry what a pressure gives them, and a layer that has flowed before here and
/// there.
struct Layer {
    DenseCompliance compliance;
    std::vector<double> surfaces, at_start;
    TangentialField previous{n_points};
    double carried = 0, started = 0;  // in all [N]

    explicit Layer(unsigned seed) : compliance(n_points, seed) {
        const auto& points = compliance.points();
        for (int i = 0; i < n_points; ++i) {
            const double r2 = points.x[i] * points.x[i] + points.y[i] * points.y[i];
            surfaces.push_back(r2 < 1 ? .6 * std::sqrt(1 - r2) : 0);
            at_start.push_back(std::min(surfaces[i], .2 + .1 * std::sin(5. * i)));
            previous.x[i] = .1 * std::sin(7. * i);
            previous.y[i] = .1 * std::cos(3. * i);
            carried += points.area[i] * surfaces[i];
            started += points.area[i] * at_start[i];
        }
    }
    TangentialProblem problem(const Controls& control, const Hardening& hardening) const {
        TangentialProblem problem{surfaces, previous, control, contact_compliance};
        problem.hardening = &hardening;
        return problem;
    }
    TangentialSolution solve(const Controls& control, double slope) const {
        TangentialSolution solution;
        const Hardening hardening{at_start, slope};
        TangentialSolver(compliance, tolerance).solve(problem(control, hardening), solution);
        return solution;
    }
};

Controls forces(double x, double y) {
    return {{{Kind::force, x}, {Kind::force, y}}};
}
Controls shifts(double x, double y) {
    return {{{Kind::shift, x}, {Kind::shift, y}}};
}

/// Points that stick, flow and slip.
std::array<int, 3> expect_law(const Layer& layer, const Controls& control, double slope,
                              const TangentialSolution& s, double allowed) {
    std::array<int, 3> zones{};
    TangentialField u(n_points);
    layer.compliance.tangential(s.traction, u);
    const double length = contact_compliance + norm(s.shift_increment);
    Vector2 force{};
    for (int i = 0; i < n_points; ++i) {
        const Vector2 t = s.traction.at(i);
        const double size = norm(t), area = layer.compliance.points().area[i];
        force = force + area * t;
        EXPECT_LE(size, layer.surfaces[i] * (1 + 1e-14)) << i;
        if (layer.surfaces[i] == 0) continue;
        const Vector2 slip = s.shift_increment + layer.previous.at(i) - u.at(i);
        const double along = dot(slip, t) / size;
        EXPECT_NEAR((slip[0] * t[1] - slip[1] * t[0]) / size, 0, allowed * length) << i;
        const double least = std::max(0., size - layer.at_start[i]) / slope;
        if (size >= layer.surfaces[i] * (1 - 1e-9)) {
            EXPECT_GE(along, least - allowed * length) << i;
            ++zones[2];
        } else {
            EXPECT_NEAR((along - least) / (1 + 1 / (slope * contact_compliance)), 0,
                        allowed * length)
                << i;
            ++zones[size > layer.at_start[i] * (1 + 1e-9)];
        }
    }
    for (int d = 0; d < 2; ++d) {
        if (control[d].kind != Kind::force) continue;
        EXPECT_NEAR(force[d], control[d].value, 1e-9 * layer.carried);
    }
    return zones;
}

TEST(Hardening, AnySlopeIsSolved) {
    for (const unsigned seed : {1u, 2u, 3u}) {
        const Layer layer(seed);
        for (const auto& control :
             {forces(.8 * layer.started, .2 * layer.started), forces(0, -.9 * layer.carried),
              shifts(.3, .1), shifts(3, -2), shifts(0, 0)}) {
            for (const double slope : {1e-14, 1e-8, 1e-3, .1, 1., 10., 1e3, 1e8, 1e20}) {
                const auto s = layer.solve(control, slope);
                expect_law(layer, control, slope, s, 3e-10);
                // Coulomb's law: 40. Gradients need thousands; bounds that follow the slip in a
                // fixed-point iteration diverge from a slope of 1 on.
                EXPECT_LE(s.iterations, 300) << slope;
            }
        }
    }
}

TEST(Hardening, AllZonesOccur) {
    const Layer layer(4);
    const auto zones = expect_law(layer, shifts(.5, 0), .3, layer.solve(shifts(.5, 0), .3), 3e-10);
    for (const int n : zones) EXPECT_GT(n, 2);
}

// No slope: the bound at the start; an infinite one: nothing flows.
TEST(Hardening, LimitsAreCoulombs) {
    const Layer layer(5);
    const std::vector<double> surfaces = layer.surfaces;
    for (const auto& control :
         {forces(.5 * layer.started, -.4 * layer.started), shifts(.4, .2), shifts(.02, 0)})
        for (const bool steep : {false, true}) {
            const auto s = layer.solve(control, steep ? 1e12 : 1e-12);
            TangentialSolution limit;
            TangentialSolver(layer.compliance, tolerance)
                .solve({steep ? layer.surfaces : layer.at_start, layer.previous, control,
                        contact_compliance},
                       limit);
            for (int i = 0; i < n_points; ++i) {
                EXPECT_NEAR(s.traction.x[i], limit.traction.x[i], 1e-8) << i;
                EXPECT_NEAR(s.traction.y[i], limit.traction.y[i], 1e-8) << i;
            }
        }
}

TEST(Hardening, GradientsFindTheSame) {
    const Layer layer(6);
    std::vector<std::size_t> active;
    for (int i = 0; i < n_points; ++i)
        if (layer.surfaces[i] > 0) active.push_back(i);
    for (const double slope : {.1, 1.})
        for (const auto& control : {forces(.7 * layer.carried, 0), shifts(.4, .2)}) {
            TangentialSolution s;
            s.traction = TangentialField(n_points);
            const Hardening hardening{layer.at_start, slope};
            projected_gradient(layer.compliance, active,
                               *make_active_operator(layer.compliance, active),
                               layer.problem(control, hardening), 4000, s);
            expect_law(layer, control, slope, s, 1e-7);  // linear convergence
        }
}

TEST(Hardening, ForcesUpToWhatTheSurfacesCarry) {
    const Layer layer(7);
    EXPECT_NO_THROW(layer.solve(forces(.999 * layer.carried, 0), 1.));
    EXPECT_THROW(layer.solve(forces(1.001 * layer.carried, 0), 1.), InputError);
}

TEST(FrictionDisc, PotentialIsTheIntegralOfItsRadius) {
    constexpr double alpha = 2;
    for (const FrictionDisc& disc :
         {FrictionDisc{.3, .3, 0}, FrictionDisc{.3, 1, .7}, FrictionDisc{0, 1, 5}}) {
        double sum = 0;
        constexpr int n = 4000;
        for (int k = 0; k < n; ++k) {
            const double size = 4. * (k + .5) / n;
            sum += disc.radius(size, alpha) * 4 / n;
            EXPECT_NEAR(disc.potential(4. * (k + 1) / n, alpha), sum, 1e-6);
        }
    }
}

}  // namespace
}  // namespace tricontact::contact::hardening_test
