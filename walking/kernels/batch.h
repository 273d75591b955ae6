#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "walking/kernels/kernel.h"
#include "walking/kernels/lane.h"
#include "walking/machine/machine.h"
#include "walking/machine/motion.h"
#include "walking/machine/stretch_recorder.h"

namespace tricontact::walking {

struct BatchOptions {
    Kernel kernel = best_kernel();
    Precision precision = Precision::float64;
    int n_threads = 1;
};

/// Many machines at once by velocity Verlet, each in a lane of the processor's vectors: the motion
/// that VelocityVerlet computes, but for rounding. What a machine does until it tilts depends
/// neither on the others, nor on the number of threads, nor on how the steps are shared among
/// calls.
class Batch {
  public:
    /// What the sums hold: `motion` the spring force and the extremes of z and phi; `everything`
    /// the spots and the kinetic energy too, at about half the speed.
    enum class Detail { motion, everything };

    /// One start per machine; `step` > 0, in units of sqrt(m/k_x). Throws std::invalid_argument for
    /// what the lanes do not know: Model::spots, beds, machines of two models side by side, no
    /// coupling, excitation, kappa1 or mu not above 0; and for a start with another number of
    /// spots.
    Batch(std::span<const Machine> machines, std::span<const Motion> starts, double step,
          const BatchOptions& options = {});

    std::size_t size() const { return lanes_.size(); }
    double step() const { return step_; }

    /// Adds the steps' sums to those of each machine, one each; empty: to none. What depends on the
    /// velocities of the spots lags one step behind the rest, as in StretchRecorder. A machine that
    /// tilts (tilting_limit) stays where it was up to a thousand steps before, and adds nothing
    /// from there on.
    void advance(std::int64_t n_steps, Detail detail, std::span<StretchSums> sums);

    Motion motion(std::size_t machine) const { return lanes_[machine].motion(); }

    /// Until when |phi| stayed within tilting_limit, up to a thousand steps; none: it still does.
    std::optional<double> tilted(std::size_t machine) const;

  private:
    template <class Number, class Work>
    void for_groups_of(bool everything, const Work& work);
    template <class Work>
    void for_groups(bool everything, const Work& work);

    std::vector<Lane> lanes_;
    std::vector<char> tilted_;
    double step_;
    BatchOptions options_;
};

}  // namespace tricontact::walking
