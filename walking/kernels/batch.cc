#include "walking/kernels/batch.h"

#include <algorithm>
#include <stdexcept>

#include "walking/kernels/in_parallel.h"
#include "walking/kernels/lane_group.h"

namespace tricontact::walking {
namespace {

// After so many steps the machines that have tilted make room in the vectors.
constexpr std::int64_t steps_of_a_round = 1 << 16;

}  // namespace

Batch::Batch(std::span<const Machine> machines, std::span<const Motion> starts, double step,
             const BatchOptions& options)
    : tilted_(machines.size(), false), step_(step), options_(options) {
    if (starts.size() != machines.size())
        throw std::invalid_argument("not one start for each machine");
    lanes_.reserve(machines.size());
    for (std::size_t i = 0; i < machines.size(); ++i) {
        if (machines[i].model != machines[0].model)
            throw std::invalid_argument("the machines of a batch are of one model");
        lanes_.emplace_back(machines[i], starts[i], step);
    }
}

/// work(group, members) for the machines that have not tilted, full groups first.
template <class Number, class Work>
void Batch::for_groups_of(bool everything, const Work& work) {
    std::vector<std::size_t> upright;
    for (std::size_t i = 0; i < lanes_.size(); ++i)
        if (!tilted_[i]) upright.push_back(i);
    const auto capacity = static_cast<std::size_t>(LaneGroup<Number>::capacity(options_.kernel));
    const std::size_t n_groups = (upright.size() + capacity - 1) / capacity;
    in_parallel(n_groups, options_.n_threads, [&](std::size_t group) {
        const std::size_t first = group * capacity;
        const auto members =
            std::span(upright).subspan(first, std::min(capacity, upright.size() - first));
        std::vector<Lane*> lanes;
        for (const std::size_t machine : members) lanes.push_back(&lanes_[machine]);
        LaneGroup<Number> lane_group(options_.kernel, lanes, everything);
        work(lane_group, members);
        lane_group.store();
        for (std::size_t i = 0; i < members.size(); ++i) tilted_[members[i]] = lane_group.tilted(i);
    });
}

template <class Work>
void Batch::for_groups(bool everything, const Work& work) {
    if (options_.precision == Precision::float32)
        for_groups_of<float>(everything, work);
    else
        for_groups_of<double>(everything, work);
}

void Batch::advance(std::int64_t n_steps, Detail detail, std::span<StretchSums> sums) {
    if (!sums.empty() && sums.size() != size())
        throw std::invalid_argument("not one sum for each machine");
    for (std::int64_t left = n_steps; left > 0; left -= steps_of_a_round)
        for_groups(detail == Detail::everything,
                   [&](auto& group, std::span<const std::size_t> members) {
                       group.advance(std::min(left, steps_of_a_round));
                       if (sums.empty()) return;
                       for (std::size_t i = 0; i < members.size(); ++i)
                           sums[members[i]].add(group.sums(i));
                   });
}

std::optional<double> Batch::tilted(std::size_t machine) const {
    if (!tilted_[machine]) return std::nullopt;
    return motion(machine).time;
}

}  // namespace tricontact::walking
