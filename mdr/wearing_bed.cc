#include "mdr/wearing_bed.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "contact/base/error.h"
#include "contact/base/root.h"
#include "contact/base/special_values.h"
#include "contact/models/model_kind.h"
#include "mdr/line_surface.h"
#include "mdr/spring_bed.h"
#include "mdr/worn_kernels.h"

namespace tricontact::mdr {

using contact::NormalControl;
using contact::TangentialControl;
using std::numbers::pi;

namespace {

constexpr double first_reach = 1.05;  // of the nodes, over where the body is d high
constexpr std::size_t n_within = 40;  // points within c

/// Of the cycle's drive [m], [N].
double half_range(const contact::WearProblem& problem) {
    double low = contact::infinity, high = -contact::infinity;
    for (std::size_t k = problem.n_before - 1; k < problem.steps.size(); ++k) {
        low = std::min(low, problem.steps[k].tangential[0].value);
        high = std::max(high, problem.steps[k].tangential[0].value);
    }
    return (high - low) / 2;
}

Eigen::Map<const Eigen::VectorXd> as_vector(const std::vector<double>& field, std::size_t first) {
    return {field.data() + first, static_cast<Eigen::Index>(field.size() - first)};
}

}  // namespace

WearingBed::WearingBed(WearingBedData data, contact::WearProblem problem)
    : WornRings(contact::models::mdr, std::move(problem), data.friction),
      data_(std::move(data)),
      drive_(half_range(problem_)) {
    const contact::LoadStep& last = problem_.steps.back();
    const auto& body = *data_.indenter;
    const bool by_depth = last.normal.kind == NormalControl::Kind::indentation;
    const auto increasing = [&](const auto& value, double wanted) {
        return *contact::increasing_root([&](double a) { return value(a) - wanted; }, 1e-6,
                                         .999 * body.outer_radius());
    };
    const auto image = [&](double a) { return body.plane_profile(a); };
    radius_0_ = by_depth ? increasing(image, last.normal.value)
                         : increasing([&](double a) { return body.pressed_area(a); },
                                      last.normal.value / data_.effective_modulus);
    const double depth = image(radius_0_);
    if (by_depth && last.tangential[0].kind == TangentialControl::Kind::shift &&
        problem_.rig_compliance == 0) {
        const double ratio = friction_ * data_.effective_modulus / data_.effective_shear_modulus;
        const double beneath = depth - drive_ / ratio;
        if (beneath > 0) stick_ = increasing(image, beneath);
    }
    make_nodes(first_reach * increasing([&](double r) { return body.profile(r); }, depth));
}

void WearingBed::make_nodes(double reach) {
    reach_ = reach;
    spacing_ = radius_0_ / data_.rings_per_radius;
    n_ = static_cast<std::size_t>(
             std::ceil(std::sqrt((reach - stick_) * (reach + stick_)) / spacing_)) +
         1;
    n_inner_ = stick_ > 0 ? n_within : 0;
    radius_.clear();
    for (std::size_t k = 0; k < n_inner_; ++k)
        radius_.push_back(stick_ * static_cast<double>(k) / static_cast<double>(n_inner_));
    for (std::size_t j = 0; j < n_; ++j)
        radius_.push_back(std::hypot(stick_, spacing_ * static_cast<double>(j)));
    // In rho, r dr = rho drho; within c, where nothing wears, 0.
    area_ = areas_of_hats(n_, spacing_);
    area_.insert(area_.begin(), n_inner_, 0);
    unworn_.clear();
    for (std::size_t j = 0; j < n_; ++j)
        unworn_.push_back(data_.indenter->plane_profile(radius_[n_inner_ + j]));
    kernels_ = std::make_shared<const WornKernels>(static_cast<int>(n_), spacing_, stick_);
}

void WearingBed::enlarge(const contact::ContactAtEdge&) {
    const double reach = 1.5 * reach_;
    if (reach > .999 * data_.indenter->outer_radius() || n_ > 4000)
        throw contact::InputError(
            "[wear]: mdr: the worn contact becomes as wide as the body, or its rings too many; "
            "reduce wear.cycles or mdr.springs");
    make_nodes(reach);
}

std::vector<double> WearingBed::plane_profile(const std::vector<double>& worn) const {
    const Eigen::VectorXd added = kernels_->image * as_vector(worn, n_inner_);
    std::vector<double> profile = unworn_;
    for (std::size_t j = 0; j < n_; ++j) profile[j] += added[static_cast<Eigen::Index>(j)];
    return profile;
}

/// F_N at a depth [N].
double WearingBed::force_at(double depth, const std::vector<double>& profile,
                            Pressed* found) const {
    const double modulus = data_.effective_modulus;
    std::vector<double> load(n_);
    for (std::size_t j = 0; j < n_; ++j) load[j] = modulus * std::max(0., depth - profile[j]);
    double force = 0;
    if (stick_ > 0)
        force = modulus * (data_.indenter->pressed_area(stick_) +
                           2 * stick_ * (depth - data_.indenter->plane_profile(stick_)));
    const double* const x = radius_.data() + n_inner_;
    for (std::size_t j = 0; j + 1 < n_; ++j) force += (load[j] + load[j + 1]) * (x[j + 1] - x[j]);
    if (!found) return force;
    if (load.back() > 0)
        throw contact::ContactAtEdge("mdr: the worn contact reaches the last ring");
    std::size_t last = n_ - 1;
    while (last > 0 && load[last] == 0) --last;
    const double in = depth - profile[last], out = depth - profile[last + 1];
    *found = {depth, force, x[last], std::move(load)};
    if (in > 0) found->radius += (x[last + 1] - x[last]) * in / (in - out);
    return force;
}

WearingBed::Pressed WearingBed::press(const std::vector<double>& profile) const {
    const NormalControl& control = problem_.steps.back().normal;
    double depth = control.value;
    if (control.kind == NormalControl::Kind::force)
        depth = *contact::increasing_root(
            [&](double d) { return force_at(d, profile, nullptr) - control.value; }, unworn_.back(),
            contact::infinity);
    Pressed found;
    force_at(depth, profile, &found);
    return found;
}

/// F_T [N] at a shift [m]: springs stick up to their bounds.
double WearingBed::tangential_force(const Pressed& pressed, double shift) const {
    const double held = data_.effective_shear_modulus * shift;
    const auto at = [&](std::size_t j) { return std::min(friction_ * pressed.line_load[j], held); };
    const double* const x = radius_.data() + n_inner_;
    double sum = 2 * stick_ * held;
    for (std::size_t j = 0; j + 1 < n_; ++j) sum += (at(j) + at(j + 1)) * (x[j + 1] - x[j]);
    return sum;
}

/// U_A [m], by the forces of springs that stick up to their bounds where the force is prescribed,
/// or the shift of a drive behind the rig's spring.
double WearingBed::shift_amplitude(const Pressed& pressed) const {
    if (problem_.steps.back().tangential[0].kind == TangentialControl::Kind::shift) {
        const auto excess = [&](double shift) {
            return shift + problem_.rig_compliance * tangential_force(pressed, shift) - drive_;
        };
        return problem_.rig_compliance > 0 ? contact::bracketed_root(excess, 0., drive_) : drive_;
    }
    const auto force = [&](double shift) { return tangential_force(pressed, shift) - drive_; };
    const double most =
        friction_ * *std::ranges::max_element(pressed.line_load) / data_.effective_shear_modulus;
    if (force(most) <= 0)
        throw contact::InputError("[wear]: mdr: the tangential force reaches the friction limit");
    return contact::bracketed_root(force, 0., most);
}

double WearingBed::stick_radius(const Pressed& pressed, double amplitude) const {
    if (stick_ > 0) return stick_;
    const double bound = data_.effective_shear_modulus * amplitude / friction_;
    const auto& q = pressed.line_load;
    if (q[0] <= bound) return 0;
    std::size_t j = 0;
    while (q[j + 1] > bound) ++j;
    return spacing_ * (static_cast<double>(j) + (q[j] - bound) / (q[j] - q[j + 1]));
}

/// Of all points; q jumps at c where what is worn has a vertical slope there.
std::vector<double> WearingBed::pressures(const Pressed& pressed) const {
    const Eigen::VectorXd outside = kernels_->pressure * as_vector(pressed.line_load, 0);
    std::vector<double> all(n_inner_ + n_);
    std::ranges::copy(outside, all.begin() + static_cast<std::ptrdiff_t>(n_inner_));
    if (n_inner_ == 0) return all;
    constexpr double jump_width = 1e-6;  // over c
    std::vector<double> positions(radius_.begin(),
                                  radius_.begin() + static_cast<std::ptrdiff_t>(n_inner_));
    positions.push_back(stick_);
    std::vector<double> load;
    for (const double r : positions)
        load.push_back(data_.effective_modulus *
                       (pressed.depth - data_.indenter->plane_profile(r)));
    positions.push_back(stick_ * (1 + jump_width));
    load.push_back(pressed.line_load[0]);
    for (std::size_t j = 1; j < n_; ++j) {
        positions.push_back(radius_[n_inner_ + j]);
        load.push_back(pressed.line_load[j]);
    }
    const std::vector<double> slopes = slopes_of(positions, load);
    for (std::size_t k = 0; k < n_inner_; ++k)
        all[k] = back_transform(slopes, abel_weights(positions, radius_[k]));
    return all;
}

contact::WornCycle WearingBed::cycle(const std::vector<double>& worn) {
    const Pressed pressed = press(plane_profile(worn));
    const double amplitude = shift_amplitude(pressed);
    const double compliance = friction_ / data_.effective_shear_modulus;
    Eigen::VectorXd path(static_cast<Eigen::Index>(n_));
    for (std::size_t j = 0; j < n_; ++j)
        path[static_cast<Eigen::Index>(j)] =
            4 * std::max(0., amplitude - compliance * pressed.line_load[j]);
    const Eigen::VectorXd slip = kernels_->slip * path;

    contact::WornCycle found;
    found.pressure = pressures(pressed);
    found.slip_path.assign(radius_.size(), 0);
    found.rate = found.slip_path;
    const double factor = wear_factor();
    double pressed_slip = 0;
    for (std::size_t j = 0; j < n_; ++j) {
        const std::size_t i = n_inner_ + j;
        const double s = std::max(0., slip[static_cast<Eigen::Index>(j)]);
        found.slip_path[i] = s;
        const double p = pressed.line_load[j] > 0 ? std::max(0., found.pressure[i]) : 0;
        found.rate[i] = factor * p * s;
        found.volume += area_[i] * found.rate[i];
        pressed_slip += area_[i] * p * s;
    }
    found.work = friction_ * pressed_slip;
    found.volume_by_means = found.volume;
    found.contact_area = pi * pressed.radius * pressed.radius;
    found.stick_area = pi * std::pow(std::min(pressed.radius, stick_radius(pressed, amplitude)), 2);
    found.normal_force = pressed.force;
    found.indentation = pressed.depth;
    found.shift_amplitude = amplitude;
    found.force_amplitude = tangential_force(pressed, amplitude);
    return found;
}

/// w + D B E 1_A (T w) = worn + D B E 1_A (d - g) on the contact A, which follows from w: T, B are
/// the kernels, D = n kappa s. Under a force, w is linear in d, and d follows from F_N.
std::vector<double> WearingBed::jump(const std::vector<double>& worn, const contact::WornCycle& now,
                                     double n) {
    const double factor = wear_factor();
    const auto size = static_cast<Eigen::Index>(n_);
    const NormalControl& control = problem_.steps.back().normal;
    const Eigen::VectorXd give = n * factor * as_vector(now.slip_path, n_inner_);
    const Eigen::VectorXd profile = as_vector(unworn_, 0), before = as_vector(worn, n_inner_);
    Eigen::VectorXd weights = Eigen::VectorXd::Zero(size);  // F_N of the line load
    for (std::size_t j = 0; j + 1 < n_; ++j) {
        const double dx = radius_[n_inner_ + j + 1] - radius_[n_inner_ + j];
        weights[static_cast<Eigen::Index>(j)] += dx;
        weights[static_cast<Eigen::Index>(j) + 1] += dx;
    }
    Eigen::VectorXd depths = as_vector(plane_profile(worn), 0);
    double depth = now.indentation;
    Eigen::VectorXd touches = (depths.array() < depth).cast<double>();
    constexpr int most = 60;
    constexpr double same_depth = 1e-11;
    Eigen::VectorXd last;
    for (int k = 0; k < most; ++k) {
        const Eigen::MatrixXd pressing =
            data_.effective_modulus * give.asDiagonal() * kernels_->pressure * touches.asDiagonal();
        Eigen::MatrixXd system = pressing * kernels_->image;
        system.diagonal().array() += 1;
        const Eigen::PartialPivLU<Eigen::MatrixXd> factors(system);
        const Eigen::VectorXd at_zero = factors.solve(before - pressing * profile);
        const Eigen::VectorXd by_depth = factors.solve(pressing * Eigen::VectorXd::Ones(size));
        if (control.kind == NormalControl::Kind::force) {
            const Eigen::VectorXd load = data_.effective_modulus * touches.cwiseProduct(weights);
            const double fixed = load.dot(profile + kernels_->image * at_zero);
            const double slope = load.dot(Eigen::VectorXd::Ones(size) - kernels_->image * by_depth);
            depth = (control.value + fixed) / slope;
        }
        const Eigen::VectorXd after = at_zero + depth * by_depth;
        const Eigen::VectorXd gap = profile + kernels_->image * after;
        const Eigen::VectorXd touches_now = (gap.array() < depth).cast<double>();
        // Where next to nothing is left to wear, gaps are rounding, and so is who touches.
        const double change = k > 0 ? (after - last).lpNorm<Eigen::Infinity>() : depth;
        const bool is_settled = touches_now == touches || change <= same_depth * depth;
        last = after;
        touches = touches_now;
        if (!is_settled) continue;
        std::vector<double> all = worn;
        for (std::size_t j = 0; j < n_; ++j)
            all[n_inner_ + j] = std::max(worn[n_inner_ + j], after[static_cast<Eigen::Index>(j)]);
        return all;
    }
    throw contact::NotConverged("mdr: the contact of the worn profile does not settle");
}

std::unique_ptr<contact::WearingContact> SpringBed::wearing(const contact::WearProblem& problem) {
    // Springs are those of the whole bed and cost next to nothing; rings cost their cube.
    constexpr int springs_per_ring = 50, fewest = 20;
    if (!wearing_body_) throw contact::InputError("[wear]: mdr wears bodies of revolution");
    return std::make_unique<WearingBed>(
        WearingBedData{wearing_body_, effective_modulus_, effective_shear_modulus_,
                       bound_ratio_ * effective_shear_modulus_ / effective_modulus_,
                       std::max(fewest, normal_.size() / springs_per_ring)},
        problem);
}

}  // namespace tricontact::mdr
