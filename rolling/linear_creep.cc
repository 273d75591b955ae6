#include "rolling/linear_creep.h"

#include <fmt/format.h>

#include "contact/base/error.h"
#include "contact/substrates/substrate.h"
#include "rolling/steady_solver.h"
#include "rolling/stick_inverse.h"

namespace tricontact::rolling {

namespace {

using contact::operator*;
using contact::TangentialField;
using contact::Vector2;

constexpr double creep_tolerance = 1e-8;  // of the linear system, far below what the cells cost

}  // namespace

LinearCreep linear_creep(const contact::Compliance& compliance,
                         const std::vector<double>& pressure) {
    const contact::ContactPoints& points = compliance.points();
    contact::check_rolls_on("linear creep", points);
    std::vector<std::size_t> active;
    for (std::size_t i = 0; i < pressure.size(); ++i)
        if (pressure[i] > 0) active.push_back(i);
    const StickInverse stick_inverse(compliance);
    SteadySystem system(compliance, active, {false, false}, stick_inverse);
    system.set_zones(std::vector<std::uint8_t>(active.size()), std::vector<Vector2>(active.size()),
                     std::vector<double>(active.size()), 0);
    const double ahead = contact::spin_point * points.spacing[0];
    LinearCreep creep{};
    for (int c = 0; c < 3; ++c) {
        TangentialField slip(points.size());
        for (const std::size_t i : active) {
            const Vector2 by_unit[] = {{1, 0}, {0, 1}, {-points.y[i], points.x[i] + ahead}};
            slip.set(i, by_unit[c]);
        }
        const SteadySystem::Result result = system.solve(slip, {}, creep_tolerance);
        if (!(result.residual <= creep_tolerance))
            throw contact::NotConverged(
                fmt::format("linear creep: residual {:.2e} (tolerance {:.1e}) after {} iterations; "
                            "{} points in contact",
                            result.residual, creep_tolerance, result.iterations, active.size()));
        for (const std::size_t i : active) {
            const auto [f_x, f_y] = points.area[i] * result.z.at(i);
            creep[0][c] += f_x;
            creep[1][c] += f_y;
            // Rolling backwards is the adjoint: what a turn slides by there is the arm here.
            creep[2][c] += (points.x[i] - ahead) * f_y - points.y[i] * f_x;
        }
    }
    return creep;
}

}  // namespace tricontact::rolling
