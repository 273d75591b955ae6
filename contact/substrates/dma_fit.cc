#include "contact/substrates/dma_fit.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "contact/base/error.h"
#include "contact/base/special_values.h"
#include "contact/substrates/prony_fit.h"

namespace tricontact::contact {

namespace {

constexpr std::size_t fewest_rows = 4;

// G'' at the frequency of the table next to this one.
double loss_near(const DmaTable& table, double omega) {
    const auto it = std::lower_bound(table.omega.begin(), table.omega.end(), omega);
    const auto k = std::min<std::size_t>(it - table.omega.begin(), table.size() - 1);
    return table.loss[k];
}

PronyProblem problem_of(const DmaTable& table) {
    using Kind = PronyObservation::Kind;
    PronyProblem problem{
        .name = table.name,
        .observations = {},
        .lowest = table.omega.front(),
        .highest = table.omega.back(),
        .relaxed = table.storage.front(),
        .first_guess = [&table](double omega) { return loss_near(table, omega); },
        .most_terms = most_prony_terms(table.size(), table.omega.front(), table.omega.back())};
    for (std::size_t k = 0; k < table.size(); ++k) {
        problem.observations.push_back({Kind::storage, table.omega[k], table.storage[k]});
        problem.observations.push_back({Kind::loss, table.omega[k], table.loss[k]});
    }
    return problem;
}

void judge(DmaFit& fit) {
    const DmaTable& table = fit.table;
    double storage = 0, loss = 0;
    for (std::size_t k = 0; k < table.size(); ++k) {
        const auto modulus = fit.relaxed_modulus * fit.relaxation.dynamic_ratio(table.omega[k]);
        const double of_storage = modulus.real() / table.storage[k] - 1;
        const double of_loss = modulus.imag() / table.loss[k] - 1;
        storage += of_storage * of_storage;
        loss += of_loss * of_loss;
        for (const auto& [residual, is_loss] :
             {std::pair(of_storage, false), std::pair(of_loss, true)})
            if (std::abs(residual) > std::abs(fit.worst.residual))
                fit.worst = {residual, table.omega[k], is_loss};
    }
    fit.storage_rms = std::sqrt(storage / table.size());
    fit.loss_rms = std::sqrt(loss / table.size());
}

void check(const DmaTable& table) {
    const auto refuse = [&](std::size_t row, const std::string& what, double value,
                            const char* rule) {
        throw InputError(fmt::format("{}: row {}: {} = {:.6g}: {}; correct it", table.name, row + 1,
                                     what, value, rule));
    };
    if (table.size() < fewest_rows)
        throw InputError(
            fmt::format("{}: the number of rows is {}, but a fit needs at least {}; "
                        "measure at more frequencies, or give moduli and times",
                        table.name, table.size(), fewest_rows));
    for (std::size_t k = 0; k < table.size(); ++k) {
        for (const auto& [name, value] :
             {std::pair("omega", table.omega[k]), std::pair("G'", table.storage[k]),
              std::pair("G''", table.loss[k])})
            if (!is_positive_and_finite(value))
                refuse(k, name, value, "must be positive and finite");
        if (k > 0 && !(table.omega[k] > table.omega[k - 1]))
            refuse(k, "omega", table.omega[k], "frequencies must increase from row to row");
    }
}

}  // namespace

DmaFit fit_prony(const DmaTable& table) {
    check(table);
    const PronySeries series =
        best_series(problem_of(table), "measure at lower frequencies").series;
    DmaFit fit{.table = table,
               .relaxation = branches_of(series),
               .relaxed_modulus = series.relaxed,
               .storage_rms = 0,
               .loss_rms = 0,
               .worst = {}};
    judge(fit);
    return fit;
}

std::vector<std::string> remarks(const DmaFit& fit, double relaxed_modulus) {
    const std::size_t n = fit.relaxation.branches.size();
    std::vector<std::string> out{fmt::format(
        "{}: Prony series of {} term{} fitted to {} frequencies; residuals (root mean square) of "
        "G' {:.2g} %, of G'' {:.2g} %, the largest {:.2g} % of {} at {:.3g} Hz",
        fit.table.name, n, n == 1 ? "" : "s", fit.table.size(), 100 * fit.storage_rms,
        100 * fit.loss_rms, 100 * fit.worst.residual, fit.worst.loss ? "G''" : "G'",
        fit.worst.omega / (2 * std::numbers::pi))};
    if (std::max(fit.storage_rms, fit.loss_rms) > poor_prony_rms)
        out.push_back(
            fmt::format("{}: poor fit: residuals above {:g} %; no relaxing solid with "
                        "positive moduli has this table, or its frequencies are too far "
                        "apart",
                        fit.table.name, 100 * poor_prony_rms));
    const double error = fit.relaxed_modulus / relaxed_modulus - 1;
    if (std::abs(error) > largest_modulus_error)
        out.push_back(
            fmt::format("{}: the table's relaxed shear modulus {:.4g} Pa differs by "
                        "{:+.1f} % from the case's {:.4g} Pa, to which its shape is "
                        "applied",
                        fit.table.name, fit.relaxed_modulus, 100 * error, relaxed_modulus));
    return out;
}

}  // namespace tricontact::contact
