#include "theory/first_yield.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "contact/compliances/interior.h"
#include "theory/half_space_interior.h"

namespace tricontact::theory {

namespace {

using Stress = std::array<double, 6>;
using StressAt = std::function<Stress(double x, double z)>;

/// Of a stress field in half widths: a grid of columns from -reach to reach, finer near the
/// surface, then steps that are halved around its largest value. `surface`: least depth.
StressPeak peak_of(const StressAt& stress, double surface, int n_x, int n_z) {
    constexpr double reach = 1.5, deepest = 1.5, accuracy = 1e-5;
    StressPeak peak;
    const auto look_at = [&](double x, double z) {
        const double here = contact::von_mises(stress(x, z));
        if (here <= peak.von_mises) return false;
        peak = {here, x, z};
        return true;
    };
    for (int i = 0; i <= n_x; ++i)
        for (int k = 0; k <= n_z; ++k) {
            const double share = static_cast<double>(k) / n_z;
            look_at(reach * (2. * i / n_x - 1), surface + (deepest - surface) * share * share);
        }
    double step_x = 2 * reach / n_x, step_z = deepest / n_z;
    while (step_x > accuracy) {
        const double x = peak.x, z = peak.depth;
        bool moved = false;
        for (const double dx : {-step_x, 0., step_x})
            for (const double dz : {-step_z, 0., step_z})
                moved = look_at(x + dx, std::max(surface, z + dz)) || moved;
        if (moved) continue;
        step_x /= 2;
        step_z /= 2;
    }
    return peak;
}

}  // namespace

StressPeak line_stress_peak(const BulkStressLine& line, const contact::Material& material) {
    const double a = line.half_width;
    StressPeak peak = peak_of(
        [&](double x, double z) { return line.stress(material, a * x, a * z); }, 0, 120, 40);
    // Far below the contact only the bulk is left.
    const double nu = material.poisson, bulk = std::abs(line.bulk_stress);
    peak.von_mises = std::max(peak.von_mises, bulk * std::sqrt(1 - nu + nu * nu));
    peak.x *= a;
    peak.depth *= a;
    return peak;
}

StressPeak sphere_stress_peak(const contact::Material& material, double contact_radius,
                              double peak_pressure, double friction, double force_ratio,
                              double bulk_stress, double stick_centre) {
    const double bulk = bulk_stress / peak_pressure, moved = stick_centre / contact_radius;
    const double stick = std::cbrt(std::max(0., 1 - std::abs(force_ratio)));
    const double shear = (force_ratio < 0 ? -1 : 1) * friction;
    // q(t) of Hertz' pressure of peak 1 on the radius a: pi (a^2 - t^2)/(2 a).
    const auto response = [&](double radius, double x, double z) {
        return axisymmetric_interior(
            material,
            [radius](double t) {
                return std::numbers::pi * (radius * radius - t * t) / (2 * radius);
            },
            radius, x, 0, z);
    };
    const bool sheared = friction > 0 && force_ratio != 0;
    const auto stress = [&](double x, double z) {
        const InteriorResponse whole = response(1, x, z);
        const InteriorResponse stuck =
            sheared && stick > 0 ? response(stick, x - moved, z) : InteriorResponse{};
        Stress sum{};
        for (std::size_t k = 0; k < sum.size(); ++k) {
            sum[k] = whole.stress[k][2];
            if (sheared) sum[k] += shear * (whole.stress[k][0] - stick * stuck.stress[k][0]);
        }
        sum[0] += bulk;
        return sum;
    };
    StressPeak peak = peak_of(stress, sphere_surface, sheared || bulk != 0 ? 30 : 2, 16);
    // At the edge, x = -+1: Hamilton (1983), eqs. of the surface; what sticks is smooth there.
    const double nu = material.poisson, radial = (1 - 2 * nu) / 3;
    for (const double x : {-1., 1.}) {
        const double pulled = -x * std::numbers::pi / 8 * shear;
        Stress edge{radial + (4 + nu) * pulled, -radial + 3 * nu * pulled, 0, 0, 0, 0};
        if (!sheared) edge = {radial, -radial, 0, 0, 0, 0};
        if (sheared && stick > 0 && stick < 1) {
            const InteriorResponse stuck = response(stick, x - moved, sphere_surface);
            for (std::size_t k = 0; k < 3; ++k) edge[k] -= shear * stick * stuck.stress[k][0];
        }
        edge[0] += bulk;
        if (contact::von_mises(edge) > peak.von_mises)
            peak = {contact::von_mises(edge), x, sphere_surface};
    }
    peak.von_mises = std::max(peak.von_mises * peak_pressure, std::abs(bulk_stress));
    peak.x *= contact_radius;
    peak.depth = peak.depth > sphere_surface ? peak.depth * contact_radius : 0;
    return peak;
}

namespace {

/// Least value of a convex function between two arguments.
template <class Function>
double least(const Function& f, double low, double high) {
    constexpr double golden = 1 / std::numbers::phi, accuracy = 1e-6;
    double left = high - golden * (high - low), right = low + golden * (high - low);
    double at_left = f(left), at_right = f(right);
    while (high - low > accuracy) {
        if (at_left < at_right) {
            high = std::exchange(right, left);
            at_right = at_left;
            left = high - golden * (high - low);
            at_left = f(left);
        } else {
            low = std::exchange(left, right);
            at_left = at_right;
            right = low + golden * (high - low);
            at_right = f(right);
        }
    }
    return std::min(at_left, at_right);
}

/// At one depth: the least over the residual stresses along and across of the largest J2 of a pass,
/// as k/p0; J2 is a sum of squares of what is linear in these, and convex.
double shakedown_strength(const BulkStressLine& line, double poisson, double z) {
    constexpr int n_x = 240;
    constexpr double reach = 4;
    struct Passed {
        double half, shear, across;  // (XX - ZZ)/2, XZ, 2 YY - XX - ZZ
    };
    std::vector<Passed> passed;
    for (int i = 0; i <= n_x; ++i) {
        // Denser towards the middle.
        const double s = 2. * i / n_x - 1;
        const Stress at = line.stress({1, poisson}, reach * s * std::abs(s), z);
        passed.push_back({(at[0] - at[2]) / 2, at[5], 2 * at[1] - at[0] - at[2]});
    }
    const auto largest = [&](double along, double across) {
        double most = 0;
        for (const Passed& one : passed) {
            const double half = one.half + along, rest = one.across + across;
            most = std::max(most, half * half + one.shear * one.shear + rest * rest / 12);
        }
        return most;
    };
    return std::sqrt(least(
        [&](double along) {
            return least([&](double across) { return largest(along, across); }, -4, 4);
        },
        -1 - line.friction, 1 + line.friction));
}

}  // namespace

double line_shakedown_pressure(double friction, double poisson) {
    const BulkStressLine sliding{
        .half_width = 1, .peak_pressure = 1, .friction = friction, .force_ratio = 1};
    constexpr int n_z = 30;
    double needed = 0, place = 0, step = 1.2 / n_z;
    const auto look_at = [&](double z) {
        const double here = shakedown_strength(sliding, poisson, z);
        if (here <= needed) return false;
        needed = here;
        place = z;
        return true;
    };
    for (int k = 0; k <= n_z; ++k) look_at(step * k);
    while (step > 1e-4) {
        const double z = place;
        if (!look_at(z + step) && !look_at(std::max(0., z - step))) step /= 2;
    }
    return 1 / needed;
}

}  // namespace tricontact::theory
