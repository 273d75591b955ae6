#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "files/version.h"
#include "io/keys/toml_document.h"
#include "report/csv.h"
#include "report/format.h"
#include "report/json_number.h"
#include "walking/machine/linear_stability.h"
#include "walking/machine/motion.h"
#include "walking/report/walk_document.h"
#include "walking/run/walk_judge.h"

namespace tricontact::walking {

namespace {

// Names of the columns of each spot: name_1, name_2 ...
void add_names(std::vector<std::string>& fields, const std::vector<std::string>& names,
               std::size_t n_spots) {
    for (std::size_t i = 1; i <= n_spots; ++i)
        for (const std::string& name : names) fields.push_back(name + '_' + std::to_string(i));
}

void add(std::vector<std::string>& fields, std::initializer_list<double> values) {
    for (const double value : values) fields.push_back(report::csv_field(value));
}

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

using report::significant;
using report::with_error;

std::string line(const char* name, const std::string& value, const std::string& meaning) {
    // The width counts code points, which all have one column here.
    return fmt::format("{:<14} {:<22} {}\n", name, value, meaning);
}

// A time in its unit, and in seconds where there are some.
std::string with_seconds(const WalkCase& walk_case, double time) {
    if (!walk_case.dimensional) return "in sqrt(m/k_x)";
    const double tau = characteristic_time(*walk_case.dimensional);
    return "in sqrt(m/k_x): " + report::quantity(time * tau, "s");
}

std::string tilting_text(const WalkCase& walk_case, const WalkResult& result) {
    const double time = *result.tilting_time;
    return line("regime", std::string(word_of(result.regime)), "small rotations no longer") +
           line("tilting time", significant(time), with_seconds(walk_case, time)) +
           line("mu_c", significant(critical_friction(walk_case.machine)),
                "tilts above, sliding steadily");
}

}  // namespace

std::string windows_csv(const WalkCase& walk_case, const Walk& walk) {
    std::vector<std::string> fields{"begin",       "end",         "mu_e",    "kinetic_energy",
                                    "z_min_ratio", "z_max_ratio", "phi_min", "phi_max"};
    add_names(fields, {"stick_time", "correlation"}, spots_of(walk_case.machine).size());
    std::string text = report::csv_line(fields);
    for (const WalkWindow& window : walk.windows) {
        WalkResult mean;
        take_statistics(walk_case.machine, window.sums, mean);
        fields.clear();
        add(fields, {window.begin, window.end, mean.mu_e, mean.kinetic_energy, mean.z_min_ratio,
                     mean.z_max_ratio, mean.phi_min, mean.phi_max});
        for (const auto& [stick_time, correlation] : mean.spots)
            add(fields, {stick_time, correlation});
        text += report::csv_line(fields);
    }
    return text;
}

std::string motion_csv(const WalkCase& walk_case, const Walk& walk) {
    const Machine& machine = walk_case.machine;
    const auto& dimensional = walk_case.dimensional;
    const auto spots = spots_of(machine);
    std::vector<std::string> fields{"time",       "base",         "x",
                                    "z",          "phi",          "x_velocity",
                                    "z_velocity", "phi_velocity", "spring_force"};
    if (dimensional) fields.insert(fields.end(), {"time_s", "spring_force_N"});
    add_names(fields, {"normal_force", "tangential_force", "contact_state"}, spots.size());
    std::string text = report::csv_line(fields);
    for (const Snapshot& snapshot : walk.tail) {
        const Motion& m = snapshot.motion;
        const double pull = spring_force(machine, m);
        fields.clear();
        add(fields,
            {m.time, m.base, m.x, m.z, m.phi, m.x_velocity, m.z_velocity, m.phi_velocity, pull});
        if (dimensional)
            add(fields,
                {m.time * characteristic_time(*dimensional), pull * force_unit(*dimensional)});
        for (std::size_t i = 0; i < spots.size(); ++i) {
            const auto force = spot_force(machine, spots[i], m.spots[i]);
            add(fields, {force.normal, force.tangential});
            fields.push_back(std::to_string(static_cast<int>(snapshot.spots[i])));
        }
        text += report::csv_line(fields);
    }
    return text;
}

Json walk_json(const WalkCase& walk_case, const Walk& walk) {
    Json json;
    add_statistics(json, walk.result);
    json["phases"] = walk.phases ? phases_json(*walk.phases) : Json();
    const auto& drift = walk.result.drift;
    json["drift"] = drift ? Json{{"per_period", report::number(drift->per_period)},
                                 {"error", report::number(drift->error)},
                                 {"airborne", report::number(drift->airborne)}}
                          : Json();
    json["machine"] = machine_json(walk_case.machine);
    json["dimensional"] = dimensional_json(walk_case, walk.result);
    json["lane_steps"] = walk.lane_steps;
    json["cpu_s"] = report::number(walk.cpu_s);
    json["lane_steps_per_s"] =
        report::number(walk.cpu_s > 0 ? static_cast<double>(walk.lane_steps) / walk.cpu_s : 0);
    return json;
}

std::string walk_text(const WalkCase& walk_case, const Walk& walk) {
    const WalkResult& result = walk.result;
    if (result.regime == Regime::tilting) return tilting_text(walk_case, result);
    std::string text =
        line("regime", std::string(word_of(result.regime)),
             result.transient_over ? "from t = " + significant(result.transient) + " on"
                                   : "as far as the run goes");
    if (result.period) {
        text += line("period", with_error(*result.period, result.period_error, 6),
                     with_seconds(walk_case, *result.period));
        if (const auto& machine = walk_case.dimensional)
            text += line(
                "frequency",
                report::quantity(1 / (*result.period * characteristic_time(*machine)), "Hz"), "");
    }
    if (result.regime == Regime::sticking)
        text += line("loaded", "t = " + significant(loading_time(walk_case.machine), 3),
                     "at the earliest; until then there is no mu_e");
    else
        text += line("mu_e", with_error(result.mu_e, result.mu_e_error),
                     "<f_s> over that of sliding, 95 % interval");
    if (result.drift)
        text += line("drift", with_error(result.drift->per_period, result.drift->error),
                     "shift of the base per period, over mu kappa2 z_stat");
    text += line("z_min, z_max",
                 significant(result.z_min_ratio) + ", " + significant(result.z_max_ratio),
                 "over the static displacement");
    text += line("phi", significant(result.phi_min, 3) + ", " + significant(result.phi_max, 3),
                 "extremes");
    for (std::size_t i = 0; i < result.spots.size(); ++i)
        text += line(fmt::format("spot {}", i + 1).c_str(),
                     "sticks " + significant(result.spots[i].stick_time) + ", r " +
                         significant(result.spots[i].correlation),
                     "share of time, correlation of velocity and load");
    text += line("kinetic energy", significant(result.kinetic_energy),
                 "mean over m g times the static displacement");
    if (result.lyapunov)
        text += line("lyapunov", with_error(result.lyapunov->value, result.lyapunov->error),
                     "largest exponent; above 0: chaos");
    if (!result.transient_over)
        text += "the transient is not over at the end of the run: take a later time.end\n";
    return text;
}

std::vector<report::DerivedValue> walk_scales(const WalkCase& c) {
    std::vector<report::DerivedValue> values;
    if (c.dimensional) {
        const Kappas& k = c.machine.kappas;
        values = {
            {"k_x", c.dimensional->tangential_stiffness, "N/m", "of a contact spot"},
            {"k_z", c.dimensional->normal_stiffness, "N/m", "of a contact spot"},
            {"tau", characteristic_time(*c.dimensional), "s", "sqrt(m/k_x), the unit of time"},
            {"kappa1", k.kappa1, "1", "k_s/k_x"},
            {"kappa2", k.kappa2, "1", "k_z/k_x"},
            {"kappa3", k.kappa3, "1", "a/b"},
            {"kappa4", k.kappa4, "1", "m g/(k_x b)"},
            {"kappa5", k.kappa5, "1", "mu"},
            {"kappa6", k.kappa6, "1", "(v_0/b) sqrt(m/k_x)"},
            {"kappa7", k.kappa7, "1", "Theta/(m b^2)"},
            {"kappa8", k.kappa8, "1", "h/a"}};
    }
    values.push_back({"z_stat", static_displacement(c.machine), "1", "static displacement over b"});
    values.push_back({"mu_c", critical_friction(c.machine), "1", "tilts above, sliding steadily"});
    values.push_back({"dt_max", stable_step(c.machine), "1", "stable limit of time.step"});
    values.push_back({"end", c.time.end, "1", "of the run, in units of sqrt(m/k_x)"});
    return values;
}

std::string walk_summary(const WalkCase& walk_case, const std::string& resolved, const Walk& walk) {
    nlohmann::ordered_json json{{"version", files::version}, {"case", io::case_json(resolved)}};
    json.update(walk_json(walk_case, walk));
    return json.dump(2) + '\n';
}

}  // namespace tricontact::walking
