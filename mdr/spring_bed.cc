#include "mdr/spring_bed.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "contact/base/compensated_sum.h"
#include "mdr/line_surface.h"

namespace tricontact::mdr {

using contact::ContactState;
using contact::Surface;

namespace {

EvenLoads loads_of(const NormalBed& bed, const std::vector<double>& deflections,
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
    : Bed(data),
      wearing_body_(data.wearing_body),
      normal_(std::move(data.profile), data.n_springs, data.half_length),
      deflections_(data.n_springs),
      deflections_before_(data.n_springs),
      bounds_(data.n_springs),
      least_bounds_(data.n_springs) {
    if (!law_->coulomb()) line_bound_.emplace(law_, effective_modulus_, effective_shear_modulus_);
}

contact::StepRecord SpringBed::advance(const LoadStep& step) {
    const double position = position_on_line(name(), step, direction_, normal_.spacing());
    const double force_before = tangential_force_, position_before = normal_.position();
    depth_before_ = normal_.depth();
    normal_force_before_ = normal_force_;
    largest_bound_before_ = largest_bound_;
    total_bound_before_ = total_bound_;
    contact_before_ = normal_.contact();
    const int normal_iterations = press(position, step.normal);
    if (step.in_proportion) bounds_before_ = bounds_;
    if (is_fresh_) contact_before_ = {};
    update_bounds();
    carried_.clear();
    if (step.in_proportion) find_carried(is_fresh_ ? position : position_before);
    is_fresh_ = false;
    const ShiftSolution shift = find_shift_increment(step.tangential[0]);
    const SlipSums sums = slide(shift.increment);
    update_limit();
    audit_step(step, sums, force_before);

    const double dk_x = effective_shear_modulus_ * normal_.spacing();
    const double n = normal_.size(), n_contact = normal_.contact().size();
    contact::StepRecord result =
        record(step, shift, normal_.depth(), normal_.spacing(), {n, n_contact, sums.n_stick}, true);
    result.dissipation = dk_x * (step.in_proportion ? work_between() : sums.dissipated);
    result.stored_energy = normal_energy_ + dk_x * sums.energy;
    result.normal_iterations = normal_iterations;
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
    check_rim(normal_.profile(), normal_.depth());
    return iterations;
}

void SpringBed::grow() {
    const int n = more_springs(normal_.size());
    normal_.grow(n);
    for (auto* field : {&deflections_, &deflections_before_, &bounds_, &least_bounds_})
        pad(*field, n);
    for (Window* window : {&contact_before_, &least_contact_}) {
        window->first += n;
        window->last += n;
    }
}

/// The normal force, and what friction carries at it.
void SpringBed::update_bounds() {
    if (line_bound_) {
        add_up_loads([](int, double) {});
        update_other_bounds();
        return;
    }
    // Slip cap mu q_z/(G* dx) of each spring.
    double* const bound = part(bounds_, normal_.contact()).data();
    const double ratio = bound_ratio_;
    add_up_loads([=](int i, double penetration) { bound[i] = ratio * penetration; });
    largest_bound_ = ratio * normal_.depth();
}

template <class Visit>
void SpringBed::add_up_loads(Visit visit) {
    const auto heights = normal_.heights();
    const double* const height = heights.data();
    const double depth = normal_.depth();
    contact::CompensatedSum all_penetrations, all_squares;
    contact::for_each_block(0, static_cast<int>(heights.size()), [&](int begin, int end) {
        double penetrations = 0, squares = 0;
#pragma omp simd reduction(+ : penetrations, squares)
        for (int i = begin; i < end; ++i) {
            const double penetration = depth - height[i];
            penetrations += penetration;
            squares += penetration * penetration;
            visit(i, penetration);
        }
        all_penetrations.add(penetrations);
        all_squares.add(squares);
    });
    normal_force_ = effective_modulus_ * normal_.spacing() * all_penetrations.value();
    normal_energy_ = effective_modulus_ * normal_.spacing() * all_squares.value() / 2;
}

void SpringBed::update_other_bounds() {
    const Window& contact = normal_.contact();
    line_bound_->press(normal_.profile(), normal_.depth());
    line_bound_->sample(normal_.spring_position(contact.first) - normal_.position(),
                        normal_.spacing(), part(bounds_, contact));
    largest_bound_ = line_bound_->largest();
    const double* const bound = part(std::as_const(bounds_), contact).data();
    contact::CompensatedSum all;
    contact::for_each_block(0, contact.size(), [&](int begin, int end) {
        double sum = 0;
#pragma omp simd reduction(+ : sum)
        for (int i = begin; i < end; ++i) sum += bound[i];
        all.add(sum);
    });
    total_bound_ = effective_shear_modulus_ * normal_.spacing() * all.value();
}

/// Depth and position change linearly: the gap over a spring does, too, and closes when the share
/// gap/(gap + penetration) of the step is over.
void SpringBed::find_carried(double position_before) {
    const Window& contact = normal_.contact();
    const auto heights = normal_.heights();
    const PlaneProfile& profile = normal_.profile();
    const double depth_before = is_fresh_ ? 0 : depth_before_;
    carried_.assign(contact.size(), 1);
    for (int k = 0; k < contact.size(); ++k) {
        const int i = contact.first + k;
        if (!is_fresh_ && i >= contact_before_.first && i < contact_before_.last) continue;
        const double x = std::abs(normal_.spring_position(i) - position_before);
        const double gap = profile.value(std::min(x, profile.range())) - depth_before;
        const double penetration = normal_.depth() - heights[k];
        if (gap > 0) carried_[k] = penetration / (gap + penetration);
    }
}

ShiftSolution SpringBed::find_shift_increment(const TangentialControl& control) const {
    if (control.kind == TangentialControl::Kind::shift) return {control.value - shift_, 0, 0};
    check_carried(control);
    const Window& contact = normal_.contact();
    const double target = control.value / (effective_shear_modulus_ * normal_.spacing());
    if (!carried_.empty())
        return find_increment(part(deflections_, contact), part(bounds_, contact), carried_,
                              target);
    // Everything slides at the latest after the largest old and the largest new bound.
    const double farthest = largest_bound_before_ + largest_bound_;
    return find_increment(part(deflections_, contact), part(bounds_, contact), target, farthest);
}

SlipSums SpringBed::slide(double increment) {
    const Window& contact = normal_.contact();
    std::swap(deflections_, deflections_before_);
    std::fill(deflections_.begin(), deflections_.end(), 0);
    const auto before = part(std::as_const(deflections_before_), contact);
    const auto bounds = part(std::as_const(bounds_), contact);
    const double negligible = negligible_slip(largest_bound_);
    SlipSums sums = carried_.empty() ? take_step(before, bounds, increment, negligible,
                                                 part(deflections_, contact))
                                     : take_step(before, bounds, carried_, increment, negligible,
                                                 part(deflections_, contact));
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

/// Frictional work over the stiffness [m^2] where depth and shift change linearly: a spring slips
/// under the mean of its bounds where slip begins and at the end of the step. Of constant bounds
/// that is the bound; the first touch and F_N that changes are of the second order in the step.
double SpringBed::work_between() const {
    const Window& now = normal_.contact();
    const int left = std::min(contact_before_.last, now.first),
              right = std::max(contact_before_.first, now.last);
    return work_between(contact_before_.first, left) + work_between(now.first, now.last) +
           work_between(right, contact_before_.last);
}

double SpringBed::work_between(int first, int last) const {
    const Window& now = normal_.contact();
    contact::CompensatedSum work;
    for (int i = first; i < last; ++i) {
        const bool touches = i >= now.first && i < now.last;
        const bool touched = i >= contact_before_.first && i < contact_before_.last;
        const double after = touches ? bounds_[i] : 0, before = touched ? bounds_before_[i] : 0;
        const double carried = touches && !carried_.empty() ? carried_[i - now.first] : 1;
        // As the step was taken: exactly 0 where the spring sticks.
        const double slip = deflections_before_[i] + carried * shift_increment_ - deflections_[i];
        if (slip == 0) continue;
        // Of the step's way, u and bound changing linearly: what has passed when it slips.
        const double along = slip > 0 ? deflections_before_[i] : -deflections_before_[i];
        const double to_bound = std::max(0., before - along);
        const double at_slip = std::lerp(before, after, to_bound / (to_bound + std::abs(slip)));
        work.add(std::abs(slip) * (at_slip + after) / 2);
    }
    return work.value();
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
           law_->limit({limit_normal_force_, limit_total_bound_});
}

void SpringBed::audit_step(const LoadStep& step, const SlipSums& sums, double force_before) {
    const double stiffness = effective_shear_modulus_ * normal_.spacing();
    const auto bounds = part(std::as_const(bounds_), normal_.contact());
    // The least bounds are at the rim.
    const double least_bound = std::min(bounds.front(), bounds.back());
    audit_.record("pressure_nonnegative", -least_bound / largest_bound_, 0);
    audit_forces(step, sums, largest_bound_, true);
    // Spring by spring, 1/2 (q + q_before) (increment - slip) = change of q^2/(2 k): summed up, the
    // work of the shift equals stored energy and frictional work, exactly. What the indenter moved
    // before it met a spring is no work, but in this trapezoidal rule.
    // Rounding: let L be the larger friction limit of before and after the step, b the largest
    // bound or the increment. As |u| stays within the bounds, the magnitudes of the terms add up to
    // no more than 2 L b of work, 4 L b of slip and L b of what is stored.
    const double work = shift_increment_ * (tangential_force_ + force_before) / 2;
    const double used = stiffness * (sums.stored + sums.trapezoidal + sums.unmet);
    const double largest_limit = law_->limit({std::max(normal_force_, normal_force_before_),
                                              std::max(total_bound_, total_bound_before_)});
    const double farthest =
        std::max({largest_bound_, largest_bound_before_, std::abs(shift_increment_)});
    audit_.record("energy_balance", std::abs(work - used) / (largest_limit * farthest), rounding);
}

contact::Scales SpringBed::scales() const {
    const double a = normal_.profile().half_width(normal_.depth());
    return {.normal_force = normal_force_,
            .contact_radius = a,
            .indentation = normal_.depth(),
            .peak_pressure =
                effective_modulus_ / std::numbers::pi * normal_.profile().centre_integral(a),
            .unit_shift = line_bound_ ? line_bound_->at_centre() : largest_bound_,
            .sliding_force = friction_limit()};
}

Surface SpringBed::surface() const {
    return make_line_surface(
        {normal_.spring_position(0), normal_.spacing()}, normal_.size(), normal_.position(), *law_,
        loads_of(normal_, deflections_, effective_modulus_, effective_shear_modulus_),
        [this](int i, int k, Surface& s) { set_spring_fields(i, k, s); }, &weights_);
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
}

}  // namespace tricontact::mdr
