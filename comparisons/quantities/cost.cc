#include <algorithm>

#include "comparisons/quantities/quantities.h"

namespace tricontact::comparisons::quantities {

namespace {

constinit const Quantity cpu_time{.key = "cpu_s",
                                  .unit = "s",
                                  .name = "CPU time",
                                  .meaning = "CPU time of the run.",
                                  .of = [](const Subject& s) { return finite(s.history.cpu_s); },
                                  .part = Part::cost,
                                  .is_column = false};

constinit const Quantity force_residual{
    .key = "max_force_residual_ratio",
    .name = "worst force balance",
    .meaning =
        "Largest difference of the tractions' resultants and the applied forces over F_N or "
        "what friction carries.",
    .of =
        [](const Subject& s) {
            double worst = 0;
            for (const auto& step : s.history.steps) worst = std::max(worst, step.force_residual);
            return finite(worst);
        },
    .part = Part::cost};

}  // namespace

constinit const Quantity steps{
    .key = "steps",
    .name = "steps",
    .meaning = "Quasi-static steps that were taken.",
    .of = [](const Subject& s) { return QuantityValue(static_cast<int>(s.history.steps.size())); },
    .part = Part::cost};

constinit const Quantity wall_time{.key = "wall_s",
                                   .unit = "s",
                                   .name = "time on the clock",
                                   .meaning = "Time on the clock of the run.",
                                   .of = [](const Subject& s) { return finite(s.history.wall_s); },
                                   .is_column = false};

List of_cost() {
    return {&steps, &cpu_time, &wall_time, &force_residual};
}

}  // namespace tricontact::comparisons::quantities
