#include "io/results/state_fields.h"

#include <algorithm>
#include <array>

namespace tricontact::io {

namespace {

/// Whether the surfaces touch at a point. Those that attract each other do where the part q = p + s
/// of the traction presses: the crack of a range 0 lies in the ring of tension around that.
class Touch {
  public:
    explicit Touch(const contact::SurfaceView& s)
        : state_(s.contact_state.data()),
          traction_(s.normal_traction.data()),
          tension_(s.tension.empty() ? nullptr : s.tension.data()) {}
    bool operator()(std::size_t i) const {
        return tension_ == nullptr ? state_[i] != contact::ContactState::open
                                   : traction_[i] + tension_[i] > 0;
    }

  private:
    const contact::ContactState* state_;
    const double *traction_, *tension_;
};

/// 0 where the surface touches: what solvers leave there is their residual.
std::vector<double> told_gap(const contact::SurfaceView& s) {
    std::vector<double> gap(s.gap.begin(), s.gap.end());
    const std::size_t n = std::min(gap.size(), s.contact_state.size());
    const Touch touches(s);
    double* const told = gap.data();
    for (std::size_t i = 0; i < n; ++i) told[i] = touches(i) ? 0 : told[i];
    return gap;
}

/// 0 apart, 1 attracted across a gap, 2 touching.
std::vector<std::uint8_t> states_of_attraction(const contact::SurfaceView& s) {
    std::vector<std::uint8_t> states(s.tension.size());
    const Touch touches(s);
    for (std::size_t i = 0; i < states.size(); ++i) states[i] = touches(i) ? 2 : s.tension[i] > 0;
    return states;
}

void add_attraction(ExodusFields& out, const contact::SurfaceView& s) {
    if (s.tension.empty()) return;
    out.add_scalar("tension_Pa", s.tension, s.n_values());
    out.add_scalar("separation_work_J_per_m2", s.separation_work, s.n_values());
    out.add_bytes("attraction_state", states_of_attraction(s), s.n_values());
}

/// What some layouts have beside.
void add_layout_fields(ExodusFields& out, const contact::SurfaceView& s) {
    out.add_scalar("normal_line_load_N_per_m", s.normal_line_load, s.n_values());
    out.add_scalar("tangential_line_load_N_per_m", s.tangential_line_load, s.n_values());
    out.add_scalar("normal_traction_consistent_Pa", s.normal_traction_consistent, s.n_values());
    if (!s.tangential_traction_x_consistent.empty())
        out.add_vector("tangential_traction_consistent_Pa",
                       {s.tangential_traction_x_consistent, s.tangential_traction_y_consistent, {}},
                       s.n_values());
}

}  // namespace

void add_surface_fields(ExodusFields& out, const contact::SurfaceView& s) {
    const std::size_t n = s.n_values();
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
std::vector<std::uint8_t> states_of_quads(const contact::SurfaceView& s) {
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
