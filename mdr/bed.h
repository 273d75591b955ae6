#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <string>

#include "contact/base/vector2.h"
#include "contact/friction/friction_law.h"
#include "contact/load_path.h"
#include "contact/model.h"
#include "contact/models/model_kind.h"
#include "contact/substrates/relaxation.h"
#include "mdr/plane_profile.h"
#include "mdr/tangential_step.h"

namespace tricontact::mdr {

/// What a spring bed is made of.
struct BedData {
    std::unique_ptr<PlaneProfile> profile;
    double effective_modulus = 0;        ///< E* [Pa], of a relaxing bed when relaxed
    double effective_shear_modulus = 0;  ///< G* [Pa], likewise
    std::shared_ptr<const contact::FrictionLaw> friction;
    int n_springs = 0;         ///< over the whole bed
    double half_length = 0;    ///< of the bed about the starting position [m]
    double rolling_angle = 0;  ///< of the line on which it rolls [rad]
    std::optional<contact::Relaxation> relaxation{};                      ///< empty: elastic
    std::shared_ptr<const contact::AxisymmetricIndenter> wearing_body{};  ///< null: does not wear
};

/// Path length [m] of the step's rolling offset on the line through the origin along the unit
/// vector `direction`, with its sign. `model`: named in messages. Throws contact::InputError for a
/// load or shift across the load (y), since a line of springs has one direction, and for an offset
/// off that line, by more than rounding on the path length and `spacing` [m].
double position_on_line(const std::string& model, const contact::LoadStep& step,
                        const contact::Vector2& direction, double spacing);

/// Steps of independent springs are exact: slips below this part of the bound are rounding.
inline constexpr double exact_steps = 1e-11;

/// What elastic and relaxing beds of independent springs have in common.
class Bed : public contact::Model {
  public:
    std::string name() const final { return contact::models::mdr; }
    double step_accuracy() const final { return exact_steps; }
    const contact::Audit& audit() const final { return audit_; }

  protected:
    /// Throws contact::InputError for values out of range.
    explicit Bed(const BedData& data);

    /// Throws contact::InputError unless the control is positive and finite.
    static void check_positive(const contact::NormalControl& control);
    /// Throws contact::InputError if a force-controlled F_T reaches mu F_N.
    void check_carried(const contact::TangentialControl& control) const;
    /// Throws contact::InputError if the depth [m] is beyond the profile's rim.
    static void check_rim(const PlaneProfile& profile, double depth) {
        if (depth > profile.value(profile.range())) profile.half_width(depth);  // throws
    }
    /// Springs to be added at each end of a bed that has proved too short.
    static int more_springs(int n) { return std::max(16, n / 4); }

    /// Slip [m] below which a spring counts as sticking: rounding on the largest bound [m].
    static double negligible_slip(double largest_bound) { return exact_steps * largest_bound; }
    static contact::ContactState state_in_contact(double slip, double largest_bound) {
        return std::abs(slip) > negligible_slip(largest_bound) ? contact::ContactState::slip
                                                               : contact::ContactState::stick;
    }
    /// Bounds, directions and forces of a step whose largest bound is this [m]; `held`: by
    /// friction.
    void audit_forces(const contact::LoadStep& step, const SlipSums& sums, double largest_bound,
                      bool held);
    /// All but energies and the normal iterations. Numbers of springs; areas are those of discs.
    struct Springs {
        double all, in_contact, sticking;
    };
    contact::StepRecord record(const contact::LoadStep& step, const ShiftSolution& shift,
                               double depth, double spacing, const Springs& n, bool held) const;

    /// What steps change of these, from or to an archive.
    template <class Archive, class Self>
    static void transfer(Archive& archive, Self& bed) {
        archive(bed.total_bound_, bed.normal_force_, bed.tangential_force_, bed.shift_,
                bed.shift_increment_, bed.limit_normal_force_, bed.limit_total_bound_);
    }

    /// Of the present F_N and bounds [N].
    double friction_limit() const { return law_->limit({normal_force_, total_bound_}); }

    double effective_modulus_, effective_shear_modulus_;
    std::shared_ptr<const contact::FrictionLaw> law_;
    contact::Vector2 direction_;                      // of rolling
    double bound_ratio_;                              // mu E*/G* of Coulomb's law, else NaN
    double total_bound_ = 0;                          // of the springs [N], not under Coulomb's law
    double normal_force_ = 0, tangential_force_ = 0;  // [N]
    double shift_ = 0, shift_increment_ = 0;          // [m]
    double limit_normal_force_ = 0, limit_total_bound_ = 0;  // at start_limit [N]
    contact::Audit audit_;
};

}  // namespace tricontact::mdr
