#include "mdr/spring_bed.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "contact/compensated_sum.h"
#include "mdr/line_surface.h"
#include "mdr/tangential_step.h"

namespace tricontact::mdr {

using contact::ContactState;
using contact::Surface;

namespace {

/// Even line loads on 0 = x_0 < x_1 < ... < a, for the back-transformation.
struct EvenLoads {
    std::vector<double> positions, normal, tangential;
};

EvenLoads even_loads(const NormalBed& bed, const std::vector<double>& deflections,
                     double effective_modulus, double effective_shear_modulus) {
    const double a = bed.profile().half_width(bed.depth());
    const int n = std::clamp(static_cast<int>(a / bed.spacing()), 2, most_surface_pieces);
    const PointRow row{bed.spring_position(0), bed.spacing()};
    EvenLoads loads;
    for (int k = 0; k < n; ++k) {
        const double x = a * k / n;
        loads.positions.push_back(x);
        loads.normal.push_back(effective_modulus * (bed.depth() - bed.profile().value(x)));
        loads.tangential.push_back(effective_shear_modulus *
                                   row.even(deflections, bed.position(), x));
    }
    loads.positions.push_back(a);
    loads.normal.push_back(0);
    loads.tangential.push_back(0);
    return loads;
}

}  // namespace

using contact::LoadStep;
using contact::NormalControl;
using contact::TangentialControl;

SpringBed::SpringBed(BedData data)
    : effective_modulus_(checked(data).effective_modulus),
      effective_shear_modulus_(data.effective_shear_modulus),
      friction_coefficient_(data.friction_coefficient),
      direction_{std::cos(data.rolling_angle), std::sin(data.rolling_angle)},
      bound_ratio_(friction_coefficient_ * effective_modulus_ / effective_shear_modulus_),
      normal_(std::move(data.profile), data.n_springs, data.half_length),
      deflections_(data.n_springs),
      deflections_before_(data.n_springs),
      bounds_(data.n_springs),
      least_bounds_(data.n_springs) {}

contact::StepRecord SpringBed::advance(const LoadStep& step) {
    check_on_line(name(), step);
    const double force_before = tangential_force_;
    depth_before_ = normal_.depth();
    normal_force_before_ = normal_force_;
    contact_before_ = normal_.contact();
    const int normal_iterations =
        press(line_coordinate(name(), step.offset, direction_, normal_.spacing()), step.normal);
    update_bounds();
    const ShiftSolution shift = find_shift_increment(step.tangential[0]);
    const SlipSums sums = slide(shift.increment);
    update_limit();
    audit_step(step, sums, force_before);

    contact::StepRecord result = record(step, sums);
    result.normal_iterations = normal_iterations;
    result.tangential_iterations = shift.iterations;
    result.tangential_residual = shift.residual;
    return result;
}

int SpringBed::press(double position, const NormalControl& control) {
    const bool by_force = control.kind == NormalControl::Kind::force;
    check_positive(control);
    const double dk = effective_modulus_ * normal_.spacing();
    int iterations = 0;
    for (;;) {
        if (by_force)
            iterations += normal_.press_to_sum(position, control.value / dk);
        else
            normal_.press_to_depth(position, control.value);
        if (!normal_.touches_end()) break;
        grow();
    }
    if (normal_.depth() > normal_.profile().value(normal_.profile().range()))
        normal_.profile().half_width(normal_.depth());  // throws: the rim is reached
    return iterations;
}

void SpringBed::grow() {
    const int n = std::max(16, normal_.size() / 4);
    normal_.grow(n);
    auto pad = [n](std::vector<double>& values) {
        values.insert(values.begin(), n, 0);
        values.insert(values.end(), n, 0);
    };
    pad(deflections_);
    pad(deflections_before_);
    pad(bounds_);
    pad(least_bounds_);
    for (Window* window : {&contact_before_, &least_contact_}) {
        window->first += n;
        window->last += n;
    }
}

void SpringBed::release() {
    std::fill(deflections_.begin(), deflections_.end(), 0);
    tangential_force_ = 0;
    shift_ = shift_increment_ = 0;
}

// Slip cap mu q_z/(G* dx) of each spring, and the normal force that it belongs to.
void SpringBed::update_bounds() {
    const auto heights = normal_.heights();
    const double* const height = heights.data();
    double* const bound = part(bounds_, normal_.contact()).data();
    const double depth = normal_.depth(), ratio = bound_ratio_;
    contact::CompensatedSum all_penetrations, all_squares;
    contact::for_each_block(0, static_cast<int>(heights.size()), [&](int begin, int end) {
        double penetrations = 0, squares = 0;
#pragma omp simd reduction(+ : penetrations, squares)
        for (int i = begin; i < end; ++i) {
            const double penetration = depth - height[i];
            penetrations += penetration;
            squares += penetration * penetration;
            bound[i] = ratio * penetration;
        }
        all_penetrations.add(penetrations);
        all_squares.add(squares);
    });
    normal_force_ = effective_modulus_ * normal_.spacing() * all_penetrations.value();
    normal_energy_ = effective_modulus_ * normal_.spacing() * all_squares.value() / 2;
}

ShiftSolution SpringBed::find_shift_increment(const TangentialControl& control) const {
    if (control.kind == TangentialControl::Kind::shift) return {control.value - shift_, 0, 0};
    check_carried(control, friction_coefficient_ * normal_force_);
    const Window& contact = normal_.contact();
    const double target = control.value / (effective_shear_modulus_ * normal_.spacing());
    // Everything slides at the latest after the largest old and the largest new bound.
    const double farthest = bound_ratio_ * (depth_before_ + normal_.depth());
    return find_increment(part(deflections_, contact), part(bounds_, contact), target, farthest);
}

SlipSums SpringBed::slide(double increment) {
    const Window& contact = normal_.contact();
    std::swap(deflections_, deflections_before_);
    std::fill(deflections_.begin(), deflections_.end(), 0);
    const auto before = part(std::as_const(deflections_before_), contact);
    SlipSums sums = take_step(before, part(std::as_const(bounds_), contact), increment,
                              negligible_slip(), part(deflections_, contact));
    unload(contact_before_.first, std::min(contact_before_.last, contact.first), increment, sums);
    unload(std::max(contact_before_.first, contact.last), contact_before_.last, increment, sums);

    shift_increment_ = increment;
    shift_ += increment;
    tangential_force_ = effective_shear_modulus_ * normal_.spacing() * sums.deflection;
    return sums;
}

// Springs that have left the contact lose their load: no work at the end of the step, but energy.
void SpringBed::unload(int first, int last, double increment, SlipSums& sums) const {
    contact::CompensatedSum trapezoidal, stored;
    for (int i = first; i < last; ++i) {
        const double before = deflections_before_[i];
        trapezoidal.add(before * (increment + before) / 2);
        stored.add(-before * before / 2);
    }
    sums.trapezoidal += trapezoidal.value();
    sums.stored += stored.value();
}

void SpringBed::start_limit() {
    least_contact_ = normal_.contact();
    least_bounds_ = bounds_;
    limit_normal_force_ = normal_force_;
}

void SpringBed::update_limit() {
    least_contact_ = intersection(least_contact_, normal_.contact());
    const auto bounds = part(std::as_const(bounds_), least_contact_);
    const auto least = part(least_bounds_, least_contact_);
    const int n = static_cast<int>(bounds.size());
    const double* const bound = bounds.data();
    double* const lowest = least.data();
#pragma omp simd
    for (int i = 0; i < n; ++i) lowest[i] = std::min(lowest[i], bound[i]);
}

double SpringBed::limit_tangential_ratio() const {
    contact::CompensatedSum sum;
    for (const double bound : part(least_bounds_, least_contact_)) sum.add(bound);
    return effective_shear_modulus_ * normal_.spacing() * sum.value() /
           (friction_coefficient_ * limit_normal_force_);
}

void SpringBed::audit_step(const LoadStep& step, const SlipSums& sums, double force_before) {
    const double peak_bound = bound_ratio_ * normal_.depth();
    const double friction_limit = friction_coefficient_ * normal_force_;
    const double stiffness = effective_shear_modulus_ * normal_.spacing();
    const auto bounds = part(std::as_const(bounds_), normal_.contact());
    // The least bounds are at the rim.
    const double least_bound = std::min(bounds.front(), bounds.back());
    audit_.record("pressure_nonnegative", -least_bound / peak_bound, 0);
    audit_.record("friction_bound", sums.bound_excess / peak_bound, 0);
    audit_.record("slip_along_traction", -sums.lowest_work / (peak_bound * peak_bound), 0);
    if (step.normal.kind == NormalControl::Kind::force)
        audit_.record("normal_force", std::abs(normal_force_ / step.normal.value - 1), rounding);
    const TangentialControl& control = step.tangential[0];
    if (control.kind == TangentialControl::Kind::force)
        audit_.record("tangential_force",
                      std::abs(tangential_force_ - control.value) / friction_limit, rounding);
    // Spring by spring, 1/2 (q + q_before) (increment - slip) = change of q^2/(2 k): summed up, the
    // work of the shift equals stored energy and frictional work, exactly.
    // Rounding: let L be the larger friction limit of before and after the step, b the largest
    // bound or the increment. As |u| stays within the bounds, the magnitudes of the terms add up to
    // no more than 2 L b of work, 4 L b of slip and L b of what is stored.
    const double work = shift_increment_ * (tangential_force_ + force_before) / 2;
    const double used = stiffness * (sums.stored + sums.trapezoidal);
    const double largest_limit =
        friction_coefficient_ * std::max(normal_force_, normal_force_before_);
    const double farthest = std::max(bound_ratio_ * std::max(normal_.depth(), depth_before_),
                                     std::abs(shift_increment_));
    audit_.record("energy_balance", std::abs(work - used) / (largest_limit * farthest), rounding);
}

contact::StepRecord SpringBed::record(const LoadStep& step, const SlipSums& sums) const {
    const double dx = normal_.spacing();
    auto disc = [dx](double n_springs) {
        return std::numbers::pi / 4 * n_springs * n_springs * dx * dx;
    };
    contact::StepRecord r;
    r.phase = step.phase;
    r.offset = step.offset;
    r.normal_force = normal_force_;
    r.tangential_force = {tangential_force_, 0};
    r.indentation = normal_.depth();
    r.shift = {shift_, 0};
    r.dissipation = effective_shear_modulus_ * dx * sums.dissipated;
    r.stored_energy = normal_energy_ + effective_shear_modulus_ * dx * sums.energy;
    r.contact_area = disc(normal_.contact().size());
    r.stick_area = disc(sums.n_stick);
    r.slip_area = r.contact_area - r.stick_area;
    r.open_area = disc(normal_.size()) - r.contact_area;
    if (step.normal.kind == NormalControl::Kind::force)
        r.normal_residual = std::abs(normal_force_ / step.normal.value - 1);
    r.force_residual = r.normal_residual;
    const TangentialControl& control = step.tangential[0];
    if (control.kind == TangentialControl::Kind::force)
        r.force_residual = std::max(r.force_residual, std::abs(tangential_force_ - control.value) /
                                                          (friction_coefficient_ * normal_force_));
    return r;
}

contact::Scales SpringBed::scales() const {
    const double a = normal_.profile().half_width(normal_.depth());
    return {.normal_force = normal_force_,
            .contact_radius = a,
            .indentation = normal_.depth(),
            .peak_pressure =
                effective_modulus_ / std::numbers::pi * normal_.profile().centre_integral(a),
            .unit_shift = bound_ratio_ * normal_.depth()};
}

Surface SpringBed::surface() const {
    const int stride = (normal_.size() + most_surface_points - 1) / most_surface_points;
    Surface s;
    s.layout = Surface::Layout::line;
    s.n_x = (normal_.size() - 1) / stride + 1;
    s.n_y = 1;
    s.first = {normal_.spring_position(0), 0};
    s.spacing = {stride * normal_.spacing(), 0};
    s.offset = {normal_.position(), 0};
    resize_fields(s);
    const EvenLoads loads =
        even_loads(normal_, deflections_, effective_modulus_, effective_shear_modulus_);
    for (int k = 0; k < s.n_x; ++k) {
        const double r = std::abs(s.x(k) - normal_.position());
        const std::vector<double> weights = abel_weights(loads.positions, r);
        s.normal_traction[k] = back_transform(loads.positions, loads.normal, weights);
        s.tangential_traction_x[k] = back_transform(loads.positions, loads.tangential, weights);
        s.friction_bound[k] = friction_coefficient_ * s.normal_traction[k];
        set_spring_fields(k * stride, k, s);
    }
    return s;
}

void SpringBed::set_spring_fields(int spring, int point, Surface& s) const {
    const PlaneProfile& profile = normal_.profile();
    const double x = s.x(point) - normal_.position();
    const double gap = profile.value(std::min(std::abs(x), profile.range())) - normal_.depth();
    s.contact_state[point] = contact_state(spring);
    if (s.contact_state[point] == ContactState::open) {
        s.gap[point] = std::max(gap, 0.);
        return;
    }
    s.displacement_x[point] = deflections_[spring];
    s.displacement_z[point] = std::max(-gap, 0.);
    s.normal_line_load[point] = effective_modulus_ * s.displacement_z[point];
    s.tangential_line_load[point] = effective_shear_modulus_ * s.displacement_x[point];
    s.slip_x[point] = s.contact_state[point] == ContactState::slip ? slip(spring) : 0;
    s.dissipation[point] = std::abs(s.tangential_traction_x[point] * s.slip_x[point]);
}

double SpringBed::slip(int spring) const {
    return shift_increment_ - (deflections_[spring] - deflections_before_[spring]);
}

ContactState SpringBed::contact_state(int spring) const {
    if (spring < normal_.contact().first || spring >= normal_.contact().last)
        return ContactState::open;
    return std::abs(slip(spring)) > negligible_slip() ? ContactState::slip : ContactState::stick;
}

std::vector<ContactState> SpringBed::contact_states() const {
    std::vector<ContactState> states;
    states.reserve(normal_.size());
    for (int i = 0; i < normal_.size(); ++i) states.push_back(contact_state(i));
    return states;
}

}  // namespace tricontact::mdr
