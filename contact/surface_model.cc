#include "contact/surface_model.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "contact/contact_radius.h"
#include "contact/placement.h"
#include "contact/surface_audit.h"

namespace tricontact::contact {

namespace {
// Normal solutions are kept while they fit: a period comes back to the same offsets again and
// again.
constexpr std::size_t normal_cache_bytes = std::size_t{1} << 28;
}  // namespace

SurfaceModel::SurfaceModel(std::string name, std::unique_ptr<Compliance> compliance,
                           std::unique_ptr<Indenter> indenter, double friction_coefficient,
                           double tolerance)
    : name_(std::move(name)),
      compliance_(std::move(compliance)),
      indenter_(std::move(indenter)),
      friction_coefficient_(friction_coefficient),
      tolerance_(tolerance),
      normal_solver_(*compliance_, 0.1 * tolerance),
      tangential_solver_(*compliance_, tolerance),
      bound_(compliance_->points().size()),
      slip_(compliance_->points().size()),
      contact_state_(compliance_->points().size(), ContactState::open) {
    tangential_.traction = TangentialField(bound_.size());
    tangential_.displacement = TangentialField(bound_.size());
}

StepRecord SurfaceModel::advance(const LoadStep& step) {
    bool reused = false;
    solve_normal(step, reused);
    offset_ = step.offset;
    for (std::size_t i = 0; i < bound_.size(); ++i)
        bound_[i] = friction_coefficient_ * normal_->pressure[i];

    const TangentialField traction_before = tangential_.traction;
    const TangentialField displacement_before = tangential_.displacement;
    const double energy_before = elastic_energy();
    solve_tangential(step);
    update_slip(displacement_before);
    audit_step(step, traction_before, displacement_before, energy_before);
    for (std::size_t i = 0; i < least_pressure_.size(); ++i)
        least_pressure_[i] = std::min(least_pressure_[i], normal_->pressure[i]);
    return record(step, reused);
}

const NormalSolution& SurfaceModel::solve_normal(const LoadStep& step, bool& reused) {
    const ContactPoints& points = compliance_->points();
    const Key key{step.offset, step.normal.kind, step.normal.value};
    if (const auto it = normal_cache_.find(key); it != normal_cache_.end()) {
        reused = true;
        return *(normal_ = it->second);
    }
    const std::vector<double> start = normal_ && step.normal.kind == NormalControl::Kind::force
                                          ? normal_->pressure
                                          : std::vector<double>{};
    auto solution = std::make_shared<const NormalSolution>(
        normal_solver_.solve(heights_over(points, *indenter_, step.offset), step.normal, start));
    if (reaches_edge(points, solution->pressure))
        throw ContactAtEdge(
            fmt::format("{}: the contact reaches the edge of the {} x {} grid at "
                        "phase {:.4g}",
                        name_, points.n_x, points.n_y, step.phase));
    const std::size_t bytes = 2 * sizeof(double) * bound_.size();
    if ((normal_cache_.size() + 1) * bytes <= normal_cache_bytes) normal_cache_[key] = solution;
    return *(normal_ = solution);
}

void SurfaceModel::solve_tangential(const LoadStep& step) {
    std::array<TangentialControl, 2> control = step.tangential;
    for (int d = 0; d < 2; ++d)
        if (control[d].kind == TangentialControl::Kind::shift) control[d].value -= shift_[d];
    const TangentialField before = tangential_.displacement;
    double contact_area = 0;
    for (std::size_t i = 0; i < bound_.size(); ++i)
        if (bound_[i] > 0) contact_area += compliance_->points().area[i];
    const double contact_compliance = normal_->indentation * contact_area / normal_->force;
    tangential_solver_.solve({bound_, before, control, contact_compliance}, tangential_);
    for (int d = 0; d < 2; ++d) shift_[d] += tangential_.shift_increment[d];
}

void SurfaceModel::update_slip(const TangentialField& displacement_before) {
    const double unit = friction_coefficient_ * normal_->indentation;
    for (std::size_t i = 0; i < bound_.size(); ++i) {
        const Vector2 t = {tangential_.traction.x[i], tangential_.traction.y[i]};
        slip_.x[i] = tangential_.shift_increment[0] -
                     (tangential_.displacement.x[i] - displacement_before.x[i]);
        slip_.y[i] = tangential_.shift_increment[1] -
                     (tangential_.displacement.y[i] - displacement_before.y[i]);
        if (bound_[i] == 0) {
            slip_.x[i] = slip_.y[i] = 0;
            contact_state_[i] = ContactState::open;
            continue;
        }
        // On the bound without having moved is stick; 10 tolerances: the solver's noise.
        const bool moves = std::hypot(slip_.x[i], slip_.y[i]) > 10 * tolerance_ * unit;
        const bool at_bound = norm(t) >= bound_[i] * (1 - 1e-9);
        contact_state_[i] = at_bound && moves ? ContactState::slip : ContactState::stick;
    }
}

double SurfaceModel::elastic_energy() const {
    const auto& area = compliance_->points().area;
    const auto& t = tangential_.traction;
    const auto& u = tangential_.displacement;
    double sum = 0;
    for (std::size_t i = 0; i < bound_.size(); ++i)
        sum += area[i] * (t.x[i] * u.x[i] + t.y[i] * u.y[i]);
    return sum / 2;
}

StepRecord SurfaceModel::record(const LoadStep& step, bool normal_reused) const {
    const auto& area = compliance_->points().area;
    StepRecord r;
    r.phase = step.phase;
    r.offset = step.offset;
    r.indentation = normal_->indentation;
    r.shift = shift_;
    for (std::size_t i = 0; i < bound_.size(); ++i) {
        r.normal_force += area[i] * normal_->pressure[i];
        r.tangential_force[0] += area[i] * tangential_.traction.x[i];
        r.tangential_force[1] += area[i] * tangential_.traction.y[i];
        r.dissipation += area[i] * (tangential_.traction.x[i] * slip_.x[i] +
                                    tangential_.traction.y[i] * slip_.y[i]);
        switch (contact_state_[i]) {
            case ContactState::open:
                r.open_area += area[i];
                break;
            case ContactState::stick:
                r.stick_area += area[i];
                break;
            case ContactState::slip:
                r.slip_area += area[i];
                break;
        }
    }
    r.contact_area = r.stick_area + r.slip_area;
    r.normal_iterations = normal_reused ? 0 : normal_->iterations;
    r.tangential_iterations = tangential_.iterations;
    r.normal_residual = normal_->residual;
    r.tangential_residual = tangential_.residual;
    r.force_residual = tangential_.force_residual;
    if (step.normal.kind == NormalControl::Kind::force)
        r.force_residual = std::max(
            r.force_residual, std::abs(r.normal_force - step.normal.value) / step.normal.value);
    return r;
}

void SurfaceModel::audit_step(const LoadStep& step, const TangentialField& traction_before,
                              const TangentialField& displacement_before, double energy_before) {
    audit_normal(*normal_, step.normal, compliance_->points().area, tolerance_, audit_);
    audit_tangential({.bound = bound_,
                      .area = compliance_->points().area,
                      .traction = tangential_.traction,
                      .slip = slip_,
                      .contact_state = contact_state_,
                      .control = step.tangential,
                      .length = friction_coefficient_ * normal_->indentation},
                     tolerance_, audit_);
    audit_energy({.area = compliance_->points().area,
                  .traction_before = traction_before,
                  .displacement_before = displacement_before,
                  .traction = tangential_.traction,
                  .displacement = tangential_.displacement,
                  .shift_increment = tangential_.shift_increment,
                  .energy_change = elastic_energy() - energy_before,
                  .unit = friction_coefficient_ * friction_coefficient_ * normal_->force *
                          normal_->indentation},
                 audit_);
}

Scales SurfaceModel::scales() const {
    const ContactPoints& points = compliance_->points();
    TangentialField sliding(bound_.size()), displacement(bound_.size());
    sliding.x = bound_;
    compliance_->tangential(sliding, displacement);
    std::size_t centre = 0;
    auto distance = [&](std::size_t i) {
        return std::hypot(points.x[i] - offset_[0], points.y[i] - offset_[1]);
    };
    for (std::size_t i = 1; i < bound_.size(); ++i)
        if (distance(i) < distance(centre)) centre = i;
    return {.normal_force = normal_->force,
            .contact_radius = contact_radius(points, normal_->pressure, offset_),
            .indentation = normal_->indentation,
            .peak_pressure = *std::max_element(normal_->pressure.begin(), normal_->pressure.end()),
            .unit_shift = displacement.x[centre]};
}

void SurfaceModel::start_limit() {
    least_pressure_ = normal_->pressure;
    least_pressure_force_ = normal_->force;
}

double SurfaceModel::limit_tangential_ratio() const {
    const auto& area = compliance_->points().area;
    double sum = 0;
    for (std::size_t i = 0; i < least_pressure_.size(); ++i) sum += area[i] * least_pressure_[i];
    return sum / least_pressure_force_;
}

Surface SurfaceModel::surface() const {
    const ContactPoints& points = compliance_->points();
    Surface s;
    s.layout = Surface::Layout::grid;
    s.n_x = points.n_x;
    s.n_y = points.n_y;
    s.first = points.first;
    s.spacing = points.spacing;
    s.offset = offset_;
    s.normal_traction = normal_->pressure;
    s.tangential_traction_x = tangential_.traction.x;
    s.tangential_traction_y = tangential_.traction.y;
    s.friction_bound = bound_;
    s.displacement_x = tangential_.displacement.x;
    s.displacement_y = tangential_.displacement.y;
    s.displacement_z = normal_->displacement;
    s.gap = heights_over(points, *indenter_, offset_);
    s.slip_x = slip_.x;
    s.slip_y = slip_.y;
    s.dissipation.resize(bound_.size());
    for (std::size_t i = 0; i < bound_.size(); ++i) {
        s.gap[i] += normal_->displacement[i] - normal_->indentation;
        s.dissipation[i] =
            tangential_.traction.x[i] * slip_.x[i] + tangential_.traction.y[i] * slip_.y[i];
    }
    s.contact_state = contact_state_;
    return s;
}

}  // namespace tricontact::contact
