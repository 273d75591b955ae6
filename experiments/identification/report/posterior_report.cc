#include <fmt/format.h>

#include "experiments/identification/identification_report.h"
#include "io/keys/messages.h"
#include "report/format.h"

namespace tricontact::experiments {

std::string posterior_sentence(const IdentifiedModel& model) {
    const Posterior& p = *model.posterior;
    std::string text = model.name + ": posterior";
    for (std::size_t k = 0; k < model.found.free.size(); ++k) {
        const FreeParameter& one = model.found.free[k];
        text += fmt::format("{} {} = {}", k == 0 ? "" : ",", one.symbol,
                            one.shown(p.median[k], p.interval[k].low, p.interval[k].high));
    }
    if (p.median.size() == 2)
        text += ", correlation " + report::significant(p.correlation[0][1], 2);
    return text + fmt::format(
                      "; as good as {:.0f} independent points (autocorrelation time {:.0f} steps, "
                      "{:.0f} % accepted).",
                      p.effective_size, p.autocorrelation_time, 100 * p.acceptance);
}

std::string posterior_csv(const IdentificationStudy& study) {
    std::string text = "model";
    for (const FreeParameter& p : study.input.parameters) text += "," + p.name;
    text += '\n';
    for (const IdentifiedModel& model : study.models) {
        if (!model.posterior) continue;
        for (const auto& point : model.posterior->points) {
            text += model.name;
            for (const FreeParameter& p : study.input.parameters) {
                const auto k = model.found.find(p.key, p.index);
                text += "," + (k ? io::shortest(point[*k]) : "");
            }
            text += '\n';
        }
    }
    return text;
}

}  // namespace tricontact::experiments
