#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "report/format.h"
#include "walking/machine/energy.h"
#include "walking/machine/linear_stability.h"
#include "walking/machine/velocity_verlet.h"
#include "walking/report/walk_document.h"

namespace tricontact::walking {

namespace {

// Eigenvalues are of the order of 1: what is less grows or decays by rounding.
constexpr double neutral = 1e-9;

double frequency(const std::complex<double>& eigenvalue) {
    return eigenvalue.imag() / (2 * std::numbers::pi);
}

}  // namespace

std::optional<EnergyStretch> energy_of(const WalkReport& report) {
    constexpr double without_period = 100;
    const Walk& walk = report.walk;
    if (walk.result.regime == Regime::tilting) return std::nullopt;
    VelocityVerlet run(report.walk_case.machine, walk.last, report.walk_case.time.step);
    const double wanted = walk.result.period.value_or(without_period);
    const auto n_steps = std::max(1LL, std::llround(wanted / run.step()));
    EnergyStretch stretch{verlet_balance(run, n_steps), static_cast<double>(n_steps) * run.step(),
                          0};
    const EnergyBalance& b = stretch.balance;
    stretch.scale = std::max(
        {std::abs(b.base), std::abs(b.excitation), std::abs(b.dissipation), std::abs(b.stored)});
    return stretch.scale > 0 ? std::optional(stretch) : std::nullopt;
}

report::Verdict energy_verdict(const WalkReport& report, const EnergyStretch& energy) {
    constexpr double bound = 1e-6;
    const double lost = std::abs(energy.balance.residual()) / energy.scale;
    const bool holds = lost <= bound;
    return {holds ? report::Verdict::Standing::pass : report::Verdict::Standing::fail,
            fmt::format(
                "Energy over {}: work of {} and geometric work = dissipation + change of stored "
                "energy, to {} of the greatest of them{}. The geometric work, of moments without "
                "potential in the model's equations, is {} of it.",
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
            "Geometric: moments of first order in φ to which no potential belongs, a property of "
            "Wetter's (2016) eq. 4.1.19. Lost: where a spot lands or lifts off within a step, by "
            "its square.",
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

Eigenvalues sliding_stability(const Machine& machine) {
    const auto motion = steady_sliding(machine);
    if (!motion) return {};
    Eigenvalues values = sliding_eigenvalues(machine, *motion);
    std::erase_if(values, [](const auto& value) { return value.imag() < -neutral; });
    std::ranges::sort(values, std::ranges::greater{}, [](const auto& v) { return v.real(); });
    return values;
}

bool is_neutral(const Eigenvalues& stability) {
    return !stability.empty() && std::abs(stability.front().real()) <= neutral;
}

report::Verdict stability_verdict(const WalkReport& report, const Eigenvalues& stability) {
    if (stability.empty())
        return {.sentence =
                    "There is no steady sliding: the moments about the centre of gravity lift the "
                    "trailing spot off."};
    const std::complex<double>& leading = stability.front();
    if (leading.real() > neutral) {
        const std::string rate = report::significant(leading.real(), 3);
        if (leading.imag() <= neutral)
            return {.sentence = fmt::format(
                        "Steady sliding diverges: small disturbances grow as exp({} t).", rate)};
        return {.sentence = fmt::format("Steady sliding flutters: small disturbances grow as "
                                        "exp({} t) at {} cycles per √(m/k_x).",
                                        rate, report::significant(frequency(leading), 3))};
    }
    std::string text =
        leading.real() < -neutral
            ? "Steady sliding is stable: small disturbances decay."
            : "Steady sliding is linearly neutral: small disturbances neither grow nor decay.";
    const Regime regime = report.walk.result.regime;
    if (regime == Regime::limit_cycle || regime == Regime::chaotic)
        text += " What vibrates here was set off by one that made a spot stick or lift off.";
    return {.sentence = text};
}

report::DocumentSection stability_section(const Eigenvalues& stability) {
    report::DocumentTable table{.id = "eigenvalues",
                                .title = "Eigenvalues of steady sliding",
                                .note =
                                    "A disturbance while all spots slip forwards grows as "
                                    "exp(growth t); frequency in cycles per √(m/k_x).",
                                .columns = {{"growth [√(k_x/m)]"}, {"frequency [√(k_x/m)]"}}};
    for (const std::complex<double>& value : stability)  // rounding is no growth
        table.rows.push_back(
            {std::abs(value.real()) > neutral ? value.real() : 0., std::max(0., frequency(value))});
    return {.id = "stability", .heading = "Linear stability of steady sliding", .tables = {table}};
}

}  // namespace tricontact::walking
