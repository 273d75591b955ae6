#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "contact/base/special_values.h"
#include "mdr/bed.h"
#include "mdr/line_surface.h"
#include "mdr/load_bound.h"
#include "mdr/normal_bed.h"
#include "mdr/spring_memory.h"

namespace tricontact::mdr {

/// The spring bed on a relaxing substrate: the springs of a SpringBed, both stiffnesses times the
/// same relaxation function of time (Popov and Hess 2015, ch. 7; Lee and Radok 1960). Each spring
/// remembers its own past; where the indenter leaves faster than they follow, springs are free of
/// force, relax, and may be met again (Ting 1966, 1968). Every step is solved exactly for
/// deflections that change linearly in time; over time steps the results are of the second order.
///
/// Bounds of other laws than Coulomb's are those of LoadBound, from the springs' own loads.
///
/// Lines, areas and refusals are those of SpringBed. The elastic bed is the limit of short and of
/// long durations.
class RelaxingBed final : public Bed {
  public:
    /// `data.relaxation` must be set. Throws contact::InputError for values out of range.
    explicit RelaxingBed(BedData data);

    /// Throws as SpringBed::advance, and contact::InputError for a negative duration.
    contact::StepRecord advance(const contact::LoadStep& step) override;
    void release() override;
    /// The unit shift is mu E*/G* d: what the traction mu p makes that has the same past as p;
    /// under another law with the present bound over load at the centre in the place of mu.
    contact::Scales scales() const override;
    contact::Surface surface() const override;
    std::vector<contact::ContactState> contact_states() const override {
        std::vector<contact::ContactState> states;
        states.reserve(size());
        for (int i = 0; i < size(); ++i) states.push_back(contact_state(i));
        return states;
    }
    double limit_tangential_ratio() const override;
    void start_limit() override {
        least_load_.assign(size(), contact::infinity);
        update_limit();
        limit_normal_force_ = normal_force_;
        limit_total_bound_ = total_bound_;
    }

    std::string write_state() const override;
    void read_state(std::string_view bytes) override;

    int size() const { return normal_.size(); }

  private:
    template <class Archive, class Self>
    static void transfer_all(Archive& archive, Self& bed);
    int press(double position, const contact::NormalControl& control);
    int press_to_sum(double sum);
    void sample_heights();
    void find_contact();
    void grow();
    void push(double stiffness);
    void update_line_bounds();
    void update_offsets();
    void find_carried(double position_before, double depth_before);
    ShiftSolution find_shift_increment(const contact::TangentialControl& control);
    SlipSums slide(double increment);
    void update_limit();
    void audit_step(const contact::LoadStep& step, const SlipSums& sums);
    double slip(int spring) const {  // in contact, of the last step [m]
        const double carried = carried_.empty() ? 1 : carried_[spring - contact_.first];
        return carried * shift_increment_ -
               (tangential_.deflection()[spring] - shear_before_[spring]);
    }
    contact::ContactState contact_state(int spring) const {
        if (!(pressed_[spring] > 0)) return contact::ContactState::open;
        return state_in_contact(slip(spring), largest_bound_);
    }

    std::unique_ptr<PlaneProfile> profile_;
    PointRow row_;

    SpringMemory normal_, tangential_;
    Window touched_;  // all springs outside are at rest
    double position_ = 0, depth_ = 0;
    std::vector<double> heights_;  // of the profile over the springs' free ends [m]
    Window contact_;               // from the first to the last spring in contact
    double n_contact_ = 0;
    std::vector<double> pressed_;                     // below their free ends [m]
    std::vector<double> offsets_, bounds_, sheared_;  // beside the free ends: before, most, after
    std::optional<LoadBound> load_bound_;             // empty: Coulomb's law
    std::vector<double> line_bounds_;                 // of another law [N/m]
    double largest_bound_ = 0;                        // [m]
    std::vector<double> carried_;                     // see SpringBed
    std::vector<double> force_;                       // over the relaxed stiffness [m]
    std::vector<double> shear_before_;                // deflections before the step [m]
    SpringMemory::Sums pressing_, shearing_;          // of the last step
    double stored_in_pressing_ = 0, stored_in_shearing_ = 0;  // over the stiffness [m^2]
    bool friction_ = true;                                    // in the last step

    std::vector<double> least_load_;  // since start_limit, over E* [m]; of another law the bound
};

}  // namespace tricontact::mdr
