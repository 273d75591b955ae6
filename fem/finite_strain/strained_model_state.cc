// What a model at finite strains says about its state: scales, surface, record, audit, bytes.

#include <algorithm>
#include <cmath>

#include "contact/base/special_values.h"
#include "contact/base/state_bytes.h"
#include "contact/mirrored_surface.h"
#include "contact/solvers/contact_region.h"
#include "contact/surface_audit.h"
#include "fem/finite_strain/present_area.h"
#include "fem/finite_strain/strained_model.h"

// True tractions: the solver's are forces over reference areas in the frames of the surface. Over
// the present area they are Cauchy's: times A/a, the pressure along the normal also times |(slope,
// 1)|, since p is its vertical component. Areas seen from above (`moved.area`) belong to moments
// and the contact radius; areas of the surface itself to slip, stick and work.
//
// What is resumed is `transfer`: the state, the memory of the branches, and sums since the last
// period.

namespace tricontact::fem {

using contact::ContactState;
using contact::LoadStep;
using contact::NormalControl;
using contact::StepRecord;
using contact::Surface;
using contact::TangentialControl;
using contact::TangentialField;
using contact::Vector2;

contact::Scales StrainedModel::scales() const {
    const auto& points = this->points();
    const std::vector<double> area = present_areas(points, now_.position);
    const ContactFrames present = frames();
    contact::ContactPoints moved = points;
    std::vector<double> pressure(points.size());
    TangentialField sliding(points.size()), displacement(points.size());
    std::size_t centre = 0;
    double nearest = contact::infinity, peak = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        moved.x[i] = now_.position[i][0];
        moved.y[i] = now_.position[i][1];
        moved.area[i] = area[i] / present.stretch(i);  // as seen from above
        pressure[i] = now_.pressure[i] * points.area[i] / moved.area[i];
        peak = std::max(peak, pressure[i]);
        const double distance = std::hypot(moved.x[i] - now_.pose.lowest_point()[0],
                                           moved.y[i] - now_.pose.lowest_point()[1]);
        if (distance < nearest) nearest = distance, centre = i;
    }
    setup_.friction->bounds({now_.pressure}, sliding.x);
    setup_.layer->tangential(sliding, displacement);
    return {.normal_force = normal_force_,
            .contact_radius = contact::contact_radius(moved, pressure, now_.pose.lowest_point()),
            .indentation = now_.pose.indentation,
            .peak_pressure = peak,
            .unit_shift = displacement.x[centre],
            .sliding_force =
                setup_.friction->limit(total_friction(solver_->correction.bounds(now_, present)))};
}

Surface StrainedModel::surface() const {
    const auto& points = this->points();
    const std::size_t n = points.size();
    const std::vector<double> area = present_areas(points, now_.position);
    const ContactFrames present = frames();
    Surface s;
    s.layout = Surface::Layout::nodes;
    s.n_x = points.n_x;
    s.n_y = points.n_y;
    s.first = points.first;
    s.spacing = points.spacing;
    s.offset = now_.pose.offset;
    s.node_x = points.x;
    s.node_y = points.y;
    s.quads = points.quads;
    for (auto* field : {&s.normal_traction, &s.tangential_traction_x, &s.tangential_traction_y,
                        &s.friction_bound, &s.displacement_x, &s.displacement_y, &s.displacement_z,
                        &s.gap, &s.slip_x, &s.slip_y, &s.dissipation})
        field->resize(n);
    for (std::size_t i = 0; i < n; ++i) {
        const double to_true = points.area[i] / area[i];
        s.normal_traction[i] = now_.pressure[i] * present.stretch(i) * to_true;
        s.tangential_traction_x[i] = now_.traction.x[i] * to_true;
        s.tangential_traction_y[i] = now_.traction.y[i] * to_true;
        s.displacement_x[i] = now_.position[i][0] - points.x[i];
        s.displacement_y[i] = now_.position[i][1] - points.y[i];
        s.displacement_z[i] = now_.position[i][2];
        s.gap[i] = present.height(i) + now_.position[i][2] - now_.pose.indentation;
        s.slip_x[i] = slip_.x[i];
        s.slip_y[i] = slip_.y[i];
        s.dissipation[i] = work_[i] * to_true;
    }
    setup_.friction->bounds({s.normal_traction}, s.friction_bound);
    s.slip_path = slip_path_;
    s.friction_work = friction_work_;
    s.contact_state = contact_state_;
    return points.mirrored ? mirrored(s) : s;
}

std::vector<ContactState> StrainedModel::contact_states() const {
    return points().mirrored ? mirrored(contact_state_, points()) : contact_state_;
}

std::unique_ptr<const contact::Interior> StrainedModel::interior() {
    // In no time nothing relaxes: the present state.
    auto inside = std::make_unique<contact::Interior>(solver_->body.interior(
        setup_.layer->corrected().discretisation, now_.body, solver_->body.begin(memory_, 0)));
    inside->applied = {forces_[0], forces_[1], -normal_force_};
    return inside;
}

StepRecord StrainedModel::record(const LoadStep& step) const {
    const std::vector<double> area = present_areas(points(), now_.position);
    StepRecord r;
    r.phase = step.phase;
    r.offset = step.offset;
    r.indentation = now_.pose.indentation;
    r.shift = now_.pose.shift;
    r.normal_force = normal_force_;
    r.tangential_force = forces_;
    for (std::size_t i = 0; i < area.size(); ++i) {
        double& of_state = contact_state_[i] == ContactState::open    ? r.open_area
                           : contact_state_[i] == ContactState::stick ? r.stick_area
                                                                      : r.slip_area;
        of_state += area[i];
        r.dissipation += points().area[i] * work_[i];
    }
    r.material_dissipation = material_dissipation_;
    r.stored_energy = energy_;
    const StrainedBody::Extremes extremes = solver_->body.extremes(now_.body);
    r.largest_stretch = extremes.stretch;
    r.largest_shear = extremes.shear;
    r.contact_area = r.stick_area + r.slip_area;
    r.normal_iterations = r.tangential_iterations = iterations_;
    r.normal_residual = r.tangential_residual = displacement_residual_;
    r.force_residual = force_residual_;
    return r;
}

/// From the state itself: balance in the whole body, the gap of the deformed surface, Coulomb's law
/// in its plane, forces.
void StrainedModel::audit_step(const LoadStep& step, const ContactFrames& frames,
                               const DeferredCorrection::Report& report) {
    const double tolerance = setup_.tolerance;
    audit_.record("force_balance", report.force_residual, tolerance);
    audit_.record("gap_and_complementarity", solver_->correction.gap_residual(now_, frames),
                  10 * tolerance);
    if (step.normal.kind == NormalControl::Kind::force)
        audit_.record("normal_force",
                      std::abs(normal_force_ - step.normal.value) / step.normal.value, tolerance);
    if (!step.friction || normal_force_ == 0) return;
    std::array<TangentialControl, 2> no_forces;
    for (auto& control : no_forces) control.kind = TangentialControl::Kind::shift;
    const std::vector<double> bound = solver_->correction.bounds(now_, frames);
    const contact::FrictionLaw::Total total = total_friction(bound);
    contact::audit_tangential({.bound = bound,
                               .area = points().area,
                               .traction = now_.traction,
                               .slip = now_.slip,
                               .contact_state = contact_state_,
                               .control = no_forces,
                               .length = compared_slip(total),
                               // the surface's frames are those of the last iteration
                               .excess_allowed = tolerance},
                              tolerance, audit_);
    for (int a = 0; a < 2; ++a) {
        const auto& [kind, value] = step.tangential[a];
        if (kind == TangentialControl::Kind::shift || (a == 1 && points().mirrored)) continue;
        const double limit = setup_.friction->limit(total);
        const double wanted = kind == TangentialControl::Kind::ratio ? value * limit : value;
        audit_.record("tangential_force", std::abs(forces_[a] - wanted) / limit, tolerance);
    }
}

template <class Archive, class Self>
void StrainedModel::transfer(Archive& archive, Self& m) {
    archive(m.now_.body.displacement, m.now_.body.mean_stress, m.now_.pose, m.now_.position,
            m.now_.pressure, m.now_.traction.x, m.now_.traction.y, m.now_.slip.x, m.now_.slip.y,
            m.memory_.strain, m.memory_.viscous, m.memory_.dilatation, m.memory_.viscous_dilatation,
            m.forces_, m.normal_force_, m.energy_, m.relaxed_energy_, m.material_dissipation_,
            m.slip_.x, m.slip_.y, m.work_, m.slip_path_, m.friction_work_, m.contact_state_,
            m.least_pressure_, m.limit_start_.normal_force, m.limit_start_.bound, m.iterations_,
            m.force_residual_, m.displacement_residual_);
}

std::string StrainedModel::write_state() const {
    contact::StateWriter out;
    transfer(out, *this);
    audit_.write(out);
    return out.take();
}

void StrainedModel::read_state(std::string_view bytes) {
    contact::StateReader in(bytes);
    transfer(in, *this);
    audit_.read(in);
}

}  // namespace tricontact::fem
