#include "walking/kernels/batch.h"

#include <cmath>
#include <memory>
#include <new>
#include <stdexcept>

#include "contact/special_values.h"

namespace tricontact::walking {

using namespace kernels;

namespace {

constexpr std::align_val_t alignment{64};

// A call of the kernel: short enough that its sums round little and a tilting machine is found
// early, long enough that the call itself takes no time.
constexpr std::int64_t steps_of_a_block = 1024;

template <class Number>
LaneFunctions<Number> functions_of(Kernel kernel) {
#ifdef __x86_64__
    if (kernel == Kernel::sse2) return sse2_lanes<Number>();
    if (kernel == Kernel::avx2) return avx2_lanes<Number>();
    if (kernel == Kernel::avx512) return avx512_lanes<Number>();
#endif
    return plain_lanes<Number>();
}

std::array<double, n_sums> no_sums() {
    std::array<double, n_sums> sums{};
    for (const Field field : {min_height, min_rotation})
        sums[field - end_of_state] = contact::infinity;
    for (const Field field : {max_height, max_rotation})
        sums[field - end_of_state] = -contact::infinity;
    return sums;
}

/// Lanes that a kernel advances in one go: up to so many, all of one model. Number: float or
/// double.
template <class Number>
class LaneGroup {
  public:
    LaneGroup(Kernel kernel, std::span<Lane* const> lanes, bool everything)
        : n_lanes_(functions_of<Number>(kernel).n_lanes),
          everything_(everything),
          advance_(functions_of<Number>(kernel)
                       .advance[lanes[0]->machine().model == Machine::Model::prism][everything]),
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

    /// A lane whose |phi| grows beyond tilting_limit stays as it was some steps before, see
    /// `tilted`.
    void advance(std::int64_t n_steps) {
        for (std::int64_t left = n_steps; left > 0; left -= steps_of_a_block)
            advance_block(std::min(left, steps_of_a_block));
    }
    bool tilted(std::size_t lane) const { return tilted_[lane]; }
    /// Of all steps so far.
    StretchSums sums(std::size_t lane) const {
        return lanes_[lane]->sums(sums_[lane], n_steps_[lane], everything_);
    }
    /// Writes the states back to the lanes, once at the end.
    void store() {
        hold();
        for (std::size_t i = 0; i < lanes_.size(); ++i) lanes_[i]->set_state(held_[i], n_steps_[i]);
    }

  private:
    void advance_block(std::int64_t n_steps) {
        hold();
        advance_(fields_.get(), n_steps);
        for (std::size_t i = 0; i < lanes_.size(); ++i) {
            if (!tilted_[i] && !within_limit(i)) tilted_[i] = true;
            if (tilted_[i]) continue;
            n_steps_[i] += n_steps;
            add_sums(i);
        }
    }

    void hold() {
        for (std::size_t i = 0; i < lanes_.size(); ++i)
            if (!tilted_[i])
                for (int field = 0; field < n_state; ++field)
                    held_[i][static_cast<std::size_t>(field)] = at(n_constants + field, i);
    }

    bool within_limit(std::size_t lane) const {
        const Machine& machine = lanes_[lane]->machine();
        const double limit =
            tilting_limit(machine) / (machine.kappas.kappa3 * machine.kappas.kappa3);
        // Extremes may miss what is not a number; the state does not.
        return at(max_rotation, lane) <= limit && at(min_rotation, lane) >= -limit &&
               std::abs(at(rotation, lane)) <= limit && std::isfinite(at(height, lane)) &&
               std::isfinite(at(extension, lane));
    }

    void add_sums(std::size_t lane) {
        const int end = everything_ ? n_fields : max_rotation + 1;
        for (int field = end_of_state; field < end; ++field) {
            double& sum = sums_[lane][static_cast<std::size_t>(field - end_of_state)];
            const double more = at(field, lane);
            if (field == min_height || field == min_rotation)
                sum = std::min(sum, more);
            else if (field == max_height || field == max_rotation)
                sum = std::max(sum, more);
            else
                sum += more;
        }
    }

    Number& at(int field, std::size_t lane) const {
        return fields_[static_cast<std::size_t>(field * n_lanes_) + lane];
    }

    struct Free {
        void operator()(Number* fields) const { ::operator delete[](fields, alignment); }
    };

    int n_lanes_;
    bool everything_;
    AdvanceLanes<Number>* advance_;
    std::vector<Lane*> lanes_;
    std::unique_ptr<Number[], Free> fields_;
    std::vector<std::array<double, n_state>> held_;  // states before a block
    std::vector<std::array<double, n_sums>> sums_;
    std::vector<std::int64_t> n_steps_;
    std::vector<char> tilted_;
};

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

/// Advances the machines that have not tilted, full groups first.
template <class Number>
void Batch::advance_groups(std::int64_t n_steps, bool everything, std::span<StretchSums> sums) {
    std::vector<std::size_t> upright;
    for (std::size_t i = 0; i < lanes_.size(); ++i)
        if (!tilted_[i]) upright.push_back(i);
    const auto capacity = static_cast<std::size_t>(functions_of<Number>(options_.kernel).n_lanes);
    const std::size_t n_groups = (upright.size() + capacity - 1) / capacity;
    in_parallel(n_groups, options_.n_threads, [&](std::size_t i) {
        const auto members = std::span(upright).subspan(
            i * capacity, std::min(capacity, upright.size() - i * capacity));
        std::vector<Lane*> lanes;
        for (const std::size_t machine : members) lanes.push_back(&lanes_[machine]);
        LaneGroup<Number> group(options_.kernel, lanes, everything);
        group.advance(n_steps);
        group.store();
        for (std::size_t k = 0; k < members.size(); ++k) {
            if (!sums.empty()) sums[members[k]].add(group.sums(k));
            tilted_[members[k]] = group.tilted(k);
        }
    });
}

void Batch::advance(std::int64_t n_steps, Detail detail, std::span<StretchSums> sums) {
    if (!sums.empty() && sums.size() != size())
        throw std::invalid_argument("not one sum for each machine");
    const auto advance_by = options_.precision == Precision::float32
                                ? &Batch::advance_groups<float>
                                : &Batch::advance_groups<double>;
    for (std::int64_t left = n_steps; left > 0; left -= steps_of_a_round)
        (this->*advance_by)(std::min(left, steps_of_a_round), detail == Detail::everything, sums);
}

std::optional<double> Batch::tilted(std::size_t machine) const {
    if (!tilted_[machine]) return std::nullopt;
    return motion(machine).time;
}

}  // namespace tricontact::walking
