#pragma once

#include <array>
#include <cstdint>

#include "walking/kernels/kernel_fields.h"
#include "walking/machine/machine.h"
#include "walking/machine/motion.h"
#include "walking/machine/stretch_recorder.h"

namespace tricontact::walking {

/// Whether kernels know the machine's model, mechanisms and loads; see Batch.
bool fits_lane(const Machine& machine);

/// One machine of a batch in the numbers of the kernels, and back.
class Lane {
  public:
    /// Throws std::invalid_argument for what kernels do not know; see Batch.
    Lane(const Machine& machine, const Motion& start, double step);

    const Machine& machine() const { return machine_; }
    std::int64_t n_steps() const { return n_steps_; }

    /// Constants and state, as the kernels want them.
    double field(walking::kernels::Field field) const { return fields_[field]; }
    /// The state after so many steps more.
    void set_state(const std::array<double, walking::kernels::n_state>& state,
                   std::int64_t n_steps);

    Motion motion() const;
    /// Of the sums over a call of so many steps.
    StretchSums sums(const std::array<double, walking::kernels::n_sums>& sums, std::int64_t n_steps,
                     bool everything) const;

  private:
    void set_constants();
    void set_start(const Motion& start);
    double bound_per_height() const;  // c_n

    Machine machine_;
    double step_;
    double start_time_, start_base_;
    std::int64_t n_steps_ = 0;
    std::array<double, kernels::end_of_state> fields_{};
};

}  // namespace tricontact::walking
