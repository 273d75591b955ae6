#include "rolling/rolling_contact.h"

#include <algorithm>

namespace tricontact::rolling {

namespace {

/// Half lengths of the contact by cells [m].
contact::Vector2 half_extent(const contact::Surface& s) {
    std::vector<int> per_row(s.n_y), per_column(s.n_x);
    for (int j = 0; j < s.n_y; ++j)
        for (int i = 0; i < s.n_x; ++i)
            if (s.normal_traction[static_cast<std::size_t>(j) * s.n_x + i] > 0) {
                ++per_row[j];
                ++per_column[i];
            }
    return {*std::ranges::max_element(per_row) * s.spacing[0] / 2,
            *std::ranges::max_element(per_column) * s.spacing[1] / 2};
}

}  // namespace

RollingState state_of(const contact::Surface& s, const contact::Indenter& indenter) {
    const double area = s.spacing[0] * s.spacing[1];
    const contact::Vector2 centre = indenter.lowest_point();
    RollingState state;
    double moment = 0;
    for (std::size_t i = 0; i < s.size(); ++i) {
        const double x = s.x(static_cast<int>(i) % s.n_x) - s.offset[0];
        const double y = s.y(static_cast<int>(i) / s.n_x) - s.offset[1];
        const double p = s.normal_traction[i];
        const double t_x = s.tangential_traction_x[i], t_y = s.tangential_traction_y[i];
        state.normal_force += area * p;
        state.friction_bound += area * s.friction_bound[i];
        state.force[0] += area * t_x;
        state.force[1] += area * t_y;
        state.spin_moment += area * ((x - centre[0]) * t_y - (y - centre[1]) * t_x);
        state.dissipation += area * s.dissipation[i];
        moment += area * p * x;
        if (p > 0) state.resistance += area * p * indenter.slope(x, y)[0];
        state.peak_pressure = std::max(state.peak_pressure, p);
        if (s.contact_state[i] == contact::ContactState::stick) state.stick_area += area;
        if (s.contact_state[i] == contact::ContactState::slip) state.slip_area += area;
    }
    state.contact_area = state.stick_area + state.slip_area;
    state.pressure_lead = moment / state.normal_force;
    const contact::Vector2 half = half_extent(s);
    state.half_length = half[0];
    state.half_width = half[1];
    return state;
}

}  // namespace tricontact::rolling
