#include "contact/substrates/relaxation_test.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "contact/base/between_rows.h"
#include "contact/base/error.h"
#include "contact/base/special_values.h"
#include "contact/substrates/prony_fit.h"

namespace tricontact::contact {

namespace {

constexpr std::size_t fewest_test_rows = 4;

double earliest(const RelaxationTest& table) {
    return table.time.front() > 0 ? table.time.front() : table.time[1];
}

// Between the rows of the table linear in the time.
double modulus_near(const RelaxationTest& table, double time) {
    return between_rows(table.time, table.modulus,
                        std::clamp(time, table.time.front(), table.time.back()));
}

PronyProblem test_problem(const RelaxationTest& table) {
    const double lowest = 1 / table.time.back(), highest = 1 / earliest(table);
    // What relaxes within half a decade on either side of a time, but something.
    const auto first_guess = [&table](double omega) {
        const double half = std::sqrt(10.);
        const double drop =
            modulus_near(table, 1 / omega / half) - modulus_near(table, half / omega);
        return std::max(drop, 1e-3 * table.modulus.front());
    };
    PronyProblem problem{.name = table.name,
                         .observations = {},
                         .lowest = lowest,
                         .highest = highest,
                         .relaxed = table.modulus.back(),
                         .first_guess = first_guess,
                         // A row has one modulus here: 2 n + 1 parameters need as many rows.
                         .most_terms = std::min(most_prony_terms(table.size(), lowest, highest),
                                                (table.size() - 1) / 2)};
    for (std::size_t k = 0; k < table.size(); ++k)
        problem.observations.push_back(
            {PronyObservation::Kind::relaxing, table.time[k], table.modulus[k]});
    return problem;
}

void judge_test(RelaxationTestFit& fit) {
    double squares = 0;
    for (std::size_t k = 0; k < fit.table.size(); ++k) {
        const double residual = fit.modulus(fit.table.time[k]) / fit.table.modulus[k] - 1;
        squares += residual * residual;
        if (std::abs(residual) <= std::abs(fit.worst_residual)) continue;
        fit.worst_residual = residual;
        fit.worst_time = fit.table.time[k];
    }
    fit.rms = std::sqrt(squares / static_cast<double>(fit.table.size()));
}

void check_test(const RelaxationTest& table) {
    const auto refuse = [&](std::size_t row, const char* what, double value, const char* rule) {
        throw InputError(fmt::format("{}: row {}: {} = {:.6g}: {}; correct it", table.name, row + 1,
                                     what, value, rule));
    };
    if (table.size() < fewest_test_rows)
        throw InputError(
            fmt::format("{}: the number of rows is {}, but a fit needs at least {}; "
                        "measure at more times, or give moduli and times",
                        table.name, table.size(), fewest_test_rows));
    for (std::size_t k = 0; k < table.size(); ++k) {
        if (!(table.time[k] >= 0) || !std::isfinite(table.time[k]))
            refuse(k, "time", table.time[k], "must not be negative");
        if (!is_positive_and_finite(table.modulus[k]))
            refuse(k, table.symbol(), table.modulus[k], "must be positive and finite");
        if (k > 0 && !(table.time[k] > table.time[k - 1]))
            refuse(k, "time", table.time[k], "times must increase from row to row");
    }
}

}  // namespace

double RelaxationTestFit::modulus(double time) const {
    double ratio = 1;
    for (const auto& branch : relaxation.branches)
        ratio += branch.ratio * std::exp(-time / branch.time);
    return relaxed_modulus * ratio;
}

RelaxationTestFit fit_prony(const RelaxationTest& table) {
    check_test(table);
    const PronySeries series = best_series(test_problem(table), "measure for a longer time").series;
    RelaxationTestFit fit{
        .table = table, .relaxation = branches_of(series), .relaxed_modulus = series.relaxed};
    if (fit.relaxation.branches.empty())
        throw InputError(fmt::format(
            "{}: the modulus does not relax; leave out [substrate.relaxation]", table.name));
    judge_test(fit);
    return fit;
}

std::vector<std::string> remarks(const RelaxationTestFit& fit, double relaxed_modulus) {
    const std::size_t n = fit.relaxation.branches.size();
    const std::string symbol = fit.table.symbol();
    std::vector<std::string> out{fmt::format(
        "{}: Prony series of {} term{} fitted to {} times; residuals (root mean square) of {}(t) "
        "{:.2g} %, the largest {:.2g} % at {:.3g} s",
        fit.table.name, n, n == 1 ? "" : "s", fit.table.size(), symbol, 100 * fit.rms,
        100 * fit.worst_residual, fit.worst_time)};
    if (fit.rms > poor_prony_rms)
        out.push_back(fmt::format(
            "{}: poor fit: residuals above {:g} %; no relaxing solid with positive moduli has this "
            "table",
            fit.table.name, 100 * poor_prony_rms));
    const double error = fit.relaxed_modulus / relaxed_modulus - 1;
    if (std::abs(error) > largest_modulus_error)
        out.push_back(
            fmt::format("{}: the table's relaxed modulus {}_inf = {:.4g} Pa differs by {:+.1f} % "
                        "from the case's {:.4g} Pa, to which its shape is applied",
                        fit.table.name, symbol, fit.relaxed_modulus, 100 * error, relaxed_modulus));
    return out;
}

}  // namespace tricontact::contact
