#include "fem/case/model_of_revolution.h"

#include "contact/base/error.h"

// Radii h, 2h, ... nh become x = -nh, ..., nh. On the axis even fields are those of the parabola
// a + b r^2 through the first two points, odd ones 0.

namespace tricontact::fem {

namespace {

using contact::Surface;

std::vector<double> through_axis(const std::vector<double>& radial, double sign) {
    const std::size_t n = radial.size();
    if (n == 0) return {};
    std::vector<double> line(2 * n + 1);
    for (std::size_t i = 0; i < n; ++i) {
        line[n + 1 + i] = radial[i];
        line[n - 1 - i] = sign * radial[i];
    }
    if (sign > 0) line[n] = n > 1 ? (4 * radial[0] - radial[1]) / 3 : radial[0];
    return line;
}

std::vector<contact::ContactState> states_through_axis(
    const std::vector<contact::ContactState>& radial) {
    std::vector<contact::ContactState> line(radial.rbegin(), radial.rend());
    line.push_back(radial.front());  // what touches beside the axis does so on it
    line.insert(line.end(), radial.begin(), radial.end());
    return line;
}

void refuse_tangential(const contact::LoadStep& step) {
    for (const contact::TangentialControl& control : step.tangential)
        if (control.value != 0)
            throw contact::InputError(
                "load: a section of a body of revolution has no load along the surface; take fem");
    if (contact::norm(step.offset) != 0 || step.rotation != 0)
        throw contact::InputError(
            "rolling: a section of a body of revolution is pressed where it is; take fem");
}

}  // namespace

contact::StepRecord ModelOfRevolution::advance(const contact::LoadStep& step) {
    refuse_tangential(step);
    contact::LoadStep held = step;
    for (auto& control : held.tangential) control = {contact::TangentialControl::Kind::shift, 0};
    contact::StepRecord record = radial_->advance(held);
    record.tangential_force = {0, 0};  // radial tractions balance each other around the axis
    return record;
}

contact::Scales ModelOfRevolution::scales() const {
    contact::Scales scales = radial_->scales();
    scales.unit_shift = 0;
    return scales;
}

Surface ModelOfRevolution::surface() const {
    Surface s = radial_->surface();
    s.first[0] = -s.first[0] - (s.n_x - 1) * s.spacing[0];
    s.n_x = 2 * s.n_x + 1;
    for (auto* even :
         {&s.normal_traction, &s.friction_bound, &s.displacement_z, &s.gap, &s.dissipation,
          &s.slip_path, &s.friction_work, &s.tangential_traction_y, &s.displacement_y, &s.slip_y})
        *even = through_axis(*even, 1);
    for (auto* odd : {&s.tangential_traction_x, &s.displacement_x, &s.slip_x})
        *odd = through_axis(*odd, -1);
    s.contact_state = states_through_axis(s.contact_state);
    return s;
}

std::vector<contact::ContactState> ModelOfRevolution::contact_states() const {
    return states_through_axis(radial_->contact_states());
}

std::unique_ptr<contact::Model> ModelOfRevolution::sibling(
    const contact::Case::Contact& options) const {
    auto other = radial_->sibling(options);
    return other ? std::make_unique<ModelOfRevolution>(std::move(other)) : nullptr;
}

}  // namespace tricontact::fem
