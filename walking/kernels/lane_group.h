#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "walking/kernels/kernel.h"
#include "walking/kernels/kernel_fields.h"
#include "walking/kernels/lane.h"
#include "walking/machine/stretch_recorder.h"

namespace tricontact::walking {

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
    walking::kernels::AdvanceLanes<Number>* kernel_;
    bool everything_;
    std::vector<Lane*> lanes_;
    std::unique_ptr<Number[], Free> fields_;
    std::vector<std::array<double, walking::kernels::n_state>> held_;  // states before a block
    std::vector<std::array<double, walking::kernels::n_sums>> sums_;
    std::vector<std::int64_t> n_steps_;
    std::vector<char> tilted_;
};

extern template class LaneGroup<float>;
extern template class LaneGroup<double>;

}  // namespace tricontact::walking
