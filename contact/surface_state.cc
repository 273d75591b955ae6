// What a surface model says about its state: scales, surface, bytes.

#include <algorithm>
#include <cmath>

#include "contact/frictional_work.h"
#include "contact/solvers/contact_radius.h"
#include "contact/solvers/mirror.h"
#include "contact/state_bytes.h"
#include "contact/surface_model.h"

namespace tricontact::contact {

Scales SurfaceModel::scales() const {
    const ContactPoints& points = this->points();
    TangentialField sliding(bound_.size()), displacement(bound_.size());
    for (std::size_t i = 0; i < bound_.size(); ++i)
        sliding.x[i] = friction_coefficient_ * normal_->pressure[i];
    substrate_->relaxed().tangential(sliding, displacement);
    std::size_t centre = 0;
    auto distance = [&](std::size_t i) {
        return std::hypot(points.x[i] - offset_[0], points.y[i] - offset_[1]);
    };
    for (std::size_t i = 1; i < bound_.size(); ++i)
        if (distance(i) < distance(centre)) centre = i;
    return {.normal_force = normal_->force,
            .contact_radius = indenter_->presses_like_a_ball()
                                  ? contact_radius(points, normal_->pressure, offset_)
                                  : counted_radius(points, normal_->pressure),
            .indentation = normal_->indentation,
            .peak_pressure = *std::max_element(normal_->pressure.begin(), normal_->pressure.end()),
            .unit_shift = displacement.x[centre]};
}

Vector2 SurfaceModel::slip(std::size_t i) const {
    return told_slip(contact_state_[i], {slip_.x[i], slip_.y[i]});
}

double SurfaceModel::friction_work(std::size_t i) const {
    return frictional_work(contact_state_[i],
                           {tangential_.traction.x[i], tangential_.traction.y[i]},
                           {slip_.x[i], slip_.y[i]});
}

Surface SurfaceModel::surface() const {
    const ContactPoints& points = this->points();
    Surface s;
    s.layout = points.quads.empty() ? Surface::Layout::grid : Surface::Layout::nodes;
    s.n_x = points.n_x;
    s.n_y = points.n_y;
    s.first = points.first;
    s.spacing = points.spacing;
    s.offset = offset_;
    s.normal_traction = normal_->pressure;
    s.tangential_traction_x = tangential_.traction.x;
    s.tangential_traction_y = tangential_.traction.y;
    s.friction_bound = bound_;
    s.displacement_x = displacement_.x;
    s.displacement_y = displacement_.y;
    s.displacement_z = displacement_z_;
    s.gap.resize(bound_.size());
    for (auto* field : {&s.slip_x, &s.slip_y, &s.dissipation}) field->resize(bound_.size());
    for (std::size_t i = 0; i < bound_.size(); ++i) {
        s.gap[i] = coupling_.bare_height()[i] + displacement_z_[i] - normal_->indentation;
        const Vector2 told = slip(i);
        s.slip_x[i] = told[0];
        s.slip_y[i] = told[1];
        s.dissipation[i] = friction_work(i);
    }
    s.slip_path = slip_path_;
    s.friction_work = friction_work_;
    s.contact_state = contact_state_;
    if (s.layout != Surface::Layout::nodes) return s;

    s.node_x = points.x;
    s.node_y = points.y;
    s.quads = points.quads;
    s.normal_traction_consistent =
        substrate_->compliance().consistent_traction(s.normal_traction, false);
    s.tangential_traction_x_consistent =
        substrate_->compliance().consistent_traction(s.tangential_traction_x, false);
    s.tangential_traction_y_consistent =
        substrate_->compliance().consistent_traction(s.tangential_traction_y, true);
    return points.mirrored ? mirrored(s) : s;
}

std::string SurfaceModel::write_state() const {
    StateWriter out;
    for (const Vector2& v : {offset_, shift_, tangential_.shift_increment}) out.add(v);
    for (const auto* field :
         {&normal_->pressure, &normal_->displacement, &bound_, &tangential_.traction.x,
          &tangential_.traction.y, &tangential_.displacement.x, &tangential_.displacement.y,
          &displacement_.x, &displacement_.y, &displacement_z_, &slip_.x, &slip_.y,
          &least_pressure_, &slip_path_, &friction_work_})
        out.add(*field);
    for (const double value : {phase_, normal_->indentation, normal_->length, normal_->force,
                               normal_->residual, tangential_.residual, tangential_.force_residual,
                               gap_residual_, least_pressure_force_, energy_, shift_factor_})
        out.add(value);
    out.add(contact_state_);
    substrate_->write(out);
    out.add(audit_.checks().size());
    for (const Audit::Check& check : audit_.checks()) {
        out.add(check.name);
        out.add(check.worst);
        out.add(check.allowed);
    }
    return out.take();
}

void SurfaceModel::read_state(std::string_view bytes) {
    StateReader in(bytes);
    NormalSolution normal;
    for (Vector2* v : {&offset_, &shift_, &tangential_.shift_increment}) in.get(*v);
    for (auto* field :
         {&normal.pressure, &normal.displacement, &bound_, &tangential_.traction.x,
          &tangential_.traction.y, &tangential_.displacement.x, &tangential_.displacement.y,
          &displacement_.x, &displacement_.y, &displacement_z_, &slip_.x, &slip_.y,
          &least_pressure_, &slip_path_, &friction_work_})
        in.get(*field);
    for (double* value : {&phase_, &normal.indentation, &normal.length, &normal.force,
                          &normal.residual, &tangential_.residual, &tangential_.force_residual,
                          &gap_residual_, &least_pressure_force_, &energy_, &shift_factor_})
        in.get(*value);
    in.get(contact_state_);
    substrate_->read(in);
    std::size_t n_checks = 0;
    in.get(n_checks);
    audit_ = {};
    for (std::size_t k = 0; k < n_checks; ++k) {
        Audit::Check check;
        in.get(check.name);
        in.get(check.worst);
        in.get(check.allowed);
        audit_.record(check.name, check.worst, check.allowed);
    }
    normal_ = std::make_shared<const NormalSolution>(std::move(normal));
    keep_start();
    // Heights and slopes follow from the rest.
    coupling_.place({offset_, shift_, displacement_});
    coupling_.update_height(normal_->pressure, tangential_.traction);
}

}  // namespace tricontact::contact
