#pragma once

#include <optional>

namespace tricontact::contact {

/// An interface that is elastic itself: springs in series with both bodies at each point, as of a
/// layer of roughness or a third body, or those of a penalty. Pressure p and traction t displace
/// the surfaces by p/k_n and t/k_t more; gap and slip are those of the springs' far ends.
struct Interface {
    std::optional<double> normal_stiffness;      ///< k_n [Pa/m], else rigid
    std::optional<double> tangential_stiffness;  ///< k_t [Pa/m], else rigid

    bool is_elastic() const { return normal_stiffness || tangential_stiffness; }
    double normal_compliance() const { return normal_stiffness ? 1 / *normal_stiffness : 0; }
    double tangential_compliance() const {
        return tangential_stiffness ? 1 / *tangential_stiffness : 0;
    }
};

}  // namespace tricontact::contact
