#pragma once

#include <cstdint>
#include <vector>

#include "contact/base/special_values.h"
#include "walking/machine/motion.h"
#include "walking/machine/velocity_verlet.h"

namespace tricontact::walking {

/// A run as the spots of its machine see it: the springs of a bed count as one, whose deflections
/// are those of a single spring of the spot's stiffness with the same forces. It sticks while one
/// of them does, and slips as far as the one that slips least. Without a bed: the run itself.
class SpotView {
  public:
    explicit SpotView(const Machine& machine);

    /// `motion` and `steps`: of springs_of(machine), in their order. Valid until the next call.
    void look_at(const Motion& motion, const std::vector<SpotStep>& steps);

    const Motion& motion() const { return *motion_; }
    /// In the order of spots_of.
    const std::vector<SpotStep>& steps() const { return *steps_; }

  private:
    std::vector<Spot> spots_, springs_;
    Motion sums_;
    std::vector<SpotStep> sum_steps_;
    const Motion* motion_ = nullptr;
    const std::vector<SpotStep>* steps_ = nullptr;
};

/// Sums over the steps of a stretch of time of one contact spot. Its velocity is s', of
/// s = x + phi - u, by central differences: Wetter (2016), eqs. 4.2.15 and 4.2.16.
struct SpotSums {
    std::int64_t sticking = 0;                  ///< steps
    double velocity = 0, velocity_squared = 0;  ///< s', in units of b sqrt(k_x/m)
    double normal = 0, normal_squared = 0;      ///< deflection n, in units of b
    double normal_velocity = 0;                 ///< n s'
};

/// Sums over the steps of a stretch of time; stretches add up, so that statistics of any number of
/// them follow from their sums.
struct StretchSums {
    std::int64_t steps = 0;
    double spring_force = 0;    ///< f_s
    double kinetic_energy = 0;  ///< (x'^2 + z'^2 + kappa7/kappa3^2 phi'^2)/2
    double z_min = contact::infinity, z_max = -contact::infinity;
    double phi_min = contact::infinity, phi_max = -contact::infinity;
    std::vector<SpotSums> spots;  ///< in the order of spots_of; empty where they were left out

    /// Throws std::invalid_argument if the other has another number of spots.
    void add(const StretchSums& other);
};

/// Pearson's r of velocity and normal deflection; NaN if one of them does not vary. Wetter (2016),
/// appendix A.1.4.
double correlation(const SpotSums& spot, std::int64_t steps);

/// Sums up the steps of a run, stretch by stretch. The velocities of the spots, central
/// differences, are known a step later: what depends on them lags one step behind the rest.
class StretchRecorder {
  public:
    /// `start`: the machine is taken to be at rest before. `step` > 0: between two motions.
    StretchRecorder(const Machine& machine, const Motion& start, double step);

    /// Next step of the run; `spot_steps` are what the spots did in it.
    void add(const Motion& motion, const std::vector<SpotStep>& spot_steps);

    std::int64_t steps() const { return sums_.steps; }
    /// Sums since the start or the last take.
    const StretchSums& sums() const { return sums_; }
    /// The same, to start again.
    StretchSums take();

  private:
    struct SpotPath {
        double before = 0, now = 0;  // s at the last two steps
        double normal = 0;           // n at the last step
    };

    Machine machine_;
    double step_, rotational_;  // the latter: kappa7/kappa3^2
    std::vector<SpotPath> paths_;
    StretchSums sums_;
};

}  // namespace tricontact::walking
