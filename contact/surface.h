#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "contact/base/vector2.h"

namespace tricontact::contact {

enum class ContactState : std::uint8_t { open = 0, stick = 1, slip = 2 };

/// State of the contact surface at one instant: fields per contact point, x fastest on a grid.
struct Surface {
    /// `grid`: n_x * n_y cells of the substrate's surface. `line`: the springs of an MDR bed along
    /// x (n_y = 1); tractions are then back-transformed to three dimensions, p(|x|) and tau(|x|)
    /// about the indenter's position, tau from the part of the line load even in x.
    /// `nodes`: nodes of an element surface, joined by `quads`; if they form a regular grid, n_x to
    /// spacing describe it, else n_x = n_y = 0 and only `node_x`, `node_y` tell the positions.
    enum class Layout { grid, line, nodes };
    Layout layout = Layout::grid;
    int n_x = 0, n_y = 0;
    Vector2 first{};                        ///< position of the first point [m]
    Vector2 spacing{};                      ///< [m]
    std::vector<double> node_x, node_y;     ///< nodes layout only [m]
    std::vector<std::array<int, 9>> quads;  ///< nodes layout only, see ContactPoints
    Vector2 offset{};                       ///< position of the indenter [m]

    std::vector<double> normal_traction;  ///< p [Pa], compression positive
    /// Of surfaces that attract each other on cells or elements, else empty: the tension s >= 0 that
    /// p contains [Pa], and its work from the touch to the present gap, 0 to w [J/m^2].
    std::vector<double> tension, separation_work;
    std::vector<double> tangential_traction_x, tangential_traction_y;  ///< on the substrate [Pa]
    std::vector<double> friction_bound;                                ///< see FrictionLaw [Pa]
    std::vector<double> displacement_x, displacement_y;                ///< of the surface [m]
    std::vector<double> displacement_z;                                ///< into the substrate [m]
    std::vector<double> gap;                                           ///< [m]
    std::vector<double> slip_x, slip_y;  ///< indenter over substrate, in the last step [m]
    std::vector<double> dissipation;     ///< of the last step [J/m^2]
    /// Since the period began: sum of |slip| [m] and of the frictional work [J/m^2]. Empty outside
    /// of rolling and where the model does not know them.
    std::vector<double> slip_path, friction_work;
    std::vector<ContactState> contact_state;
    /// By the consistent mass of the elements instead of row sums; nodes layout only.
    std::vector<double> normal_traction_consistent;
    std::vector<double> tangential_traction_x_consistent, tangential_traction_y_consistent;
    std::vector<double> normal_line_load, tangential_line_load;  ///< line layout only [N/m]

    std::size_t size() const {
        return layout == Layout::nodes ? node_x.size() : static_cast<std::size_t>(n_x) * n_y;
    }
    double x(int i) const { return first[0] + i * spacing[0]; }
    double y(int j) const { return first[1] + j * spacing[1]; }
};

/// Slip of a point, as results tell it: 0 where it does not slip. What solvers leave there is their
/// residual, of any direction.
inline Vector2 told_slip(ContactState state, const Vector2& slip) {
    return state == ContactState::slip ? slip : Vector2{};
}

/// Frictional work of a step at a point [J/m^2]: never negative, as where it slips, by more than
/// ten times the solver's residual, traction and slip have one direction.
inline double frictional_work(ContactState state, const Vector2& traction, const Vector2& slip) {
    return dot(traction, told_slip(state, slip));
}

}  // namespace tricontact::contact
