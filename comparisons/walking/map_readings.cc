#include "comparisons/walking/map_readings.h"

#include <fmt/format.h>

#include "comparisons/format.h"
#include "comparisons/walking/motion_class.h"

namespace tricontact::comparisons::walking {

namespace {

using dynamics::WalkResult;

const std::string undefined = "–";

/// "0.427, 0.493": of all spots.
std::string of_spots(const WalkResult& result, double WalkResult::Spot::*member) {
    std::string text;
    for (const WalkResult::Spot& spot : result.spots)
        text += (text.empty() ? "" : ", ") + significant(spot.*member, 3);
    return text.empty() ? undefined : text;
}

std::string transient(const WalkResult& result) {
    return result.transient_over ? "until t = " + significant(result.transient, 4)
                                 : "not over at the end: the run is too short";
}

}  // namespace

const std::vector<std::string>& map_reading_names() {
    static const std::vector<std::string> names{
        "motion",      "μ_e",          "period",    "z_min, z_max [z_stat]",
        "stick times", "correlations", "transient", "μ_c"};
    return names;
}

std::vector<std::string> map_readings(const WalkMap& map, double kappa8, const WalkResult& result) {
    const std::string limit = significant(critical_friction(map, kappa8), 4);
    const std::string motion = words_of(motion_class(result));
    if (result.regime == dynamics::Regime::tilting) {
        const std::string when =
            result.tilting_time ? " at t = " + significant(*result.tilting_time, 4) : "";
        return {motion + when, undefined, undefined, undefined,
                undefined,     undefined, undefined, limit};
    }
    return {motion,
            with_error(result.mu_e, result.mu_e_error),
            significant(result.period, 5),
            significant(result.z_min_ratio) + ", " + significant(result.z_max_ratio),
            of_spots(result, &WalkResult::Spot::stick_time),
            of_spots(result, &WalkResult::Spot::correlation),
            transient(result),
            limit};
}

double critical_friction(const WalkMap& map, double kappa8) {
    dynamics::Machine machine{.kappas = map.kappas, .model = map.model};
    machine.kappas.kappa8 = kappa8;
    return dynamics::critical_friction(machine);
}

}  // namespace tricontact::comparisons::walking
