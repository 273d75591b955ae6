#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "app/models/roll_models.h"
#include "contact/model_makers.h"
#include "contact/models/model_kind.h"
#include "mdr/model.h"
#include "mdr/settings.h"
#include "rolling/creep_theory.h"

namespace tricontact::app {

namespace {

using contact::TangentialControl;
using rolling::drive_sign;
using rolling::RollingRun;
using rolling::RollingState;

/// A bed of springs under a profile that rolls on from one end, a spring a step.
class RollingBed {
  public:
    /// `distance` [m] as far as it is to roll; farther the bed grows.
    RollingBed(const Case& c, double distance) : relaxes_(c.relaxation.has_value()) {
        const double a = contact::half_space_scales(c).contact_radius;
        const int springs = c.of<mdr::Settings>().springs;
        const double n_springs = springs + springs % 2;
        steps_per_radius_ =
            std::max(1, static_cast<int>(n_springs * a / (bed_margin * (2 * a + distance))));
        model_ = model_of(c, static_cast<int>(n_springs),
                          n_springs * a / steps_per_radius_ / bed_margin);
        step_ = contact::press_step(c);
        step_length_ = spring_distance(static_cast<int>(n_springs));
        // Ends of the contact halfway between springs, before each step as after it: what depends
        // on where springs stand is then the same at each step.
        start_ = -std::round(distance / 2 / step_length_) * step_length_;
        step_.offset[0] = start_;
        model_->advance(step_);
        if (relaxes_) duration_ = step_length_ / c.tractive_rolling->speed;
    }

    double friction_limit() const { return model_->scales().sliding_force; }
    int steps_per_radius() const { return steps_per_radius_; }
    const contact::Model& model() const { return *model_; }

    /// Applies the force [N], or none before creepage is prescribed.
    RollingState press(double force) {
        step_.tangential[0] = {TangentialControl::Kind::force, force};
        last_ = model_->advance(step_);
        return state(0, 0);
    }

    /// Rolls on by a step, at the creepage or under the force of before.
    RollingState roll(const std::optional<double>& creepage) {
        ++n_rolled_;
        step_.offset[0] = start_ + n_rolled_ * step_length_;
        step_.duration = duration_;
        const contact::StepRecord before = last_;
        if (creepage)
            step_.tangential[0] = {TangentialControl::Kind::shift,
                                   before.shift[0] + *creepage * step_length_};
        last_ = model_->advance(step_);
        RollingState now = state((last_.shift[0] - before.shift[0]) / step_length_,
                                 last_.dissipation / step_length_);
        now.material_dissipation = last_.material_dissipation / step_length_;
        now.resistance = resistance(before);
        return now;
    }

  private:
    /// Of mdr::make_model: its bed over contact and path.
    static constexpr double bed_margin = 1.01;

    /// `length` [m] of contact and path, as long as makes a spring's distance the step.
    static std::unique_ptr<contact::Model> model_of(Case c, int n_springs, double length) {
        c.tractive_rolling.reset();
        c.of<mdr::Settings>().springs = n_springs;
        c.rolling.emplace().amplitude = length / 2 - contact::half_space_scales(c).contact_radius;
        return mdr::make_model(c);
    }

    /// Of the bed, whose contact is not to the last digit as wide as the half-space's.
    double spring_distance(int n_springs) {
        model_->advance(step_);
        const double first = model_->surface().first[0];
        model_->release();
        return -2 * first / (n_springs - 1);
    }

    /// What springs and friction took in the last step and neither force gave came by rolling: the
    /// bed's audit holds that balance exactly. Elastic springs press as hard ahead as behind.
    double resistance(const contact::StepRecord& before) const {
        if (!relaxes_) return 0;
        const double taken = last_.stored_energy - before.stored_energy +
                             last_.material_dissipation + last_.dissipation;
        const double given = (last_.normal_force + before.normal_force) / 2 *
                                 (last_.indentation - before.indentation) +
                             (last_.tangential_force[0] + before.tangential_force[0]) / 2 *
                                 (last_.shift[0] - before.shift[0]);
        return (taken - given) / step_length_;
    }

    RollingState state(double creepage, double dissipation) const {
        const contact::Scales scales = model_->scales();
        const double half_length = std::sqrt(last_.contact_area / std::numbers::pi);
        return {.distance = n_rolled_ * step_length_,
                .creepage = {.longitudinal = creepage},
                .normal_force = last_.normal_force,
                .friction_bound = scales.sliding_force,
                .indentation = last_.indentation,
                .force = last_.tangential_force,
                .half_length = half_length,
                .half_width = half_length,
                .peak_pressure = scales.peak_pressure,
                .contact_area = last_.contact_area,
                .stick_area = last_.stick_area,
                .slip_area = last_.slip_area,
                .dissipation = dissipation,
                .pressure_lead = relaxes_ ? std::numeric_limits<double>::quiet_NaN() : 0,
                .iterations = last_.normal_iterations + last_.tangential_iterations,
                .residual = last_.tangential_residual};
    }

    double start_ = 0;
    bool relaxes_;
    double duration_ = 0;  // of a step; elastic springs feel none [s]
    std::unique_ptr<contact::Model> model_;
    int steps_per_radius_ = 1, n_rolled_ = 0;
    double step_length_ = 0;
    contact::LoadStep step_;
    contact::StepRecord last_;
};

/// Rolls on until a contact length changes creepage and indentation no more than rounding does
/// the sum of them.
RollingState steady_state(RollingBed& bed, const std::optional<double>& creepage,
                          double creepage_unit) {
    constexpr double negligible = 1e-7;
    constexpr int most_lengths = 1000;
    RollingState before = bed.roll(creepage);
    for (int length = 0; length < most_lengths; ++length) {
        RollingState now;
        for (int step = 0; step < 2 * bed.steps_per_radius(); ++step) now = bed.roll(creepage);
        const double change = std::abs(now.creepage.longitudinal - before.creepage.longitudinal);
        const double sinking = std::abs(now.indentation - before.indentation);
        if (length > 0 && change <= negligible * creepage_unit &&
            sinking <= negligible * now.indentation)
            return now;
        before = now;
    }
    throw contact::NotConverged(
        "mdr: the rolling bed does not become steady within 1000 contact lengths");
}

}  // namespace

RollingRun roll_springs(const Case& c, const RollRuns& runs) {
    const Case::TractiveRolling& given = *c.tractive_rolling;
    const double a = contact::half_space_scales(c).contact_radius;
    RollingBed bed(c, given.distance * a);
    RollRecorder recorder{{contact::models::mdr, {}, {}, {}}, runs, c.friction};
    const auto note = [&](const RollingState& state, int step) {
        recorder.note(state, step / static_cast<double>(bed.steps_per_radius()),
                      [&] { return bed.model().surface(); });
    };
    double force = 0;
    if (!given.longitudinal_creepage)
        force = c.load.tangential_force ? *c.load.tangential_force
                                        : *c.load.tangential_ratio * bed.friction_limit();
    note(bed.press(force), 0);
    const int n_steps = static_cast<int>(std::lround(given.distance * bed.steps_per_radius()));
    for (int step = 1; step <= n_steps; ++step) {
        note(bed.roll(given.longitudinal_creepage), step);
        recorder.tell(step, n_steps);
    }
    const double unit = rolling::creepage_unit(c);
    RollingState steady = steady_state(bed, given.longitudinal_creepage, unit);
    steady.distance = contact::infinity;
    contact::require_sound(bed.model().audit(), contact::models::mdr);
    recorder.note_steady(steady, bed.model().surface());
    const contact::MaterialPair materials = c.materials();
    const double sliding =
        2 * materials.effective_modulus() / materials.effective_shear_modulus() * unit;
    recorder.add_curve(0, drive_sign(c) * sliding, [&](double creepage) {
        RollingBed at_creepage(c, 4 * a);  // two contact lengths
        at_creepage.press(0);
        const RollingState point = steady_state(at_creepage, creepage, unit);
        contact::require_sound(at_creepage.model().audit(), contact::models::mdr);
        return point;
    });
    return std::move(recorder.run);
}

}  // namespace tricontact::app
