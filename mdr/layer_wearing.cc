#include "mdr/layer_wearing.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "contact/base/error.h"
#include "mdr/layer_model.h"

namespace tricontact::mdr {

namespace {

/// Of a disc as long as the elements in question [m^2]; `area`: theirs.
double area_of_disc(double area) {
    const double length = area / LayerSprings::width;
    return std::numbers::pi / 4 * length * length;
}

/// The normal contact of a profile that wears by `n` cycles at once, see LayerWearing.
struct WornLine {
    const Eigen::MatrixXd& system;   ///< C + T D B
    const Eigen::VectorXd& profile;  ///< g + T w
    const Eigen::VectorXd& weights;  ///< of q in F_N
    const contact::NormalControl& by;
    double usual_load;  ///< what q is of the order of as long as nothing is worn

    using Rings = std::vector<Eigen::Index>;

    /// q where it touches, 0 elsewhere; `depth`: found under a force.
    Eigen::VectorXd loads(const Rings& touching, double& depth) const {
        Eigen::VectorXd load = Eigen::VectorXd::Zero(profile.size());
        if (touching.empty()) return load;
        const Eigen::PartialPivLU<Eigen::MatrixXd> factors(
            Eigen::MatrixXd(system(touching, touching)));
        const auto n = static_cast<Eigen::Index>(touching.size());
        const Eigen::VectorXd at_zero = factors.solve(-Eigen::VectorXd(profile(touching)));
        const Eigen::VectorXd by_depth = factors.solve(Eigen::VectorXd::Ones(n));
        if (by.kind == contact::NormalControl::Kind::force) {
            const Eigen::VectorXd weight = weights(touching);
            depth = (by.value - weight.dot(at_zero)) / weight.dot(by_depth);
        }
        load(touching) = at_zero + depth * by_depth;
        return load;
    }

    /// `touching`: at first.
    Eigen::VectorXd solve(Rings touching, double depth) const {
        constexpr int most = 100;
        constexpr double same_load = 1e-11;
        Eigen::VectorXd last;
        for (int k = 0; k < most; ++k) {
            const Eigen::VectorXd load = loads(touching, depth);
            const Eigen::VectorXd overlap =
                depth - (profile + system * load).array();  // where nothing is carried
            Rings now;
            for (Eigen::Index i = 0; i < load.size(); ++i)
                if (load[i] > 0 || (load[i] == 0 && overlap[i] > 0)) now.push_back(i);
            // Where next to nothing is left to wear, loads are rounding, and so is who touches.
            const bool is_settled =
                now == touching ||
                (k > 0 && (load - last).lpNorm<Eigen::Infinity>() <= same_load * usual_load);
            if (is_settled) return load.cwiseMax(0.);
            last = load;
            touching = std::move(now);
        }
        throw contact::NotConverged("mdr-layer: the contact of the worn profile does not settle");
    }
};

}  // namespace

LayerWearing::LayerWearing(LayerModel& model, std::unique_ptr<contact::WearingContact> line,
                           contact::WearProblem problem, double friction)
    : WornRings(model.name(), std::move(problem), friction), model_(model), line_(std::move(line)) {
    make_rings();
}

void LayerWearing::make_rings() {
    const LayerSprings& springs = model_.springs();
    const double h = springs.row().spacing;
    const std::size_t n = springs.points().size() / 2 + 1;
    if (h * static_cast<double>(n) > model_.profile().range())
        throw contact::InputError(
            "[wear]: mdr-layer: the worn contact becomes as wide as the body; reduce wear.cycles");
    const auto size = static_cast<Eigen::Index>(n);
    radius_.resize(n);
    unworn_.resize(size);
    compliance_.resize(size, size);
    std::vector<double> traction(springs.points().size()), displacement(traction.size());
    for (Eigen::Index j = 0; j < size; ++j) {
        const auto k = static_cast<std::size_t>(j);
        radius_[k] = h * static_cast<double>(j);
        unworn_[j] = model_.profile().value(radius_[k]);
        traction[n - 1 + k] = traction[n - 1 - k] = 1 / LayerSprings::width;
        springs.normal(traction, displacement);
        traction[n - 1 + k] = traction[n - 1 - k] = 0;
        compliance_.col(j) = folded(displacement);
    }
    area_ = areas_of_hats(n, h);
    kernels_ = std::make_unique<const WornKernels>(static_cast<int>(n), h, 0.);
}

void LayerWearing::enlarge(const contact::ContactAtEdge& reached) {
    line_->enlarge(reached);
    make_rings();
}

Eigen::VectorXd LayerWearing::folded(const std::vector<double>& on_line) const {
    const auto n = unworn_.size();
    const Eigen::Map<const Eigen::VectorXd> both(on_line.data(), 2 * n - 1);
    return (both.tail(n) + both.head(n).reverse()) / 2;
}

std::vector<double> LayerWearing::unfolded(const Eigen::VectorXd& on_rings) const {
    const auto n = on_rings.size();
    std::vector<double> both(static_cast<std::size_t>(2 * n - 1));
    Eigen::Map<Eigen::VectorXd> all(both.data(), 2 * n - 1);
    all.tail(n) = on_rings;
    all.head(n) = on_rings.reverse();
    return both;
}

contact::WornCycle LayerWearing::cycle(const std::vector<double>& worn) {
    const auto n = unworn_.size();
    const Eigen::Map<const Eigen::VectorXd> depth(worn.data(), n);
    contact::WornCycle found = line_->cycle(unfolded(kernels_->image * depth));
    const Eigen::VectorXd load = LayerSprings::width * folded(found.pressure);
    if (load[n - 1] > 0)
        throw contact::ContactAtEdge("mdr-layer: the worn contact reaches the last element");
    const Eigen::VectorXd pressure = kernels_->pressure * load,
                          slip = kernels_->slip * folded(found.slip_path);
    found.pressure.assign(radius_.size(), 0);
    found.slip_path = found.rate = found.pressure;
    double pressed_slip = 0;
    for (std::size_t i = 0; i < radius_.size(); ++i) {
        const auto j = static_cast<Eigen::Index>(i);
        found.slip_path[i] = std::max(0., slip[j]);
        if (load[j] > 0) found.pressure[i] = std::max(0., pressure[j]);
        const double worked = found.pressure[i] * found.slip_path[i];
        found.rate[i] = wear_factor() * worked;
        pressed_slip += area_[i] * worked;
    }
    found.volume = found.volume_by_means = wear_factor() * pressed_slip;
    found.work = friction_ * pressed_slip;
    found.contact_area = area_of_disc(found.contact_area);
    found.stick_area = area_of_disc(found.stick_area);
    return found;
}

std::vector<double> LayerWearing::jump(const std::vector<double>& worn,
                                       const contact::WornCycle& now, double n) {
    const auto size = unworn_.size();
    const Eigen::Map<const Eigen::VectorXd> before(worn.data(), size),
        slip(now.slip_path.data(), size);
    const Eigen::MatrixXd wearing =
        (n * wear_factor() * slip).asDiagonal() * kernels_->pressure;  // D B
    const Eigen::VectorXd profile = unworn_ + kernels_->image * before;
    const double h = radius_[1];
    Eigen::VectorXd weights = Eigen::VectorXd::Constant(size, 2 * h);
    weights[0] = h;
    WornLine::Rings touching;
    for (Eigen::Index i = 0; i < size; ++i)
        if (now.pressure[static_cast<std::size_t>(i)] > 0) touching.push_back(i);
    const Eigen::MatrixXd system = compliance_ + kernels_->image * wearing;
    const Eigen::VectorXd load = WornLine{system, profile, weights, problem_.steps.back().normal,
                                          now.indentation / compliance_(0, 0)}
                                     .solve(std::move(touching), now.indentation);
    if (load[size - 1] > 0)
        throw contact::ContactAtEdge("mdr-layer: the worn contact reaches the last element");
    const Eigen::VectorXd more = wearing * load;
    std::vector<double> after = worn;
    for (Eigen::Index i = 0; i < size; ++i)
        after[static_cast<std::size_t>(i)] += std::max(0., more[i]);
    return after;
}

}  // namespace tricontact::mdr
