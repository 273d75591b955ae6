#include <fmt/format.h>

#include "experiments/identification/identification_report.h"
#include "io/keys/messages.h"
#include "report/format.h"

namespace tricontact::experiments {

std::string posterior_sentence(const IdentifiedModel& model) {
    const Posterior& p = *model.posterior;
    std::string text = model.name + ": posterior";
    if (model.found.young)
        text += fmt::format(" E = {} ({} to {})", report::quantity(p.median.young, "Pa", 3),
                            report::quantity(p.interval.young.low, "Pa", 3),
                            report::quantity(p.interval.young.high, "Pa", 3));
    if (model.found.friction)
        text += fmt::format("{} mu = {} ({} to {})", model.found.young ? "," : "",
                            report::significant(p.median.friction, 3),
                            report::significant(p.interval.friction.low, 3),
                            report::significant(p.interval.friction.high, 3));
    if (p.correlation) text += ", correlation " + report::significant(*p.correlation, 2);
    return text + fmt::format(
                      "; as good as {:.0f} independent points (autocorrelation time {:.0f} steps, "
                      "{:.0f} % accepted).",
                      p.effective_size, p.autocorrelation_time, 100 * p.acceptance);
}

std::string posterior_csv(const IdentificationStudy& study) {
    std::string text = "model,young_Pa,friction_coefficient\n";
    for (const IdentifiedModel& model : study.models)
        if (model.posterior)
            for (const Properties& point : model.posterior->points)
                text += fmt::format("{},{},{}\n", model.name, io::shortest(point.young),
                                    io::shortest(point.friction));
    return text;
}

}  // namespace tricontact::experiments
