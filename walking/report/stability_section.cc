#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "report/format.h"
#include "walking/machine/linear_stability.h"
#include "walking/machine/steady_sliding.h"
#include "walking/report/walk_document.h"

namespace tricontact::walking {

namespace {

// Eigenvalues are of the order of 1: what is less grows or decays by rounding.
constexpr double neutral = 1e-9;

double frequency(const std::complex<double>& eigenvalue) {
    return eigenvalue.imag() / (2 * std::numbers::pi);
}

std::string how_it_grows(const std::complex<double>& leading) {
    const std::string rate = report::significant(leading.real(), 3);
    if (leading.real() <= neutral) return "";
    return leading.imag() > neutral
               ? fmt::format(
                     "flutters: small disturbances grow as exp({} t) at {} cycles per √(m/k_x)",
                     rate, report::significant(frequency(leading), 3))
               : fmt::format("diverges: small disturbances grow as exp({} t)", rate);
}

}  // namespace

SlidingStability sliding_stability(const Machine& machine) {
    const auto motion = steady_sliding(machine);
    if (!motion) return {};
    SlidingStability stability{true, {}};
    for (const std::complex<double>& value : sliding_eigenvalues(machine, *motion))
        if (value.imag() >= -neutral) stability.eigenvalues.push_back(value);
    const auto grows_faster = [](const auto& a, const auto& b) { return a.real() > b.real(); };
    std::sort(stability.eigenvalues.begin(), stability.eigenvalues.end(), grows_faster);
    return stability;
}

bool is_neutral(const SlidingStability& stability) {
    return !stability.eigenvalues.empty() &&
           std::abs(stability.eigenvalues.front().real()) <= neutral;
}

report::Verdict stability_verdict(const WalkReport& report, const SlidingStability& stability) {
    constexpr auto finding = report::Verdict::Standing::finding;
    if (!stability.exists)
        return {finding,
                "There is no steady sliding: the moments about the centre of gravity lift "
                "the trailing spot off."};
    if (stability.eigenvalues.empty()) return {finding, "Steady sliding cannot be disturbed."};
    const std::complex<double>& leading = stability.eigenvalues.front();
    if (leading.real() > neutral) return {finding, "Steady sliding " + how_it_grows(leading) + "."};
    std::string text = leading.real() < -neutral
                           ? "Steady sliding is stable: small disturbances decay."
                           : "Steady sliding is linearly neutral: small disturbances neither grow "
                             "nor decay.";
    const Regime regime = report.walk.result.regime;
    if (regime == Regime::limit_cycle || regime == Regime::chaotic)
        text += " What vibrates here was set off by one that made a spot stick or lift off.";
    return {finding, text};
}

report::DocumentSection stability_section(const SlidingStability& stability) {
    report::DocumentTable table{
        .id = "eigenvalues",
        .title = "Eigenvalues of steady sliding",
        .note =
            "A disturbance while all spots slip forwards grows as exp(growth t); "
            "frequency in cycles per √(m/k_x).",
        .columns = {{"growth [√(k_x/m)]"}, {"frequency [√(k_x/m)]"}}};
    for (const std::complex<double>& value : stability.eigenvalues) {
        std::vector<report::Cell>& row = table.rows.emplace_back();
        // Rounding is no growth.
        row.emplace_back(std::abs(value.real()) > neutral ? value.real() : 0.);
        row.emplace_back(std::max(0., frequency(value)));
    }
    return {.id = "stability", .heading = "Linear stability of steady sliding", .tables = {table}};
}

}  // namespace tricontact::walking
