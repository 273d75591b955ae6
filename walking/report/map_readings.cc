#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>

#include "report/base64.h"
#include "report/format.h"
#include "walking/report/map_json.h"
#include "walking/study/motion_class.h"

namespace tricontact::walking {

namespace {

const std::string dash = "–";

/// "0.427, 0.493": of all spots.
std::string of_spots(const WalkResult& result, double WalkResult::Spot::*member) {
    std::string text;
    for (const WalkResult::Spot& spot : result.spots)
        text += (text.empty() ? "" : ", ") + report::significant(spot.*member, 3);
    return text.empty() ? dash : text;
}

std::string transient(const WalkResult& result) {
    return result.transient_over ? "until t = " + report::significant(result.transient, 4)
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
    const std::string limit = report::significant(critical_friction(map, kappa8), 4);
    const std::string motion = words_of(motion_class(result));
    if (result.regime == Regime::tilting) {
        const std::string when =
            result.tilting_time ? " at t = " + report::significant(*result.tilting_time, 4) : "";
        return {motion + when, dash, dash, dash, dash, dash, dash, limit};
    }
    return {
        motion,
        report::with_error(result.mu_e, result.mu_e_error),
        report::significant(result.period, 5),
        report::significant(result.z_min_ratio) + ", " + report::significant(result.z_max_ratio),
        of_spots(result, &WalkResult::Spot::stick_time),
        of_spots(result, &WalkResult::Spot::correlation),
        transient(result),
        limit};
}

double critical_friction(const WalkMap& map, double kappa8) {
    Machine machine{.kappas = map.kappas, .model = map.model};
    machine.kappas.kappa8 = kappa8;
    return critical_friction(machine);
}

PackedSamples packed(std::span<const float> samples) {
    if (samples.empty()) return {};
    if (!std::all_of(samples.begin(), samples.end(), [](float x) { return std::isfinite(x); }))
        throw std::invalid_argument("a sample that is not finite cannot be packed");
    const auto [low, high] = std::minmax_element(samples.begin(), samples.end());
    constexpr double most = 32767;
    PackedSamples result;
    result.offset = (static_cast<double>(*low) + *high) / 2;
    result.scale = (static_cast<double>(*high) - *low) / (2 * most);
    std::string bytes;
    for (const double sample : samples) {
        const double whole =
            result.scale > 0 ? std::round((sample - result.offset) / result.scale) : 0;
        const auto bits =
            static_cast<std::uint16_t>(static_cast<std::int16_t>(std::clamp(whole, -most, most)));
        bytes += static_cast<char>(bits & 0xff);
        bytes += static_cast<char>(bits >> 8);
    }
    result.base64 = report::base64(bytes);
    return result;
}

}  // namespace tricontact::walking
