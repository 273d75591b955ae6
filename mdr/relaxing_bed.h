#pragma once

#include <memory>
#include <string>
#include <vector>

#include "contact/model.h"
#include "mdr/bed_data.h"
#include "mdr/line_surface.h"
#include "mdr/normal_bed.h"
#include "mdr/spring_memory.h"

namespace tricontact::mdr {

struct SlipSums;
struct ShiftSolution;

/// The spring bed on a relaxing substrate: the springs of a SpringBed, both stiffnesses times the
/// same relaxation function of time (Popov and Hess 2015, ch. 7; Lee and Radok 1960). Each spring
/// remembers its own past; where the indenter leaves faster than they follow, springs are free of
/// force, relax, and may be met again (Ting 1966, 1968). Every step is solved exactly for
/// deflections that change linearly in time; over time steps the results are of the second order.
///
/// Lines, areas and refusals are those of SpringBed. The elastic bed is the limit of short and of
/// long durations.
class RelaxingBed final : public contact::Model {
  public:
    /// `data.relaxation` must be set. Throws contact::InputError for values out of range.
    explicit RelaxingBed(BedData data);

    std::string name() const override { return "mdr"; }
    /// Throws as SpringBed::advance, and contact::InputError for a negative duration.
    contact::StepRecord advance(const contact::LoadStep& step) override;
    void release() override;
    /// The unit shift is mu E*/G* d: what the traction mu p makes that has the same past as p.
    contact::Scales scales() const override;
    contact::Surface surface() const override;
    std::vector<contact::ContactState> contact_states() const override;
    double limit_tangential_ratio() const override;
    void start_limit() override;
    const contact::Audit& audit() const override { return audit_; }

    int size() const { return normal_.size(); }

  private:
    int press(double position, const contact::NormalControl& control);
    int press_to_sum(double sum);
    void sample_heights();
    void find_contact();
    void grow();
    void push(double stiffness);
    void update_offsets();
    ShiftSolution find_shift_increment(const contact::TangentialControl& control);
    SlipSums slide(double increment);
    void update_limit();
    void audit_step(const contact::LoadStep& step, const SlipSums& sums);
    contact::StepRecord record(const contact::LoadStep& step, const SlipSums& sums) const;
    double slip(int spring) const;
    contact::ContactState contact_state(int spring) const;
    double negligible_slip() const;

    std::unique_ptr<PlaneProfile> profile_;
    double effective_modulus_, effective_shear_modulus_, friction_coefficient_;
    contact::Vector2 direction_;  // of rolling
    double bound_ratio_;          // mu E*/G*
    PointRow row_;

    SpringMemory normal_, tangential_;
    Window touched_;  // all springs outside are at rest
    double position_ = 0, depth_ = 0;
    std::vector<double> heights_;  // of the profile over the springs' free ends [m]
    Window contact_;               // from the first to the last spring in contact
    double n_contact_ = 0;
    std::vector<double> pressed_;                     // below their free ends [m]
    std::vector<double> offsets_, bounds_, sheared_;  // beside the free ends: before, most, after
    std::vector<double> force_;                       // over the relaxed stiffness [m]
    std::vector<double> shear_before_;                // deflections before the step [m]
    SpringMemory::Sums pressing_, shearing_;          // of the last step
    double stored_in_pressing_ = 0, stored_in_shearing_ = 0;  // over the stiffness [m^2]
    double normal_force_ = 0, tangential_force_ = 0;          // [N]
    double shift_ = 0, shift_increment_ = 0;                  // [m]
    bool friction_ = true;                                    // in the last step

    std::vector<double> least_load_;  // since start_limit, over E* [m]
    double limit_normal_force_ = 0;
    contact::Audit audit_;
};

}  // namespace tricontact::mdr
