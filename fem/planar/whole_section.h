#pragma once

#include <span>
#include <vector>

#include "contact/compliances/interior.h"
#include "fem/condensation.h"
#include "fem/planar/section_unknowns.h"

namespace tricontact::fem::planar {

/// All of a body that was condensed, for its inside.
class WholeSection {
  public:
    /// `even_load`: forces of its pressure on all unknowns, one in all, of Support::even.
    WholeSection(BodyProblem problem, SectionSurface surface, SectionUnknowns unknowns,
                 Condensation condensation, std::vector<double> even_load);

    /// The body under `forces` on the nodes of its contact surface in their frames, along the
    /// surface of all first, then into the substrate [N], of plane strain per length [N/m]; all of
    /// them and what they do times `sign`. A section in plane strain is drawn as a slab of the
    /// length [m] along y, and counts `copies` times; one of revolution is turned about its axis.
    contact::Interior interior(std::span<const double> forces, double sign, double length,
                               double copies) const;

  private:
    std::vector<Point> displacement(std::span<const double> forces) const;

    BodyProblem problem_;
    SectionSurface surface_;
    SectionUnknowns unknowns_;
    Condensation condensation_;
    std::vector<double> even_load_;
};

}  // namespace tricontact::fem::planar
