#include "rolling/run.h"

#include <cmath>

#include "rolling/roll_until_steady.h"

namespace tricontact::rolling {

RollingHistory run(const contact::Substrate& substrate, const RollingProblem& problem) {
    RollingHistory history;
    const auto keep = [&](SteadyRolling steady) {
        history.steady = steady.state;
        history.surface = std::move(steady.surface);
        history.audit = std::move(steady.audit);
    };
    if (!substrate.relaxes()) {
        keep(steady_rolling(substrate.compliance(), problem));
        if (!(problem.distance > 0)) return history;
    }
    TransientRolling rolling(substrate, problem);
    history.transient = {rolling.press()};
    const int n = static_cast<int>(std::lround(problem.distance / rolling.cell()));
    for (int i = 0; i < n; ++i) history.transient.push_back(rolling.roll());
    if (substrate.relaxes()) keep(roll_until_steady(rolling, history.transient));
    for (const contact::Audit::Check& check : rolling.audit().checks())
        history.audit.record(check.name, check.worst, check.allowed);
    return history;
}

}  // namespace tricontact::rolling
