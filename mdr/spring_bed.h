#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "contact/wearing_contact.h"
#include "mdr/bed.h"
#include "mdr/line_bound.h"
#include "mdr/line_surface.h"
#include "mdr/normal_bed.h"
#include "mdr/stores_shear.h"

namespace tricontact::mdr {

/// Method of dimensionality reduction (Popov and Hess 2015): independent springs of stiffness
/// E* dx and G* dx at fixed positions on the substrate, pressed by the plane profile, which the
/// rolling path moves along the bed. Out of contact a spring is free of force; in contact it
/// sticks up to the bound |u| <= mu (E*/G*) (d - g), under other laws up to that of LineBound.
/// Every step is solved exactly.
///
/// The bed has one direction. A rolling offset at any angle counts as its signed path length, and
/// the tangential force (x) acts along the bed: MDR cannot tell parallel from perpendicular
/// rolling. A tangential force or a shift in y is refused.
///
/// Areas are those of discs as long as the springs in question together: pi/4 L^2.
/// If the contact reaches the end of the bed, springs are added there.
class SpringBed final : public Bed, public contact::Wearable, public StoresShear {
  public:
    /// Throws contact::InputError for values out of range.
    explicit SpringBed(BedData data);

    /// Throws contact::InputError if the step is none of a spring bed's (see above), asks for
    /// F_T >= mu F_N or presses beyond the indenter's rim; contact::NotConverged.
    contact::StepRecord advance(const contact::LoadStep& step) override;
    void release() override {
        std::fill(deflections_.begin(), deflections_.end(), 0);
        tangential_force_ = 0;
        shift_ = shift_increment_ = 0;
        is_fresh_ = true;
    }
    contact::Scales scales() const override;
    /// Line layout, thinned out to about a thousand points: springs' deflections and line loads,
    /// gap and displacement_z of the springs too (plane picture); tractions transformed back.
    contact::Surface surface() const override;
    std::vector<contact::ContactState> contact_states() const override {
        std::vector<contact::ContactState> states;
        states.reserve(normal_.size());
        for (int i = 0; i < normal_.size(); ++i) states.push_back(contact_state(i));
        return states;
    }
    double limit_tangential_ratio() const override;
    std::unique_ptr<contact::WearingContact> wearing(const contact::WearProblem& problem) override;
    void start_limit() override {
        least_contact_ = normal_.contact();
        least_bounds_ = bounds_;
        limit_normal_force_ = normal_force_;
        limit_total_bound_ = total_bound_;
    }

    std::string write_state() const override;
    void read_state(std::string_view bytes) override;

    double shear_energy() const override;
    const NormalBed& normal() const { return normal_; }
    double deflection(int i) const { return deflections_[i]; }  ///< tangential, of spring i [m]

  private:
    template <class Archive, class Self>
    static void transfer_all(Archive& archive, Self& bed);
    int press(double position, const contact::NormalControl& control);
    void grow();
    void update_bounds();
    /// Normal force and energy; visit(spring of the contact, its penetration [m]).
    template <class Visit>
    void add_up_loads(Visit visit);
    void update_other_bounds();
    void find_carried(double position_before);
    ShiftSolution find_shift_increment(const contact::TangentialControl& control) const;
    SlipSums slide(double increment);
    void unload(int first, int last, double increment, SlipSums& sums) const;
    double work_between() const;
    double work_between(int first, int last) const;
    void update_limit();
    void audit_step(const contact::LoadStep& step, const SlipSums& sums, double force_before);
    double slip(int spring) const {  // in contact, of the last step [m]
        const double carried = carried_.empty() ? 1 : carried_[spring - normal_.contact().first];
        return carried * shift_increment_ - (deflections_[spring] - deflections_before_[spring]);
    }
    contact::ContactState contact_state(int spring) const {
        if (spring < normal_.contact().first || spring >= normal_.contact().last)
            return contact::ContactState::open;
        return state_in_contact(slip(spring), largest_bound_);
    }
    void set_spring_fields(int spring, int point, contact::Surface& surface) const;

    std::shared_ptr<const contact::AxisymmetricIndenter> wearing_body_;
    NormalBed normal_;

    std::vector<double> deflections_, deflections_before_;  // [m], zero out of contact
    Window contact_before_;
    std::vector<double> bounds_;           // of the springs in contact [m]
    std::vector<double> bounds_before_;    // where loads change in proportion, else any
    std::optional<LineBound> line_bound_;  // empty: Coulomb's law
    double largest_bound_ = 0, largest_bound_before_ = 0, total_bound_before_ = 0;
    /// Per spring in contact the share of the step's shift that carries it, see
    /// LoadStep::in_proportion; empty: all of it.
    std::vector<double> carried_;
    mutable KeptAbelWeights weights_;  // of surface()
    bool is_fresh_ = true;             // no step has been taken since the release
    double depth_before_ = 0;          // [m]
    double normal_force_before_ = 0;   // [N]
    double normal_energy_ = 0;         // [J]

    std::vector<double> least_bounds_;  // since start_limit
    Window least_contact_;
};

}  // namespace tricontact::mdr
