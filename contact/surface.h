#pragma once

#include <cstdint>
#include <vector>

#include "contact/vector2.h"

namespace tricontact::contact {

enum class ContactState : std::uint8_t { open = 0, stick = 1, slip = 2 };

/// State of the contact surface at one instant: fields per contact point, x fastest on a grid.
struct Surface {
    /// `grid`: n_x * n_y cells of the substrate's surface. `line`: the springs of an MDR bed along
    /// x (n_y = 1); tractions are then back-transformed to three dimensions, p(|x|) and tau(|x|)
    /// about the indenter's position, tau from the part of the line load even in x.
    enum class Layout { grid, line };
    Layout layout = Layout::grid;
    int n_x = 0, n_y = 0;
    Vector2 first{};    ///< position of the first point [m]
    Vector2 spacing{};  ///< [m]
    Vector2 offset{};   ///< position of the indenter [m]

    std::vector<double> normal_traction;  ///< p [Pa], compression positive
    std::vector<double> tangential_traction_x, tangential_traction_y;  ///< on the substrate [Pa]
    std::vector<double> friction_bound;                                ///< mu p [Pa]
    std::vector<double> displacement_x, displacement_y;                ///< of the surface [m]
    std::vector<double> displacement_z;                                ///< into the substrate [m]
    std::vector<double> gap;                                           ///< [m]
    std::vector<double> slip_x, slip_y;  ///< indenter over substrate, in the last step [m]
    std::vector<double> dissipation;     ///< of the last step [J/m^2]
    std::vector<ContactState> contact_state;
    std::vector<double> normal_line_load, tangential_line_load;  ///< line layout only [N/m]

    std::size_t size() const { return static_cast<std::size_t>(n_x) * n_y; }
    double x(int i) const { return first[0] + i * spacing[0]; }
    double y(int j) const { return first[1] + j * spacing[1]; }
};

}  // namespace tricontact::contact
