#include "mdr/relaxing_bed.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "contact/base/compensated_sum.h"
#include "contact/base/error.h"

namespace tricontact::mdr {

using contact::LoadStep;
using contact::NormalControl;
using contact::TangentialControl;

namespace {

const contact::Relaxation& relaxation_of(const BedData& data) {
    if (!data.relaxation) throw contact::InputError("mdr: a relaxing bed needs a relaxation");
    return *data.relaxation;
}

Window hull(const Window& a, const Window& b) {
    if (a.size() == 0) return b;
    if (b.size() == 0) return a;
    return {std::min(a.first, b.first), std::max(a.last, b.last)};
}

}  // namespace

RelaxingBed::RelaxingBed(BedData data)
    : Bed(data),
      normal_(relaxation_of(data), data.n_springs),
      tangential_(relaxation_of(data), data.n_springs) {
    profile_ = std::move(data.profile);
    row_.spacing = 2 * data.half_length / data.n_springs;
    row_.first = row_.spacing / 2 - data.half_length;
    for (auto* field : {&heights_, &pressed_, &offsets_, &bounds_, &sheared_, &force_,
                        &shear_before_, &least_load_})
        field->assign(data.n_springs, 0);
    if (law_->coulomb()) return;
    load_bound_.emplace(law_, true);
    line_bounds_.assign(data.n_springs, 0);
}

contact::StepRecord RelaxingBed::advance(const LoadStep& step) {
    const double position = position_on_line(name(), step, direction_, row_.spacing);
    if (!(step.duration >= 0))
        throw contact::InputError(
            fmt::format("mdr: a step of {:.6g} s; time must not go backwards", step.duration));
    const double position_before = depth_ > 0 ? position_ : position, depth_before = depth_;
    normal_.begin(step.duration, touched_);
    tangential_.begin(step.duration, touched_);
    const int normal_iterations = press(position, step.normal);
    carried_.clear();
    if (step.in_proportion) find_carried(position_before, depth_before);
    push(normal_.stiffness());
    update_line_bounds();
    friction_ = step.friction;
    update_offsets();
    const ShiftSolution shift = find_shift_increment(step.tangential[0]);
    const SlipSums sums = slide(shift.increment);
    update_limit();
    audit_step(step, sums);

    const double dk = effective_modulus_ * row_.spacing;
    const double dk_x = effective_shear_modulus_ * row_.spacing;
    contact::StepRecord result =
        record(step, shift, depth_, row_.spacing,
               {static_cast<double>(size()), n_contact_, std::min(sums.n_stick, n_contact_)},
               friction_ && n_contact_ > 0);
    result.dissipation = dk_x * tangential_.stiffness() * sums.dissipated;
    result.material_dissipation = dk * pressing_.dissipated + dk_x * shearing_.dissipated;
    result.stored_energy = dk * stored_in_pressing_ + dk_x * stored_in_shearing_;
    result.normal_iterations = normal_iterations;
    return result;
}

int RelaxingBed::press(double position, const NormalControl& control) {
    check_positive(control);
    position_ = position;
    const double stiffness = effective_modulus_ * row_.spacing * normal_.stiffness();
    int iterations = 0;
    for (;;) {
        sample_heights();
        if (control.kind == NormalControl::Kind::force)
            iterations += press_to_sum(control.value / stiffness);
        else
            depth_ = control.value;
        find_contact();
        if (n_contact_ == 0 || (contact_.first > 0 && contact_.last < size())) break;
        grow();
    }
    check_rim(*profile_, depth_);
    return iterations;
}

void RelaxingBed::sample_heights() {
    profile_->sample(row_.first - position_, row_.spacing, heights_);
    const double* const free = normal_.free_deflection().data();
    double* const height = heights_.data();
#pragma omp simd
    for (int i = touched_.first; i < touched_.last; ++i) height[i] += free[i];
}

/// The depth at which the springs are pressed by `sum` [m] in all: Newton's method on a convex,
/// piecewise linear function. Springs below a depth include those below a lesser one, so that the
/// same number of them means the same springs.
int RelaxingBed::press_to_sum(double sum) {
    const int n = size();
    const double* const height = heights_.data();
    double n_before = 0;
    for (int iteration = 1; iteration <= n + 2; ++iteration) {
        contact::CompensatedSum all_heights;
        double n_below = 0;
        const double depth = depth_;
        contact::for_each_block(0, n, [&](int begin, int end) {
            double heights = 0;
#pragma omp simd reduction(+ : heights, n_below)
            for (int i = begin; i < end; ++i) {
                heights += height[i] < depth ? height[i] : 0.;
                n_below += height[i] < depth ? 1. : 0.;
            }
            all_heights.add(heights);
        });
        if (n_below > 0 && n_below == n_before) return iteration;
        n_before = n_below;
        if (n_below > 0)
            depth_ = (sum + all_heights.value()) / n_below;
        else
            depth_ = 2 * *std::min_element(heights_.begin(), heights_.end()) + sum;
    }
    throw contact::NotConverged(fmt::format(
        "spring bed: normal force not found after {} Newton steps, {} springs in contact", n + 2,
        n_before));
}

void RelaxingBed::find_contact() {
    const double depth = depth_;
    const double* const height = heights_.data();
    double* const pressed = pressed_.data();
    double n_contact = 0;
    const int n = size();
#pragma omp simd reduction(+ : n_contact)
    for (int i = 0; i < n; ++i) {
        pressed[i] = std::max(depth - height[i], 0.);
        n_contact += pressed[i] > 0 ? 1. : 0.;
    }
    n_contact_ = n_contact;
    contact_ = {0, 0};
    if (n_contact == 0) return;
    contact_.last = n;
    while (!(pressed[contact_.first] > 0)) ++contact_.first;
    while (!(pressed[contact_.last - 1] > 0)) --contact_.last;
}

void RelaxingBed::grow() {
    const int n = more_springs(size());
    for (auto* field : {&heights_, &pressed_, &offsets_, &bounds_, &sheared_, &force_,
                        &shear_before_, &least_load_})
        pad(*field, n);
    if (load_bound_) pad(line_bounds_, n);
    normal_.grow(n);
    tangential_.grow(n);
    row_.first -= n * row_.spacing;
    touched_ = {touched_.first + n, touched_.last + n};
}

/// Ends the springs' normal step.
void RelaxingBed::push(double stiffness) {
    touched_ = hull(touched_, contact_);
    const double* const pressed = pressed_.data();
    double* const force = force_.data();
    contact::CompensatedSum all;
    contact::for_each_block(touched_.first, touched_.last, [&](int begin, int end) {
        double sum = 0;
#pragma omp simd reduction(+ : sum)
        for (int i = begin; i < end; ++i) {
            force[i] = stiffness * pressed[i];
            sum += force[i];
        }
        all.add(sum);
    });
    normal_force_ = effective_modulus_ * row_.spacing * all.value();
    pressing_ = normal_.end(touched_, force_);
}

/// As SpringBed::find_carried(), over springs that may move by themselves. Before the step ends:
/// deflections are still those of its start.
void RelaxingBed::find_carried(double position_before, double depth_before) {
    const double* const before = normal_.deflection().data();
    carried_.assign(contact_.size(), 1);
    for (int k = 0; k < contact_.size(); ++k) {
        const int i = contact_.first + k;
        if (!(pressed_[i] > 0)) continue;
        const double x = std::abs(row_.position(i) - position_before);
        const double gap =
            profile_->value(std::min(x, profile_->range())) + before[i] - depth_before;
        if (gap > rounding * depth_) carried_[k] = pressed_[i] / (gap + pressed_[i]);
    }
}

/// Of the pushed springs; where nothing touches the largest bound is the last one.
void RelaxingBed::update_line_bounds() {
    if (!load_bound_) {
        largest_bound_ = bound_ratio_ * depth_;
        return;
    }
    std::fill(line_bounds_.begin(), line_bounds_.end(), 0);
    total_bound_ = 0;
    if (n_contact_ == 0) return;
    std::vector<double> load(contact_.size());
    for (int k = 0; k < contact_.size(); ++k)
        load[k] = effective_modulus_ * force_[contact_.first + k];
    const auto bound = part(line_bounds_, contact_);
    load_bound_->bounds({row_.position(contact_.first), row_.spacing}, load, bound);
    const double* const one = bound.data();
    double sum = 0, largest = 0;
#pragma omp simd reduction(+ : sum) reduction(max : largest)
    for (int k = 0; k < contact_.size(); ++k) {
        sum += one[k];
        largest = std::max(largest, one[k]);
    }
    total_bound_ = row_.spacing * sum;
    largest_bound_ = largest / (effective_shear_modulus_ * tangential_.stiffness());
}

// Beside their free ends the springs are an elastic bed of another stiffness, with the same bounds.
void RelaxingBed::update_offsets() {
    const double ratio = !friction_    ? 0
                         : load_bound_ ? 1 / (effective_shear_modulus_ * tangential_.stiffness())
                                       : bound_ratio_;
    const double* const u = tangential_.deflection().data();
    const double* const free = tangential_.free_deflection().data();
    const double* const carrying = load_bound_ ? line_bounds_.data() : pressed_.data();
    double* const before = shear_before_.data();
    double* const offset = offsets_.data();
    double* const bound = bounds_.data();
#pragma omp simd
    for (int i = touched_.first; i < touched_.last; ++i) {
        before[i] = u[i];
        offset[i] = u[i] - free[i];
        bound[i] = ratio * carrying[i];
    }
}

ShiftSolution RelaxingBed::find_shift_increment(const TangentialControl& control) {
    if (control.kind == TangentialControl::Kind::shift) return {control.value - shift_, 0, 0};
    if (!friction_ || (n_contact_ == 0 && control.value == 0)) return {};
    check_carried(control);
    const auto offsets = part(offsets_, contact_), bounds = part(bounds_, contact_);
    const double stiffness = effective_shear_modulus_ * row_.spacing * tangential_.stiffness();
    const double target = control.value / stiffness;
    if (!carried_.empty()) return find_increment(offsets, bounds, carried_, target);
    double farthest = 0;
    for (std::size_t i = 0; i < bounds.size(); ++i)
        farthest = std::max(farthest, std::abs(offsets[i]) + bounds[i]);
    return find_increment(offsets, bounds, target, farthest);
}

SlipSums RelaxingBed::slide(double increment) {
    const auto all = part(sheared_, touched_);
    std::fill(all.begin(), all.end(), 0);
    const auto offsets = part(std::as_const(offsets_), contact_);
    const auto bounds = part(std::as_const(bounds_), contact_);
    const auto sheared = part(sheared_, contact_);
    const double negligible = negligible_slip(largest_bound_);
    SlipSums sums = carried_.empty()
                        ? take_step(offsets, bounds, increment, negligible, sheared)
                        : take_step(offsets, bounds, carried_, increment, negligible, sheared);
    const double stiffness = tangential_.stiffness();
    for (int i = touched_.first; i < touched_.last; ++i) force_[i] = stiffness * sheared_[i];
    shearing_ = tangential_.end(touched_, force_);
    shift_increment_ = increment;
    shift_ += increment;
    tangential_force_ = effective_shear_modulus_ * row_.spacing * stiffness * sums.deflection;
    if (n_contact_ == contact_.size()) return sums;
    for (int i = contact_.first; i < contact_.last; ++i)  // gaps inside do not stick
        if (!(pressed_[i] > 0) && std::abs(slip(i)) <= negligible_slip(largest_bound_))
            --sums.n_stick;
    return sums;
}

void RelaxingBed::release() {
    normal_.forget();
    tangential_.forget();
    touched_ = contact_ = {};
    for (auto* field :
         {&pressed_, &bounds_, &sheared_, &offsets_, &shear_before_, &least_load_, &line_bounds_})
        std::fill(field->begin(), field->end(), 0);
    depth_ = position_ = n_contact_ = 0;
    normal_force_ = tangential_force_ = total_bound_ = 0;
    shift_ = shift_increment_ = stored_in_pressing_ = stored_in_shearing_ = 0;
}

void RelaxingBed::update_limit() {
    const double factor = load_bound_ ? 1 / effective_modulus_ : normal_.stiffness();
    const double* const carrying = load_bound_ ? line_bounds_.data() : pressed_.data();
    double* const least = least_load_.data();
    const int n = size();
#pragma omp simd
    for (int i = 0; i < n; ++i) least[i] = std::min(least[i], factor * carrying[i]);
}

double RelaxingBed::limit_tangential_ratio() const {
    contact::CompensatedSum sum;
    for (const double load : least_load_) sum.add(load);
    return effective_modulus_ * row_.spacing * sum.value() /
           (load_bound_ ? limit_total_bound_ : limit_normal_force_);
}

}  // namespace tricontact::mdr
