#include <string>

#include "report/json_number.h"
#include "walking/machine/stable_step.h"
#include "walking/report/walk_document.h"
#include "walking/run/drive_load.h"

namespace tricontact::walking {

namespace {

using Json = nlohmann::ordered_json;

// A number of each spot: name_1, name_2 ...
void add_spots(Json& json, const std::string& name, const WalkResult& result,
               double WalkResult::Spot::*member) {
    for (std::size_t i = 0; i < result.spots.size(); ++i)
        json[name + '_' + std::to_string(i + 1)] = report::number(result.spots[i].*member);
}

void add_statistics(Json& json, const WalkResult& result) {
    json["regime"] = word_of(result.regime);
    json["mu_e"] = report::number(result.mu_e);
    json["mu_e_error"] = report::number(result.mu_e_error);
    json["period"] = report::number(result.period);
    json["period_error"] = result.period ? report::number(result.period_error) : Json();
    json["section_points"] = result.period ? Json(result.section_points) : Json();
    json["z_min_ratio"] = report::number(result.z_min_ratio);
    json["z_max_ratio"] = report::number(result.z_max_ratio);
    add_spots(json, "stick_time", result, &WalkResult::Spot::stick_time);
    add_spots(json, "correlation", result, &WalkResult::Spot::correlation);
    json["kinetic_energy"] = report::number(result.kinetic_energy);
    json["phi_min"] = report::number(result.phi_min);
    json["phi_max"] = report::number(result.phi_max);
    json["transient"] = report::number(result.transient);
    json["transient_over"] = result.transient_over;
    json["observed"] = report::number(result.observed);
    json["tilting_time"] = report::number(result.tilting_time);
    json["lyapunov"] = result.lyapunov ? report::number(result.lyapunov->value) : Json();
    json["lyapunov_error"] = result.lyapunov ? report::number(result.lyapunov->error) : Json();
}

// Times from the turning point on, where the cycle's elastic energy is largest.
Json phases_json(const WalkPhases& phases) {
    const auto after = [&](double time) { return report::number(time - phases.turning_point); };
    return {{"sticking", after(phases.sticking)},
            {"release", after(phases.release)},
            {"jump", after(phases.jump)},
            {"landing", after(phases.landing)},
            {"jump_height", report::number(phases.jump_height)},
            {"airborne", report::number(phases.airborne)},
            {"airborne_advance", report::number(phases.airborne_advance)}};
}

Json drift_json(const WalkResult::Drift& drift) {
    return {{"per_period", report::number(drift.per_period)},
            {"error", report::number(drift.error)},
            {"airborne", report::number(drift.airborne)}};
}

Json machine_json(const Machine& machine) {
    const auto& k = machine.kappas;
    Json kappas;
    int i = 0;
    for (const double kappa :
         {k.kappa1, k.kappa2, k.kappa3, k.kappa4, k.kappa5, k.kappa6, k.kappa7, k.kappa8})
        kappas["kappa" + std::to_string(++i)] = kappa;
    return {{"kappas", kappas},
            {"static_displacement", report::number(static_displacement(machine))},
            {"critical_friction", report::number(critical_friction(machine))},
            {"loading_time", report::number(loading_time(machine))},
            {"stable_step", report::number(stable_step(machine))}};
}

Json dimensional_json(const WalkCase& walk_case, const WalkResult& result) {
    if (!walk_case.dimensional) return nullptr;
    const auto& machine = *walk_case.dimensional;
    const double tau = characteristic_time(machine);
    const auto in_seconds = [&](std::optional<double> time) {
        return time ? report::number(*time * tau) : Json();
    };
    const double sliding = sliding_force(walk_case.machine) * force_unit(machine);
    return {{"characteristic_time_s", tau},
            {"period_s", in_seconds(result.period)},
            {"frequency_Hz", result.period ? report::number(1 / (*result.period * tau)) : Json()},
            {"transient_s", in_seconds(result.transient)},
            {"observed_s", in_seconds(result.observed)},
            {"tilting_time_s", in_seconds(result.tilting_time)},
            {"mean_spring_force_N", report::number(result.mu_e * sliding)},
            {"static_displacement_m",
             report::number(static_displacement(walk_case.machine) * machine.half_width)}};
}

}  // namespace

Json walk_json(const WalkCase& walk_case, const Walk& walk) {
    Json json;
    add_statistics(json, walk.result);
    json["phases"] = walk.phases ? phases_json(*walk.phases) : Json();
    json["drift"] = walk.result.drift ? drift_json(*walk.result.drift) : Json();
    json["machine"] = machine_json(walk_case.machine);
    json["dimensional"] = dimensional_json(walk_case, walk.result);
    json["lane_steps"] = walk.lane_steps;
    json["cpu_s"] = report::number(walk.cpu_s);
    json["lane_steps_per_s"] =
        report::number(walk.cpu_s > 0 ? static_cast<double>(walk.lane_steps) / walk.cpu_s : 0);
    return json;
}

}  // namespace tricontact::walking
