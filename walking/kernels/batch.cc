#include "walking/kernels/batch.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <new>
#include <stdexcept>

namespace tricontact::walking {

using namespace kernels;

namespace {

constexpr std::align_val_t alignment{64};

// A call of the kernel: short enough that its sums round little and a tilting machine is found
// early, long enough that the call itself takes no time.
constexpr std::int64_t steps_of_a_block = 1024;

template <class Number>
LaneFunctions<Number> functions_of(Kernel kernel) {
    switch (kernel) {
        case Kernel::plain:
            break;
#ifdef __x86_64__
        case Kernel::sse2:
            return sse2_lanes<Number>();
        case Kernel::avx2:
            return avx2_lanes<Number>();
        case Kernel::avx512:
            return avx512_lanes<Number>();
#else
        default:
            break;
#endif
    }
    return plain_lanes<Number>();
}

template <class Number>
AdvanceLanes<Number>* kernel_of(const LaneFunctions<Number>& functions, bool prism,
                                bool everything) {
    if (prism) return everything ? functions.prism_everything : functions.prism_motion;
    return everything ? functions.everything : functions.motion;
}

std::array<double, n_sums> no_sums() {
    std::array<double, n_sums> sums{};
    for (const Field field : {min_height, min_rotation})
        sums[field - end_of_state] = std::numeric_limits<double>::infinity();
    for (const Field field : {max_height, max_rotation})
        sums[field - end_of_state] = -std::numeric_limits<double>::infinity();
    return sums;
}

/// Lanes that a kernel advances in one go: up to so many, all of one model. Number: float or
/// double.
template <class Number>
class LaneGroup {
  public:
    static int capacity(Kernel kernel);

    LaneGroup(Kernel kernel, std::span<Lane* const> lanes, bool everything);

    /// A lane whose |phi| grows beyond tilting_limit stays as it was some steps before, see
    /// `tilted`.
    void advance(std::int64_t n_steps);

    bool tilted(std::size_t lane) const { return tilted_[lane]; }
    /// Of all steps so far.
    StretchSums sums(std::size_t lane) const;
    /// Writes the states back to the lanes, once at the end.
    void store();

  private:
    void advance_block(std::int64_t n_steps);
    bool within_limit(std::size_t lane) const;
    void add_sums(std::size_t lane);
    Number& at(int field, std::size_t lane) const;

    struct Free {
        void operator()(Number* fields) const;
    };

    int n_lanes_;
    AdvanceLanes<Number>* kernel_;
    bool everything_;
    std::vector<Lane*> lanes_;
    std::unique_ptr<Number[], Free> fields_;
    std::vector<std::array<double, n_state>> held_;  // states before a block
    std::vector<std::array<double, n_sums>> sums_;
    std::vector<std::int64_t> n_steps_;
    std::vector<char> tilted_;
};

template <class Number>
int LaneGroup<Number>::capacity(Kernel kernel) {
    return functions_of<Number>(kernel).n_lanes;
}

template <class Number>
void LaneGroup<Number>::Free::operator()(Number* fields) const {
    ::operator delete[](fields, alignment);
}

template <class Number>
LaneGroup<Number>::LaneGroup(Kernel kernel, std::span<Lane* const> lanes, bool everything)
    : n_lanes_(capacity(kernel)),
      kernel_(kernel_of(functions_of<Number>(kernel),
                        lanes[0]->machine().model == Machine::Model::prism, everything)),
      everything_(everything),
      lanes_(lanes.begin(), lanes.end()),
      fields_(new (alignment) Number[static_cast<std::size_t>(n_lanes_ * n_fields)]),
      held_(lanes.size()),
      sums_(lanes.size(), no_sums()),
      n_steps_(lanes.size(), 0),
      tilted_(lanes.size(), false) {
    // Places that are left over repeat the last machine.
    for (std::size_t i = 0; i < static_cast<std::size_t>(n_lanes_); ++i)
        for (int field = 0; field < end_of_state; ++field)
            at(field, i) = static_cast<Number>(
                lanes_[std::min(i, lanes_.size() - 1)]->field(static_cast<Field>(field)));
}

template <class Number>
Number& LaneGroup<Number>::at(int field, std::size_t lane) const {
    return fields_[static_cast<std::size_t>(field * n_lanes_) + lane];
}

template <class Number>
void LaneGroup<Number>::advance(std::int64_t n_steps) {
    for (std::int64_t left = n_steps; left > 0; left -= steps_of_a_block)
        advance_block(std::min(left, steps_of_a_block));
}

template <class Number>
void LaneGroup<Number>::advance_block(std::int64_t n_steps) {
    for (std::size_t i = 0; i < lanes_.size(); ++i)
        if (!tilted_[i])
            for (int field = 0; field < n_state; ++field)
                held_[i][static_cast<std::size_t>(field)] = at(n_constants + field, i);
    kernel_(fields_.get(), n_steps);
    for (std::size_t i = 0; i < lanes_.size(); ++i) {
        if (!tilted_[i] && !within_limit(i)) tilted_[i] = true;
        if (tilted_[i]) continue;
        n_steps_[i] += n_steps;
        add_sums(i);
    }
}

template <class Number>
bool LaneGroup<Number>::within_limit(std::size_t lane) const {
    const Machine& machine = lanes_[lane]->machine();
    const double limit = tilting_limit(machine) / (machine.kappas.kappa3 * machine.kappas.kappa3);
    // Extremes may miss what is not a number; the state does not.
    return at(max_rotation, lane) <= limit && at(min_rotation, lane) >= -limit &&
           std::abs(at(rotation, lane)) <= limit && std::isfinite(at(height, lane)) &&
           std::isfinite(at(extension, lane));
}

template <class Number>
void LaneGroup<Number>::add_sums(std::size_t lane) {
    std::array<double, n_sums>& sums = sums_[lane];
    const int n = everything_ ? n_sums : max_rotation + 1 - end_of_state;
    for (int i = 0; i < n; ++i) {
        double& sum = sums[static_cast<std::size_t>(i)];
        const double more = at(end_of_state + i, lane);
        switch (end_of_state + i) {
            case min_height:
            case min_rotation:
                sum = std::min(sum, more);
                break;
            case max_height:
            case max_rotation:
                sum = std::max(sum, more);
                break;
            default:
                sum += more;
        }
    }
}

template <class Number>
StretchSums LaneGroup<Number>::sums(std::size_t lane) const {
    return lanes_[lane]->sums(sums_[lane], n_steps_[lane], everything_);
}

template <class Number>
void LaneGroup<Number>::store() {
    for (std::size_t i = 0; i < lanes_.size(); ++i) {
        if (!tilted_[i])
            for (int field = 0; field < n_state; ++field)
                held_[i][static_cast<std::size_t>(field)] = at(n_constants + field, i);
        lanes_[i]->set_state(held_[i], n_steps_[i]);
    }
}

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
