#pragma once

#include <vector>

#include "contact/compliances/compliance.h"
#include "contact/compliances/steady_compliance.h"
#include "contact/history.h"
#include "contact/substrates/substrate.h"
#include "contact/surface_model.h"
#include "rolling/rolling_contact.h"

namespace tricontact::rolling {

/// Rolling from rest in the frame that moves with the contact, a cell of the grid at a time: each
/// step is the frictional contact of contact::SurfaceModel, whose fields were carried along before.
class TransientRolling {
  public:
    /// Throws contact::InputError for points that form no grid.
    TransientRolling(const contact::Substrate& substrate, const RollingProblem& problem);

    /// Presses until a relaxing substrate has relaxed; the forces that drive act already, the
    /// creepage does not. Called once, before roll(). Throws contact::InputError when the force
    /// exceeds what friction carries, contact::ContactAtEdge of the grid, contact::NotConverged.
    RollingState press();
    /// Rolls on by one cell. Throws contact::InputError where friction has a rate.
    RollingState roll();
    /// Slip [-] and dissipation [Pa] per rolled way; at rest, of the pressing: 0.
    contact::Surface surface() const;
    const RollingProblem& problem() const { return problem_; }
    double cell() const { return cell_; }  ///< rolled in a step [m]
    /// Checks of all solutions so far.
    const contact::Audit& audit() const { return model_.audit(); }

  private:
    contact::LoadStep step() const;
    RollingState record(const contact::StepRecord& step) const;

    RollingProblem problem_;
    double cell_;  // rolled in a step [m]
    contact::SurfaceModel model_;
    contact::Vector2 shift_{};  // rigid, before the last step [m]
    int n_rolled_ = 0;          // cells
};

struct SteadyRolling {
    RollingState state;
    contact::Surface surface;  ///< slip [-] and dissipation [Pa] per rolled way
    contact::Audit audit;
    std::optional<SurfaceTemperatures> temperatures = {};  ///< where the problem has heat
};

/// Rolls on over a relaxing substrate until nothing changes any more, where its steady compliance
/// is not known. `states` are those from rest on. Throws contact::NotConverged.
SteadyRolling roll_until_steady(TransientRolling& rolling, std::vector<RollingState> states);

/// The steady state of elastic bodies, solved directly; coupled normal and tangential contact by
/// staggered iteration (Panagiotopoulos 1975), accelerated (see contact::FixedPoint). Throws
/// contact::InputError for points that form no grid or a force above the friction limit,
/// contact::ContactAtEdge of the grid, contact::NotConverged.
SteadyRolling steady_rolling(const contact::Compliance& compliance, const RollingProblem& problem);

/// The same of a relaxing substrate, whose compliance is that of the problem's speed.
SteadyRolling steady_rolling(const contact::SteadyCompliance& compliance,
                             const RollingProblem& problem);

/// The steady state: of elastic bodies directly, over a relaxing substrate by rolling from rest.
SteadyRolling steady_rolling(const contact::Substrate& substrate, const RollingProblem& problem);

}  // namespace tricontact::rolling
