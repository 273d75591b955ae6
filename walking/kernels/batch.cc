#include "walking/kernels/batch.h"

#include <algorithm>
#include <boost/align/aligned_allocator.hpp>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "contact/base/special_values.h"

namespace tricontact::walking {

using namespace kernels;

namespace {

using Model = Machine::Model;

constexpr double slope = 1 / std::numbers::sqrt2;  // of a flank at 45 degrees

/// Why a lane cannot carry the machine; nothing: it can.
const char* obstacle(const Machine& machine) {
    if (machine.model == Model::spots) return "a lane carries two spots, not Model::spots";
    if (machine.bed) return "a lane has no springs in its spots";
    if (!machine.mechanisms.coupling) return "a lane couples friction to the normal force";
    if (machine.excitation.frequency > 0) return "a lane has no excitation";
    if (!(machine.kappas.kappa1 > 0) || !(machine.kappas.kappa5 > 0))
        return "a lane needs kappa1 > 0 and mu > 0: it scales by them";
    return nullptr;
}

constexpr std::array<double, n_sums> no_sums = [] {
    std::array<double, n_sums> sums{};
    for (const Field field : {min_height, min_rotation})
        sums[field - end_of_state] = contact::infinity;
    for (const Field field : {max_height, max_rotation})
        sums[field - end_of_state] = -contact::infinity;
    return sums;
}();

double bound_per_height(const Machine& machine) {
    const double c = machine.kappas.kappa5 * machine.kappas.kappa2;
    return machine.model == Model::prism ? slope * c : c;
}

// A call of the kernel: short enough that its sums round little and a tilting machine is found
// early, long enough that the call itself takes no time.
constexpr std::int64_t steps_of_a_block = 1024;

// After so many steps the machines that have tilted make room in the vectors.
constexpr std::int64_t steps_of_a_round = 1 << 16;

/// Advances lanes of one model in one go, at most functions.n_lanes.
void advance_group(const LaneFunctions& functions, std::span<Lane* const> lanes,
                   std::int64_t n_steps) {
    const int stride = functions.n_lanes;
    constexpr std::size_t widest_vector = 64;  // bytes
    std::vector<double, boost::alignment::aligned_allocator<double, widest_vector>> numbers(
        static_cast<std::size_t>(stride * n_fields));
    double* fields = numbers.data();
    // Places that are left over repeat the last machine.
    for (std::size_t i = 0; i < static_cast<std::size_t>(stride); ++i)
        lanes[std::min(i, lanes.size() - 1)]->load(fields + i, stride);
    const bool prism = lanes[0]->machine().model == Machine::Model::prism;
    for (std::int64_t left = n_steps; left > 0; left -= steps_of_a_block) {
        const std::int64_t n = std::min(left, steps_of_a_block);
        functions.advance[prism](fields, n);
        for (std::size_t i = 0; i < lanes.size(); ++i) lanes[i]->store(fields + i, stride, n);
    }
}

}  // namespace

bool fits_lane(const Machine& machine) {
    return !obstacle(machine);
}

Lane::Lane(const Machine& machine, const Motion& start, double step)
    : machine_(machine),
      c_(bound_per_height(machine)),
      reach_(machine.kappas.kappa3 * machine.kappas.kappa3),
      step_(step),
      start_time_(start.time),
      start_base_(start.base),
      sums_(no_sums) {
    if (const char* reason = obstacle(machine)) throw std::invalid_argument(reason);
    if (start.spots.size() != 2)
        throw std::invalid_argument("the start has another number of spots than the machine");
    set_constants();
    set_start(start);
}

void Lane::set_constants() {
    const auto& [kappa1, kappa2, kappa3, kappa4, mu, kappa6, kappa7, kappa8] = machine_.kappas;
    const double dt2 = step_ * step_;
    fields_[lever] = c_ * kappa3;
    fields_[spring] = kappa1;
    fields_[spring_lever] = kappa1 * kappa8 * reach_;
    fields_[base_increment] = kappa1 * kappa6 * step_;
    fields_[rotation_reach] = reach_;
    fields_[weight] = machine_.mechanisms.vertical ? dt2 * c_ * kappa4 : 0;
    fields_[lift] = machine_.mechanisms.vertical ? dt2 * c_ / mu : 0;
    fields_[pull] = dt2;
    fields_[turn] = machine_.mechanisms.rotation ? dt2 / kappa7 : 0;
    fields_[normal_moment] = 1 / (mu * kappa3);
    fields_[tilted_moment] = kappa3 / mu;
    fields_[spring_height] = kappa8;
    fields_[flank_reach] = 1 / (mu * kappa2);
    fields_[flank_force] = std::numbers::sqrt2 * mu;
}

void Lane::set_start(const Motion& start) {
    const Kappas& k = machine_.kappas;
    const double half = step_ / 2;
    const auto [ax, az, aphi] = acceleration(machine_, spots_of(machine_), start);
    fields_[rotation] = start.phi / reach_;
    fields_[rotation_increment] = step_ * (start.phi_velocity + half * aphi) / reach_;
    fields_[height] = c_ * start.z;
    fields_[height_increment] = c_ * step_ * (start.z_velocity + half * az);
    fields_[extension] = k.kappa1 * (start.base - start.x);
    fields_[x_increment] = step_ * (start.x_velocity + half * ax);
    for (int i = 0; i < 2; ++i) {
        const SpotDeflection& spot = start.spots[static_cast<std::size_t>(i)];
        fields_[deflection_1 + i] = spot.tangential;
        fields_[flank_1 + i] = spot.flank;
    }
}

void Lane::load(double* fields, int stride) const {
    for (int field = 0; field < end_of_state; ++field) fields[field * stride] = fields_[field];
}

void Lane::store(const double* fields, int stride, std::int64_t n_steps) {
    if (tilted_) return;
    const auto at = [&](int field) { return fields[field * stride]; };
    const double limit = tilting_limit(machine_) / reach_;
    // Extremes may miss what is not a number; the state does not.
    tilted_ = !(at(max_rotation) <= limit && at(min_rotation) >= -limit &&
                std::abs(at(rotation)) <= limit && std::isfinite(at(height)) &&
                std::isfinite(at(extension)));
    if (tilted_) return;
    n_steps_ += n_steps;
    n_summed_ += n_steps;
    for (int field = n_constants; field < end_of_state; ++field) fields_[field] = at(field);
    for (int field = end_of_state; field < n_fields; ++field) {
        double& sum = sums_[field - end_of_state];
        if (field == min_height || field == min_rotation)
            sum = std::min(sum, at(field));
        else if (field == max_height || field == max_rotation)
            sum = std::max(sum, at(field));
        else
            sum += at(field);
    }
}

Motion Lane::motion() const {
    const Kappas& k = machine_.kappas;
    const double half = step_ / 2;
    const double elapsed = step_ * static_cast<double>(n_steps_);
    Motion motion{.time = start_time_ + elapsed, .base = start_base_ + k.kappa6 * elapsed};
    motion.x = motion.base - fields_[extension] / k.kappa1;
    motion.z = fields_[height] / c_;
    motion.phi = fields_[rotation] * reach_;
    const double scale = c_ / (k.kappa5 * k.kappa2);  // 1, or the slope of a flank
    for (int i = 0; i < 2; ++i) {
        const double lifted = (i == 0 ? 1 : -1) * motion.phi / k.kappa3;
        motion.spots.push_back({.normal = std::max(0., scale * (motion.z + lifted)),
                                .tangential = fields_[deflection_1 + i],
                                .flank = fields_[flank_1 + i]});
    }
    // Increments run half a step ahead.
    const auto [ax, az, aphi] = acceleration(machine_, spots_of(machine_), motion);
    motion.x_velocity = fields_[x_increment] / step_ - half * ax;
    motion.z_velocity = fields_[height_increment] / (c_ * step_) - half * az;
    motion.phi_velocity = fields_[rotation_increment] * reach_ / step_ - half * aphi;
    return motion;
}

StretchSums Lane::take_sums() {
    const auto sums = std::exchange(sums_, no_sums);
    const auto of = [&](int field) { return sums[static_cast<std::size_t>(field - end_of_state)]; };
    const Kappas& k = machine_.kappas;
    StretchSums result{.steps = std::exchange(n_summed_, 0),
                       .spring_force = of(sum_force),
                       .z_min = of(min_height) / c_,
                       .z_max = of(max_height) / c_,
                       .phi_min = of(min_rotation) * reach_,
                       .phi_max = of(max_rotation) * reach_,
                       .spots = {}};
    // phi = kappa3^2 p: kappa7/kappa3^2 phi'^2 = kappa7 kappa3^2 p'^2
    result.kinetic_energy = (of(sum_x_squared) + of(sum_height_squared) / (c_ * c_) +
                             k.kappa7 * reach_ * of(sum_rotation_squared)) /
                            (8 * step_ * step_);
    // Sums of squared increments are those of two steps. Sums of bounds are mu kappa2 times those
    // of the deflections, those of slip 2 dt times those of the velocity.
    const double bound = k.kappa5 * k.kappa2, slip = 2 * step_;
    for (int i = 0; i < 2; ++i)
        result.spots.push_back({.sticking = static_cast<std::int64_t>(of(sum_sticking_1 + i)),
                                .velocity = of(sum_slip_1 + i) / slip,
                                .velocity_squared = of(sum_slip_squared_1 + i) / (slip * slip),
                                .normal = of(sum_bound_1 + i) / bound,
                                .normal_squared = of(sum_bound_squared_1 + i) / (bound * bound),
                                .normal_velocity = of(sum_bound_slip_1 + i) / (bound * slip)});
    return result;
}

Batch::Batch(std::span<const Machine> machines, std::span<const Motion> starts, double step,
             Kernel kernel)
    : step_(step), kernel_(kernel) {
    if (starts.size() != machines.size())
        throw std::invalid_argument("not one start for each machine");
    lanes_.reserve(machines.size());
    for (std::size_t i = 0; i < machines.size(); ++i) {
        if (machines[i].model != machines[0].model)
            throw std::invalid_argument("the machines of a batch are of one model");
        lanes_.emplace_back(machines[i], starts[i], step);
    }
}

void Batch::advance(std::int64_t n_steps, std::span<StretchSums> sums) {
    if (!sums.empty() && sums.size() != size())
        throw std::invalid_argument("not one sum for each machine");
    const LaneFunctions functions = functions_of(kernel_);
    const auto capacity = static_cast<std::size_t>(functions.n_lanes);
    for (std::int64_t left = n_steps; left > 0; left -= steps_of_a_round) {
        std::vector<Lane*> upright;
        for (Lane& lane : lanes_)
            if (!lane.tilted()) upright.push_back(&lane);
        // Full groups first.
        for (std::span<Lane* const> rest = upright; !rest.empty();) {
            const auto lanes = rest.first(std::min(capacity, rest.size()));
            rest = rest.subspan(lanes.size());
            advance_group(functions, lanes, std::min(left, steps_of_a_round));
            for (Lane* lane : lanes) {
                const StretchSums more = lane->take_sums();
                if (!sums.empty()) sums[static_cast<std::size_t>(lane - lanes_.data())].add(more);
            }
        }
    }
}

std::optional<double> Batch::tilted(std::size_t machine) const {
    if (!lanes_[machine].tilted()) return std::nullopt;
    return motion(machine).time;
}

}  // namespace tricontact::walking
