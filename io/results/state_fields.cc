#include "io/results/state_fields.h"

#include <algorithm>
#include <array>

namespace tricontact::io {

namespace {

/// Whether the surfaces touch. Those that attract each other do where the part q = p + s of the
/// traction presses: the crack of a range 0 lies in the ring of tension around that.
bool touches(const contact::Surface& s, std::size_t i) {
    return s.tension.empty() ? s.contact_state[i] != contact::ContactState::open
                             : s.normal_traction[i] + s.tension[i] > 0;
}

/// 0 where the surface touches: what solvers leave there is their residual.
std::vector<double> told_gap(const contact::Surface& s) {
    std::vector<double> gap = s.gap;
    const std::size_t n = std::min(gap.size(), s.contact_state.size());
    const contact::ContactState* const states = s.contact_state.data();
    double* const told = gap.data();
    if (s.tension.empty())
        for (std::size_t i = 0; i < n; ++i)
            told[i] = states[i] != contact::ContactState::open ? 0 : told[i];
    else
        for (std::size_t i = 0; i < n; ++i)
            if (touches(s, i)) told[i] = 0;
    return gap;
}

/// 0 apart, 1 attracted across a gap, 2 touching.
std::vector<std::uint8_t> states_of_attraction(const contact::Surface& s) {
    std::vector<std::uint8_t> states(s.tension.size());
    for (std::size_t i = 0; i < states.size(); ++i)
        states[i] = touches(s, i) ? 2 : s.tension[i] > 0;
    return states;
}

void add_attraction(ExodusFields& out, const contact::Surface& s) {
    if (s.tension.empty()) return;
    out.add_scalar("tension_Pa", s.tension, s.size());
    out.add_scalar("separation_work_J_per_m2", s.separation_work, s.size());
    out.add_bytes("attraction_state", states_of_attraction(s), s.size());
}

/// What some layouts have beside.
void add_layout_fields(ExodusFields& out, const contact::Surface& s) {
    out.add_scalar("normal_line_load_N_per_m", s.normal_line_load, s.size());
    out.add_scalar("tangential_line_load_N_per_m", s.tangential_line_load, s.size());
    out.add_scalar("normal_traction_consistent_Pa", s.normal_traction_consistent, s.size());
    if (!s.tangential_traction_x_consistent.empty())
        out.add_vector("tangential_traction_consistent_Pa",
                       {s.tangential_traction_x_consistent, s.tangential_traction_y_consistent, {}},
                       s.size());
}

}  // namespace

void add_surface_fields(ExodusFields& out, const contact::Surface& s) {
    const std::size_t n = s.size();
    out.add_scalar("normal_traction_Pa", s.normal_traction, n);
    out.add_vector("tangential_traction_Pa", {s.tangential_traction_x, s.tangential_traction_y, {}},
                   n);
    out.add_scalar("friction_bound_Pa", s.friction_bound, n);
    // z is out of the substrate.
    out.add_vector("displacement_m", {s.displacement_x, s.displacement_y, s.displacement_z}, n, -1);
    out.add_scalar("gap_m", told_gap(s), n);
    out.add_vector("slip_m", {s.slip_x, s.slip_y, {}}, n);
    out.add_scalar("dissipation_J_per_m2", s.dissipation, n);
    out.add_scalar("slip_path_m", s.slip_path, n);
    out.add_scalar("friction_work_J_per_m2", s.friction_work, n);
    static_assert(sizeof(contact::ContactState) == 1);
    out.add_bytes(
        "contact_state",
        {reinterpret_cast<const std::uint8_t*>(s.contact_state.data()), s.contact_state.size()}, n);
    add_attraction(out, s);
    add_layout_fields(out, s);
}

/// The state that has the largest share of each element, by Simpson's weights of its nodes.
std::vector<std::uint8_t> states_of_quads(const contact::Surface& s) {
    constexpr std::array weights{1, 1, 1, 1, 4, 4, 4, 4, 16};  // over 36; VTK's order of nodes
    std::vector<std::uint8_t> states;
    for (const auto& quad : s.quads) {
        std::array<int, 3> shares{};
        for (std::size_t i = 0; i < quad.size(); ++i)
            shares.at(static_cast<std::size_t>(s.contact_state[quad[i]])) += weights[i];
        states.push_back(
            static_cast<std::uint8_t>(std::ranges::max_element(shares) - shares.begin()));
    }
    return states;
}

void add_point_fields(ExodusFields& out, const contact::Interior& interior, std::size_t n) {
    out.add_vector("displacement_m", interior.displacement, n);
    out.add_tensor("stress_Pa", interior.stress, n);
    std::vector<double> mises, pressure;
    mises.reserve(n), pressure.reserve(n);
    for (const auto& stress : interior.stress) {
        mises.push_back(contact::von_mises(stress));
        pressure.push_back(contact::mean_pressure(stress));
    }
    out.add_scalar("von_mises_Pa", mises, n);
    out.add_scalar("pressure_Pa", pressure, n);
}

}  // namespace tricontact::io
