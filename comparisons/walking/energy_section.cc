#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "comparisons/format.h"
#include "comparisons/walking/walk_document.h"
#include "dynamics/velocity_verlet.h"
#include "dynamics/verlet_energy.h"

namespace tricontact::comparisons::walking {

std::optional<EnergyStretch> energy_of(const WalkReport& report) {
    constexpr double without_period = 100;
    const dynamics::Walk& walk = report.walk;
    if (walk.result.regime == dynamics::Regime::tilting) return std::nullopt;
    dynamics::VelocityVerlet run(report.walk_case.machine, walk.last, report.walk_case.time.step);
    dynamics::VerletEnergy energy(run);
    const double wanted = walk.result.period.value_or(without_period);
    const auto n_steps = std::max(1LL, std::llround(wanted / run.step()));
    for (long long i = 0; i < n_steps; ++i) {
        run.advance();
        energy.add_step();
    }
    EnergyStretch stretch{energy.balance(), static_cast<double>(n_steps) * run.step(), 0};
    const dynamics::EnergyBalance& b = stretch.balance;
    for (const double each : {b.base, b.excitation, b.dissipation, b.stored})
        stretch.scale = std::max(stretch.scale, std::abs(each));
    return stretch.scale > 0 ? std::optional(stretch) : std::nullopt;
}

Verdict energy_verdict(const WalkReport& report, const EnergyStretch& energy) {
    constexpr double bound = 1e-6;
    const double lost = std::abs(energy.balance.residual()) / energy.scale;
    const bool holds = lost <= bound;
    return {holds ? Verdict::Standing::holds : Verdict::Standing::fails,
            fmt::format("Energy over {}: work of {} and geometric work = dissipation + change of "
                        "stored energy, to {} of the greatest of them{}. The geometric work, of "
                        "moments without potential in the model's equations, is {} of it.",
                        report.walk.result.period ? "a period" : significant(energy.length, 3),
                        energy.balance.excitation != 0 ? "base, excitation" : "the base",
                        significant(lost, 2), holds ? "" : "; a smaller [time] step makes it less",
                        significant(std::abs(energy.balance.geometric) / energy.scale, 2))};
}

DocumentSection energy_section(const EnergyStretch& energy) {
    DocumentTable table{.id = "energy",
                        .title = fmt::format("Works over {} units of time from the end of the run",
                                             significant(energy.length, 4)),
                        .note =
                            "Geometric: moments of first order in φ to which no potential "
                            "belongs, a property of Wetter's (2016) eq. 4.1.19. Lost: where a "
                            "spot lands or lifts off within a step, by its square.",
                        .columns = {{"energy"}, {"[k_x b²]"}, {"share of the greatest"}}};
    const auto add = [&](const char* name, double value) {
        table.rows.push_back({name, value, value / energy.scale});
    };
    const dynamics::EnergyBalance& balance = energy.balance;
    add("work of the base", balance.base);
    if (balance.excitation != 0) add("work of the excitation", balance.excitation);
    add("geometric work", balance.geometric);
    add("dissipation", balance.dissipation);
    add("change of stored energy", balance.stored);
    add("lost by the integration", balance.residual());
    return {.id = "energy_section", .heading = "Energy", .tables = {table}};
}

}  // namespace tricontact::comparisons::walking
