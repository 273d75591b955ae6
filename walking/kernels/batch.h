#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "walking/kernels/kernel.h"
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
    bool tilted() const { return tilted_; }

    /// Constants and state in the places that kernels advance: `stride` from field to field.
    void load(double* fields, int stride) const;
    /// Takes state and sums from there after so many steps; not those of a machine that has
    /// tilted: it stays as it was before them.
    void store(const double* fields, int stride, std::int64_t n_steps);

    Motion motion() const;
    /// Of the steps since the last call.
    StretchSums take_sums();

  private:
    void set_constants();
    void set_start(const Motion& start);

    Machine machine_;
    double c_, reach_;  // c_n, kappa3^2
    double step_;
    double start_time_, start_base_;
    std::int64_t n_steps_ = 0, n_summed_ = 0;
    bool tilted_ = false;
    std::array<double, kernels::end_of_state> fields_{};
    std::array<double, kernels::n_sums> sums_;
};

/// Many machines at once by velocity Verlet, each in a lane of the processor's vectors: the motion
/// that VelocityVerlet computes, but for rounding. What a machine does until it tilts depends
/// neither on the others nor on how the steps are shared among calls.
class Batch {
  public:
    /// One start per machine; `step` > 0, in units of sqrt(m/k_x). Throws std::invalid_argument for
    /// what the lanes do not know: Model::spots, beds, machines of two models side by side, no
    /// coupling, excitation, kappa1 or mu not above 0; and for a start with another number of
    /// spots.
    Batch(std::span<const Machine> machines, std::span<const Motion> starts, double step,
          Kernel kernel = best_kernel());

    std::size_t size() const { return lanes_.size(); }
    double step() const { return step_; }

    /// Adds the steps' sums to those of each machine, one each; empty: to none. What depends on the
    /// velocities of the spots lags one step behind the rest, as in StretchRecorder. A machine that
    /// tilts (tilting_limit) stays where it was up to a thousand steps before, and adds nothing
    /// from there on.
    void advance(std::int64_t n_steps, std::span<StretchSums> sums);

    Motion motion(std::size_t machine) const { return lanes_[machine].motion(); }

    /// Until when |phi| stayed within tilting_limit, up to a thousand steps; none: it still does.
    std::optional<double> tilted(std::size_t machine) const;

  private:
    std::vector<Lane> lanes_;
    double step_;
    Kernel kernel_;
};

}  // namespace tricontact::walking
