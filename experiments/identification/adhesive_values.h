#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "experiments/identification/identification_reader.h"
#include "experiments/identification/measured_values.h"
#include "theory/adhesive/adhesive_curve.h"
#include "theory/adhesive/adhesive_hysteresis.h"
#include "theory/adhesive/disc_table.h"

namespace tricontact::experiments {

/// What a rig's adhesive contacts are made of: closed forms of the half-space, on a layer a table
/// of the exact theory.
class RigDiscs {
  public:
    /// `step`: see theory::DiscTable. Throws contact::InputError for a layer that the exact theory
    /// does not cover.
    RigDiscs(const contact::Case& rig, bool on_layer, double step = usual_step);

    /// Of a rig that differs in E and w, and under a paraboloid in R and b; the branch of
    /// separation, or that of the approach.
    theory::AdhesiveCurve curve(const contact::Case& rig, bool approaches = false) const;
    theory::AdhesiveHysteresis hysteresis(const contact::Case& rig) const;

    static constexpr double usual_step = .05;

  private:
    std::shared_ptr<theory::DiscTable> table_;  // of a layer
};

/// Forces [N] of a table's rows by their depths, radii [m] or forces of full sliding [N] by their
/// forces, on the stable branch of Johnson, Kendall and Roberts' curve. What slides carries tau_0
/// over the area that attraction and force hold together, which sliding is taken not to peel: the
/// table's own rows by their ways, others as those pulled off. In contact, what lies below the end
/// of the branch is as at its end, so that a search comes back from there. Where the approach gains
/// less than separation takes, rows up to the deepest are those of its branch, and those after it
/// come from there, the edge being held until it opens.
std::vector<double> adhesive_values(const IdentificationInput::Table& table,
                                    const IdentifiedRig& rig, const std::vector<double>& given,
                                    const RigDiscs& discs);

/// dF/dd [N/m] at the rows of a table of depths.
std::vector<double> adhesive_slopes(const IdentificationInput::Table& table,
                                    const IdentifiedRig& rig, const RigDiscs& discs);

}  // namespace tricontact::experiments
