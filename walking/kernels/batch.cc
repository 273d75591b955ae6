#include "walking/kernels/batch.h"

#include <boost/align/aligned_allocator.hpp>
#include <stdexcept>

namespace tricontact::walking {

using namespace kernels;

namespace {

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

Batch::Batch(std::span<const Machine> machines, std::span<const Motion> starts, double step,
             const BatchOptions& options)
    : step_(step), options_(options) {
    if (starts.size() != machines.size())
        throw std::invalid_argument("not one start for each machine");
    lanes_.reserve(machines.size());
    for (std::size_t i = 0; i < machines.size(); ++i) {
        if (machines[i].model != machines[0].model)
            throw std::invalid_argument("the machines of a batch are of one model");
        lanes_.emplace_back(machines[i], starts[i], step);
    }
}

/// Advances the machines that have not tilted, full groups first.
void Batch::advance_groups(std::int64_t n_steps, std::span<StretchSums> sums) {
    std::vector<Lane*> upright;
    for (Lane& lane : lanes_)
        if (!lane.tilted()) upright.push_back(&lane);
    const LaneFunctions functions = functions_of(options_.kernel);
    const auto capacity = static_cast<std::size_t>(functions.n_lanes);
    const std::size_t n_groups = (upright.size() + capacity - 1) / capacity;
    in_parallel(n_groups, options_.n_threads, [&](std::size_t i) {
        const auto lanes = std::span(upright).subspan(
            i * capacity, std::min(capacity, upright.size() - i * capacity));
        advance_group(functions, lanes, n_steps);
        for (Lane* lane : lanes) {
            const StretchSums more = lane->take_sums();
            if (!sums.empty()) sums[static_cast<std::size_t>(lane - lanes_.data())].add(more);
        }
    });
}

void Batch::advance(std::int64_t n_steps, std::span<StretchSums> sums) {
    if (!sums.empty() && sums.size() != size())
        throw std::invalid_argument("not one sum for each machine");
    for (std::int64_t left = n_steps; left > 0; left -= steps_of_a_round)
        advance_groups(std::min(left, steps_of_a_round), sums);
}

std::optional<double> Batch::tilted(std::size_t machine) const {
    if (!lanes_[machine].tilted()) return std::nullopt;
    return motion(machine).time;
}

}  // namespace tricontact::walking
