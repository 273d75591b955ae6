#include "walking/report/walk_text.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "files/version.h"
#include "io/results/case_json.h"
#include "report/format.h"
#include "walking/machine/stable_step.h"
#include "walking/report/walk_document.h"
#include "walking/run/drive_load.h"

namespace tricontact::walking {

namespace {

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
    const double time = result.tilting_time.value_or(0);
    return line("regime", std::string(word_of(result.regime)), "small rotations no longer") +
           line("tilting time", significant(time), with_seconds(walk_case, time)) +
           line("mu_c", significant(critical_friction(walk_case.machine)),
                "tilts above, sliding steadily");
}

std::string period_text(const WalkCase& walk_case, const WalkResult& result) {
    if (!result.period) return {};
    std::string text = line("period", with_error(*result.period, result.period_error, 6),
                            with_seconds(walk_case, *result.period));
    if (walk_case.dimensional) {
        const double tau = characteristic_time(*walk_case.dimensional);
        text += line("frequency", report::quantity(1 / (*result.period * tau), "Hz"), "");
    }
    return text;
}

std::string drift_text(const WalkResult& result) {
    if (!result.drift) return {};
    return line("drift", with_error(result.drift->per_period, result.drift->error),
                "shift of the base per period, over mu kappa2 z_stat");
}

std::string spots_text(const WalkResult& result) {
    std::string text;
    for (std::size_t i = 0; i < result.spots.size(); ++i)
        text += line(fmt::format("spot {}", i + 1).c_str(),
                     "sticks " + significant(result.spots[i].stick_time) + ", r " +
                         significant(result.spots[i].correlation),
                     "share of time, correlation of velocity and load");
    return text;
}

}  // namespace

std::string walk_text(const WalkCase& walk_case, const Walk& walk) {
    const WalkResult& result = walk.result;
    if (result.regime == Regime::tilting) return tilting_text(walk_case, result);
    std::string text =
        line("regime", std::string(word_of(result.regime)),
             result.transient_over ? "from t = " + significant(result.transient) + " on"
                                   : "as far as the run goes");
    text += period_text(walk_case, result);
    if (result.regime == Regime::sticking)
        text += line("loaded", "t = " + significant(loading_time(walk_case.machine), 3),
                     "at the earliest; until then there is no mu_e");
    else
        text += line("mu_e", with_error(result.mu_e, result.mu_e_error),
                     "<f_s> over that of sliding, 95 % interval");
    text += drift_text(result);
    text += line("z_min, z_max",
                 significant(result.z_min_ratio) + ", " + significant(result.z_max_ratio),
                 "over the static displacement");
    text += line("phi", significant(result.phi_min, 3) + ", " + significant(result.phi_max, 3),
                 "extremes");
    text += spots_text(result);
    text += line("kinetic energy", significant(result.kinetic_energy),
                 "mean over m g times the static displacement");
    if (result.lyapunov)
        text += line("lyapunov", with_error(result.lyapunov->value, result.lyapunov->error),
                     "largest exponent; above 0: chaos");
    if (!result.transient_over)
        text += "the transient is not over at the end of the run: take a later time.end\n";
    return text;
}

std::string walk_scales_text(const WalkCase& c) {
    std::string text = "# What follows from it (Wetter (2016), chapter 4)\n";
    auto line = [&](const char* name, double value, const char* unit, const char* meaning) {
        text += fmt::format("# {:<8} = {:>12.6g} {:<4} {}\n", name, value, unit, meaning);
    };
    if (c.dimensional) {
        const Kappas& k = c.machine.kappas;
        line("k_x", c.dimensional->tangential_stiffness, "N/m", "of a contact spot");
        line("k_z", c.dimensional->normal_stiffness, "N/m", "of a contact spot");
        line("tau", characteristic_time(*c.dimensional), "s", "sqrt(m/k_x), the unit of time");
        line("kappa1", k.kappa1, "-", "k_s/k_x");
        line("kappa2", k.kappa2, "-", "k_z/k_x");
        line("kappa3", k.kappa3, "-", "a/b");
        line("kappa4", k.kappa4, "-", "m g/(k_x b)");
        line("kappa5", k.kappa5, "-", "mu");
        line("kappa6", k.kappa6, "-", "(v_0/b) sqrt(m/k_x)");
        line("kappa7", k.kappa7, "-", "Theta/(m b^2)");
        line("kappa8", k.kappa8, "-", "h/a");
    }
    line("z_stat", static_displacement(c.machine), "-", "static displacement over b");
    line("mu_c", critical_friction(c.machine), "-", "tilts above, sliding steadily");
    line("dt_max", stable_step(c.machine), "-", "stable limit of time.step");
    line("end", c.time.end, "-", "of the run, in units of sqrt(m/k_x)");
    return text;
}

std::string walk_summary(const WalkCase& walk_case, const std::string& resolved, const Walk& walk) {
    nlohmann::ordered_json json{{"version", files::version}, {"case", io::case_json(resolved)}};
    json.update(walk_json(walk_case, walk));
    return json.dump(2) + '\n';
}

}  // namespace tricontact::walking
