#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "fem/dense_compliance.h"
#include "fem/planar/contact_grid.h"

namespace tricontact::fem::planar {

/// How the contact of sections is seen in three dimensions.
struct PairOptions {
    double length = 1;  ///< along y of bodies in plane strain [m]
    /// The sections are halves: areas and forces count both. Along the surface both halves of a
    /// contact move against each other, so that the only tangential load there is a shift of zero.
    bool halves = false;
    /// Cosine of the angle at which each point is pressed, of a conforming contact: see below.
    bool conforming = false;
    double radius = 0;       ///< of a conforming contact [m]
    double local_ratio = 1;  ///< see contact::ContactPoints
};

/// See pair_compliance().
class SectionCompliance final : public DenseCompliance {
  public:
    /// `missing`: per body, the force along z that its support lacks under unit forces on the
    /// points, along the surface first, then into the substrate.
    SectionCompliance(contact::ContactPoints points, std::vector<double> matrix,
                      std::vector<std::vector<double>> missing)
        : DenseCompliance(std::move(points), std::move(matrix)), missing_(std::move(missing)) {}

    /// Of the body whose support lacks the most, along z.
    std::optional<std::array<double, 3>> missing_reaction(
        std::span<const double> p, const contact::TangentialField& t) const override;
    /// Rounding, times K/G of up to 1e6.
    double allowed_missing_reaction() const override { return 1e-7; }

  private:
    std::vector<std::vector<double>> missing_;
};

/// The compliance of all deformable bodies that touch, on the points of `grid`: A = sum M'CM over
/// both areas. Displacements are those of the substrate less those of the body that presses; rigid
/// bodies add nothing. Bodies of revolution: x is the radius; there is no row at the axis.
///
/// Of a conforming contact of radius R the body that presses approaches by d cos(theta). With
/// pressures p cos(theta), and gaps and displacements over cos(theta), the approach is the same
/// everywhere and the force that is carried the sum of pressures times areas: frictionless contact
/// is that of flat bodies. Points beyond 85 degrees are left out of it.
std::unique_ptr<SectionCompliance> pair_compliance(const std::vector<CondensedSection>& bodies,
                                                   const ContactGrid& grid,
                                                   const PairOptions& options);

}  // namespace tricontact::fem::planar
