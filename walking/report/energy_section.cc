#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "report/format.h"
#include "walking/machine/velocity_verlet.h"
#include "walking/machine/verlet_energy.h"
#include "walking/report/walk_document.h"

namespace tricontact::walking {

std::optional<EnergyStretch> energy_of(const WalkReport& report) {
    constexpr double without_period = 100;
    const Walk& walk = report.walk;
    if (walk.result.regime == Regime::tilting) return std::nullopt;
    VelocityVerlet run(report.walk_case.machine, walk.last, report.walk_case.time.step);
    VerletEnergy energy(run);
    const double wanted = walk.result.period.value_or(without_period);
    const auto n_steps = std::max(1LL, std::llround(wanted / run.step()));
    for (long long i = 0; i < n_steps; ++i) {
        run.advance();
        energy.add_step();
    }
    EnergyStretch stretch{energy.balance(), static_cast<double>(n_steps) * run.step(), 0};
    const EnergyBalance& b = stretch.balance;
    for (const double each : {b.base, b.excitation, b.dissipation, b.stored})
        stretch.scale = std::max(stretch.scale, std::abs(each));
    return stretch.scale > 0 ? std::optional(stretch) : std::nullopt;
}

report::Verdict energy_verdict(const WalkReport& report, const EnergyStretch& energy) {
    constexpr double bound = 1e-6;
    const double lost = std::abs(energy.balance.residual()) / energy.scale;
    const bool holds = lost <= bound;
    return {holds ? report::Verdict::Standing::holds : report::Verdict::Standing::fails,
            fmt::format(
                "Energy over {}: work of {} and geometric work = dissipation + change of "
                "stored energy, to {} of the greatest of them{}. The geometric work, of "
                "moments without potential in the model's equations, is {} of it.",
                report.walk.result.period ? "a period" : report::significant(energy.length, 3),
                energy.balance.excitation != 0 ? "base, excitation" : "the base",
                report::significant(lost, 2), holds ? "" : "; a smaller [time] step makes it less",
                report::significant(std::abs(energy.balance.geometric) / energy.scale, 2))};
}

report::DocumentSection energy_section(const EnergyStretch& energy) {
    report::DocumentTable table{
        .id = "energy",
        .title = fmt::format("Works over {} units of time from the end of the run",
                             report::significant(energy.length, 4)),
        .note =
            "Geometric: moments of first order in φ to which no potential "
            "belongs, a property of Wetter's (2016) eq. 4.1.19. Lost: where a "
            "spot lands or lifts off within a step, by its square.",
        .columns = {{"energy"}, {"[k_x b²]"}, {"share of the greatest"}}};
    const auto add = [&](const char* name, double value) {
        table.rows.push_back({name, value, value / energy.scale});
    };
    const EnergyBalance& balance = energy.balance;
    add("work of the base", balance.base);
    if (balance.excitation != 0) add("work of the excitation", balance.excitation);
    add("geometric work", balance.geometric);
    add("dissipation", balance.dissipation);
    add("change of stored energy", balance.stored);
    add("lost by the integration", balance.residual());
    return {.id = "energy_section", .heading = "Energy", .tables = {table}};
}

}  // namespace tricontact::walking
