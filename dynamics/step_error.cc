#include "dynamics/step_error.h"

#include <cmath>
#include <limits>

#include "dynamics/limit_cycle.h"
#include "dynamics/velocity_verlet.h"
#include "dynamics/walk_recorder.h"

namespace tricontact::dynamics {

void add_step_error(const Machine& machine, const Motion& motion, double step, WalkResult& result) {
    // The cycles of both steps differ by the order of step^2; ten periods bring one to the other.
    constexpr int settling = 10, averaged = 10;
    const int points = result.section_points;
    const auto enough = static_cast<std::size_t>((settling + averaged) * points + 1);
    VelocityVerlet run(machine, motion, step / 2);
    WalkRecorder recorder(machine, run.motion(), step / 2,
                          std::numeric_limits<std::int64_t>::max());
    const double latest = run.motion().time + 2 * (settling + averaged) * *result.period;
    while (recorder.returns().size() < enough && run.motion().time < latest) {
        run.advance();
        recorder.add(run.motion(), run.spot_steps());
    }
    const std::span<const SectionReturn> all(recorder.returns());
    const auto n = static_cast<std::size_t>(averaged * points + 1);
    if (all.size() < enough) {  // another motion at half the step: nothing is known of the mean
        result.mu_e_error = result.period_error = std::numeric_limits<double>::quiet_NaN();
        return;
    }
    const LimitCycle finer = mean_cycle(machine, all.last(n), points, step / 2);
    const double force = finer.spring_force / sliding_force(machine);
    result.mu_e_error += 4. / 3 * std::abs(force - result.mu_e);
    result.period_error += 4. / 3 * std::abs(finer.period - *result.period);
}

}  // namespace tricontact::dynamics
