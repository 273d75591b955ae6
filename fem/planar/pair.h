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
    double radius = 0;           ///< of a conforming contact [m]
    bool with_friction = false;  ///< of a conforming contact: see below
    double local_ratio = 1;      ///< see contact::ContactPoints
    bool is_whole_face = false;  ///< likewise
    bool first_presses = false;  ///< the first of the bodies is the one that presses
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
    /// Rounding, times K/G of up to 1e6, and more of it the finer elements are: 1.02e-7 has been
    /// seen of 60 across an attracted contact. More where one node holds a body, which gives way
    /// there by what rounding leaves of the balance.
    double allowed_missing_reaction() const override { return is_pinned_ ? 1e-6 : 3e-7; }

    /// What interior() needs of each body.
    struct Part {
        std::shared_ptr<const WholeSection> body;
        std::vector<ContactGrid::Entry> transfer;  ///< see ContactGrid
        std::size_t n_nodes;
        bool presses;
    };
    void set_parts(std::vector<Part> parts, const PairOptions& options) {
        parts_ = std::move(parts);
        options_ = options;
    }
    void set_pinned(bool is_pinned) { is_pinned_ = is_pinned; }
    /// Of all bodies, see contact/compliances/interior_parts.h: a slab of the length, or turned
    /// about the axis. Of a conforming contact both are drawn at the pin's radius.
    std::unique_ptr<const contact::Interior> interior(
        std::span<const double> p, const contact::TangentialField& t) const override;

  private:
    std::vector<std::vector<double>> missing_;
    std::vector<Part> parts_;
    PairOptions options_;
    bool is_pinned_ = false;
};

/// The compliance of all deformable bodies that touch, on the points of `grid`: A = sum M'CM over
/// both areas. Displacements are those of the substrate less those of the body that presses; rigid
/// bodies add nothing. Bodies of revolution: x is the radius; there is no row at the axis.
///
/// Of a conforming contact of radius R the body that presses approaches by d cos(theta). With
/// pressures p cos(theta), and gaps and displacements over cos(theta), the approach is the same
/// everywhere and the force that is carried the sum of pressures times areas: frictionless contact
/// is that of flat bodies. All points must lie within 90 degrees of the lowest one.
///
/// With friction what is pressed along z is q = p cos - t sin, t the traction along the arc, whose
/// sum is the force; with lengths that belong to q and t, w = u_n/cos and v = u_t + tan u_n, the
/// pin has slipped over the hole by v and a constant of the shape: where bodies touch, d cos is the
/// gap with u_n, and the d sin that it moves down beside the hole is tan times that.
std::unique_ptr<SectionCompliance> pair_compliance(const std::vector<CondensedSection>& bodies,
                                                   const ContactGrid& grid,
                                                   const PairOptions& options);

}  // namespace tricontact::fem::planar
