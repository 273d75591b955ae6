#pragma once

#include <vector>

#include "contact/bodies/indenter.h"
#include "contact/case.h"
#include "contact/solvers/compliance.h"

namespace tricontact::contact {

/// Where the indenter is relative to the substrate, and how far the surface has moved.
struct IndenterPose {
    Vector2 offset{};                     ///< of the rolling [m]
    Vector2 shift{};                      ///< rigid tangential shift U [m]
    const TangentialField& displacement;  ///< in the surface [m]
};

/// What normal contact sees of the friction and tangential contact of the pressure. Two ways:
/// the compliance's coupling blocks; and with kinematics "deformed" the displaced surface, which
/// meets the indenter elsewhere and inclined. To the first order in the slope g of the indenter at
/// the displaced point, pressure p and friction t act on the substrate as p - t.g downwards and
/// t + p g in the surface.
class Coupling {
  public:
    Coupling(const Compliance& compliance, const Indenter& indenter, const Case::Contact& options);

    /// There is none: the two problems may be solved one after the other.
    bool is_decoupled() const { return !elastic_ && !deformed_; }
    /// Slopes play a part: forces balance to the tolerance of the staggered iteration only.
    bool deformed() const { return deformed_; }
    /// Takes heights and slopes from the displaced surface; cheap, before the next four.
    void place(const IndenterPose& pose);

    /// Height of the indenter over the points [m] plus what all but p itself moves them down.
    void update_height(std::span<const double> p, const TangentialField& t);
    const std::vector<double>& height() const { return height_; }
    const std::vector<double>& bare_height() const { return bare_height_; }  ///< the first part [m]
    /// The second part [m].
    const std::vector<double>& lowering() const { return lowering_; }
    /// Displacement in the surface by all but t itself [m].
    void update_displacement(std::span<const double> p, const TangentialField& t);
    const TangentialField& displacement() const { return displacement_; }

    /// Parts of the vertical and the tangential force that t and p carry [N].
    double normal_force(const TangentialField& t) const;
    Vector2 tangential_force(std::span<const double> p) const;
    /// What p could carry in the surface at most: its parts added up by their magnitudes [N].
    double inclined_force(std::span<const double> p) const;

    /// Tractions on the substrate in all: in the surface and downwards [Pa].
    TangentialField surface_traction(std::span<const double> p, const TangentialField& t) const;
    std::vector<double> downward_traction(std::span<const double> p,
                                          const TangentialField& t) const;

  private:
    const Compliance* compliance_;
    const Indenter* indenter_;
    bool elastic_, deformed_;
    std::vector<double> bare_height_, lowering_, height_;
    TangentialField slope_, displacement_;
};

}  // namespace tricontact::contact
