#include "rolling/temperatures.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace tricontact::rolling {

namespace {

/// Points of a row from its first one in contact to its last; empty: begin = end.
struct TouchedPart {
    int begin = 0, end = 0;
};

TouchedPart touched_part(const contact::Surface& s, int row) {
    const double* const pressure =
        s.normal_traction.data() + static_cast<std::ptrdiff_t>(row) * s.n_x;
    TouchedPart part;
    for (int i = 0; i < s.n_x; ++i) {
        if (!(pressure[i] > 0)) continue;
        if (part.end == 0) part.begin = i;
        part.end = i + 1;
    }
    return part;
}

/// What is left of the touching temperature `cells` of them behind the leading edge of a contact
/// that was as long as `length`; Carslaw and Jaeger (1959), section 2.5: the flux of a surface at
/// constant temperature, switched off.
double left_behind(double length, double cells) {
    return 2 / std::numbers::pi * std::asin(std::sqrt(length / cells));
}

}  // namespace

std::vector<double> friction_heating(const contact::Surface& s, const contact::ContactHeat& heat,
                                     double speed) {
    // int (s - x)^(-1/2) ds over a cell that lies so many ahead, in units of h^(1/2).
    std::vector<double> of_cell(s.n_x);
    for (int k = 0; k < s.n_x; ++k)
        of_cell[k] = 2 * (std::sqrt(k + .5) - (k > 0 ? std::sqrt(k - .5) : 0));
    const double unit = std::sqrt(s.spacing[0] / (std::numbers::pi * speed)) /
                        (heat.indenter.effusivity() + heat.substrate.effusivity());
    std::vector<double> rise(s.size());
    for (int row = 0; row < s.n_y; ++row) {
        const std::size_t first = static_cast<std::size_t>(row) * s.n_x;
        const TouchedPart part = touched_part(s, row);
        for (int j = part.begin; j < part.end; ++j) {
            const double flux = s.dissipation[first + j] * speed;  // [W/m^2]
            if (flux == 0) continue;
            for (int i = 0; i <= j; ++i) rise[first + i] += unit * flux * of_cell[j - i];
        }
    }
    return rise;
}

SurfaceTemperatures surface_temperatures(const contact::Surface& s,
                                         const contact::ContactHeat& heat, double speed) {
    const std::vector<double> rise = friction_heating(s, heat, speed);
    const double touching = heat.touching_temperature();
    const auto of_body = [&](double bulk) {
        std::vector<double> all(s.size());
        for (int row = 0; row < s.n_y; ++row) {
            const TouchedPart part = touched_part(s, row);
            for (int i = 0; i < s.n_x; ++i) {
                const double share = part.end == 0 || i >= part.end ? 0
                                     : i >= part.begin
                                         ? 1
                                         : left_behind(part.end - part.begin, part.end - i - .5);
                const std::size_t k = static_cast<std::size_t>(row) * s.n_x + i;
                all[k] = std::lerp(bulk, touching, share) + rise[k];
            }
        }
        return all;
    };
    SurfaceTemperatures found{of_body(heat.indenter.temperature),
                              of_body(heat.substrate.temperature)};
    found.friction_rise = rise;
    return found;
}

HighestTemperature highest_temperature(const contact::Surface& s,
                                       const SurfaceTemperatures& temperatures) {
    HighestTemperature highest{-std::numeric_limits<double>::infinity(), 0};
    for (std::size_t i = 0; i < s.size(); ++i) {
        if (!(s.normal_traction[i] > 0)) continue;
        highest.value = std::max(highest.value, temperatures.substrate[i]);
        highest.friction_rise = std::max(highest.friction_rise, temperatures.friction_rise[i]);
    }
    return highest;
}

}  // namespace tricontact::rolling
