#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "contact/bodies/indenter.h"
#include "contact/wearing_contact.h"
#include "mdr/worn_rings.h"

namespace tricontact::mdr {

struct WornKernels;

/// What a wearing body of revolution under Coulomb's law is made of.
struct WearingBedData {
    std::shared_ptr<const contact::AxisymmetricIndenter> indenter;
    double effective_modulus = 0, effective_shear_modulus = 0;  ///< E*, G* [Pa]
    double friction = 0;                                        ///< mu [-]
    int rings_per_radius = 0;                                   ///< in the contact radius at first
};

/// Wear of a body of revolution by the method of dimensionality reduction (Dimaki, Dmitriev, Chai
/// and Popov 2014): pressure and slip of the springs are transformed to the radii r, where the
/// profile f(r) wears, and the worn profile back to the one g(x) that presses the springs.
///   f(r) = 2/pi ∫_0^r g(x)/sqrt(r^2 - x^2) dx,   q(x) = E* (d - g(x)),
///   p(r) = -1/pi ∫_r^a q'(x)/sqrt(x^2 - r^2) dx,
///   s(r) = 2/pi ∫_0^r s_1(x)/sqrt(r^2 - x^2) dx, s_1 = 4 (U_A - mu q/G*) where that is positive,
/// s and s_1 the slip paths of a cycle between the shifts +-U_A about its middle.
///
/// Nodes are equidistant in rho = sqrt(r^2 - c^2), in which all kernels are those of c = 0. Under a
/// prescribed depth and shift the stick radius c never changes, and the limit profile, with its
/// vertical slope at c, is smooth in rho; of a paraboloid its image is exact at the nodes. Under
/// forces c is 0 and the edge of the stick zone lies between nodes. Further points are within c,
/// which does not wear.
class WearingBed final : public WornRings {
  public:
    /// Throws contact::InputError unless the normal control stays the same in the cycle.
    WearingBed(WearingBedData data, contact::WearProblem problem);

    contact::WornCycle cycle(const std::vector<double>& worn) override;
    std::vector<double> jump(const std::vector<double>& worn, const contact::WornCycle& now,
                             double n) override;
    void enlarge(const contact::ContactAtEdge& reached) override;

  private:
    /// The normal contact of a worn profile.
    struct Pressed {
        double depth = 0, force = 0, radius = 0;  ///< d [m], F_N [N], a [m]
        std::vector<double> line_load;            ///< q of the nodes [N/m]
    };

    void make_nodes(double reach);
    double force_at(double depth, const std::vector<double>& profile, Pressed* found) const;
    Pressed press(const std::vector<double>& profile) const;
    double tangential_force(const Pressed& pressed, double shift) const;
    double shift_amplitude(const Pressed& pressed) const;
    std::vector<double> plane_profile(const std::vector<double>& worn) const;
    std::vector<double> pressures(const Pressed& pressed) const;
    double stick_radius(const Pressed& pressed, double amplitude) const;

    WearingBedData data_;
    double drive_ = 0;                 // half of what shift or force covers [m], [N]
    double radius_0_ = 0;              // of the contact at first [m]
    double stick_ = 0;                 // c of the nodes [m]
    double reach_ = 0;                 // of the nodes along r [m]
    double spacing_ = 0;               // of the nodes in rho [m]
    std::size_t n_inner_ = 0, n_ = 0;  // points within c, nodes
    std::vector<double> unworn_;       // g of the nodes [m]
    std::shared_ptr<const WornKernels> kernels_;
};

}  // namespace tricontact::mdr
