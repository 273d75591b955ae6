#include "contact/substrates/dma_fit.h"

#include <fmt/format.h>
#include <gsl/gsl_blas.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_multifit_nlinear.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <optional>

#include "contact/error.h"
#include "contact/gsl.h"
#include "contact/special_values.h"

namespace tricontact::contact {

namespace {

constexpr std::size_t fewest_rows = 4;
// Relative residuals below this are rounding, not measurement: no reason for a further term.
constexpr double exact_rms = 1e-8;
constexpr double least_relaxed_ratio = 1e-6;   // G_inf/max G': below, the table is a fluid's
constexpr double equal_times = 1e-3;           // closer times [-] are one term
constexpr double poor_rms = 0.05;              // DMA scatters by a few per cent
constexpr double largest_modulus_error = 0.1;  // of the table against the case

constexpr std::size_t most_prony_steps = 500;

// Moduli and times of a Prony series, all positive: what the least squares of a fit vary.
struct PronySeries {
    double relaxed = 0;          // G_inf [Pa]
    std::vector<double> moduli;  // G_i [Pa]
    std::vector<double> times;   // tau_i [s]
};

struct PronyDescent {
    PronySeries series;
    double squares = 0;  // sum of the squared relative residuals of G' and G'' [-]
};

// ln tau is kept between its bounds by tau = exp(middle + half tanh(p)).
struct TimeBounds {
    double middle, half;

    double time(double p) const { return std::exp(middle + half * std::tanh(p)); }
    double slope(double p) const {  // d ln tau / dp
        const double t = std::tanh(p);
        return half * (1 - t * t);
    }
    double parameter(double time) const {
        // 0.99: tanh is flat at the bounds, from where no step leads back.
        return std::atanh(std::clamp((std::log(time) - middle) / half, -0.99, 0.99));
    }
};

TimeBounds bounds_of(const DmaTable& table) {
    const double low = std::log(0.1 / table.omega.back());
    const double high = std::log(10 / table.omega.front());
    return {(low + high) / 2, (high - low) / 2};
}

struct Problem {
    const DmaTable& table;
    TimeBounds bounds;
    std::size_t n_terms;

    std::size_t n_parameters() const { return 2 * n_terms + 1; }
    std::size_t n_residuals() const { return 2 * table.size(); }
};

// Parameters: ln G_inf; ln G_i; those of tau_i.
PronySeries series_of(const gsl_vector* p, const Problem& problem) {
    PronySeries out{std::exp(gsl_vector_get(p, 0)), {}, {}};
    for (std::size_t i = 0; i < problem.n_terms; ++i) {
        out.moduli.push_back(std::exp(gsl_vector_get(p, 1 + i)));
        out.times.push_back(problem.bounds.time(gsl_vector_get(p, 1 + problem.n_terms + i)));
    }
    return out;
}

int residuals(const gsl_vector* p, void* data, gsl_vector* f) {
    const Problem& problem = *static_cast<const Problem*>(data);
    const DmaTable& table = problem.table;
    const PronySeries series = series_of(p, problem);
    for (std::size_t k = 0; k < table.size(); ++k) {
        double storage = series.relaxed, loss = 0;
        for (std::size_t i = 0; i < problem.n_terms; ++i) {
            const double x = table.omega[k] * series.times[i], y = 1 + x * x;
            storage += series.moduli[i] * x * x / y;
            loss += series.moduli[i] * x / y;
        }
        gsl_vector_set(f, 2 * k, storage / table.storage[k] - 1);
        gsl_vector_set(f, 2 * k + 1, loss / table.loss[k] - 1);
    }
    return GSL_SUCCESS;
}

int derivatives(const gsl_vector* p, void* data, gsl_matrix* jacobian) {
    const Problem& problem = *static_cast<const Problem*>(data);
    const DmaTable& table = problem.table;
    const PronySeries series = series_of(p, problem);
    gsl_matrix_set_zero(jacobian);
    for (std::size_t k = 0; k < table.size(); ++k) {
        gsl_matrix_set(jacobian, 2 * k, 0, series.relaxed / table.storage[k]);
        for (std::size_t i = 0; i < problem.n_terms; ++i) {
            const std::size_t at_modulus = 1 + i, at_time = 1 + problem.n_terms + i;
            const double x = table.omega[k] * series.times[i], y = 1 + x * x;
            const double slope = problem.bounds.slope(gsl_vector_get(p, at_time));
            const double storage = series.moduli[i] / table.storage[k];
            const double loss = series.moduli[i] / table.loss[k];
            gsl_matrix_set(jacobian, 2 * k, at_modulus, storage * x * x / y);
            gsl_matrix_set(jacobian, 2 * k, at_time, storage * slope * 2 * x * x / (y * y));
            gsl_matrix_set(jacobian, 2 * k + 1, at_modulus, loss * x / y);
            gsl_matrix_set(jacobian, 2 * k + 1, at_time, loss * slope * x * (1 - x * x) / (y * y));
        }
    }
    return GSL_SUCCESS;
}

struct FreeWorkspace {
    void operator()(gsl_multifit_nlinear_workspace* w) const { gsl_multifit_nlinear_free(w); }
    void operator()(gsl_vector* v) const { gsl_vector_free(v); }
};
template <class T>
using Owned = std::unique_ptr<T, FreeWorkspace>;

// From a first guess to the least squares nearest below it; empty if they do not converge in
// `most_prony_steps`. Times stay between 0.1 over the highest and 10 over the lowest frequency.
// The table must be sound (see fit_prony) and have at least as many rows as the guess has terms,
// and one.
std::optional<PronyDescent> descend(const DmaTable& table, const PronySeries& guess) {
    return_gsl_errors();
    Problem problem{table, bounds_of(table), guess.times.size()};
    const std::size_t n = problem.n_terms;
    const Owned<gsl_vector> start(gsl_vector_alloc(problem.n_parameters()));
    gsl_vector_set(start.get(), 0, std::log(guess.relaxed));
    for (std::size_t i = 0; i < n; ++i) {
        gsl_vector_set(start.get(), 1 + i, std::log(guess.moduli[i]));
        gsl_vector_set(start.get(), 1 + n + i, problem.bounds.parameter(guess.times[i]));
    }
    gsl_multifit_nlinear_parameters options = gsl_multifit_nlinear_default_parameters();
    options.trs = gsl_multifit_nlinear_trs_lm;
    const Owned<gsl_multifit_nlinear_workspace> work(gsl_multifit_nlinear_alloc(
        gsl_multifit_nlinear_trust, &options, problem.n_residuals(), problem.n_parameters()));
    gsl_multifit_nlinear_fdf function{};
    function.f = residuals;
    function.df = derivatives;
    function.n = problem.n_residuals();
    function.p = problem.n_parameters();
    function.params = &problem;
    gsl_multifit_nlinear_init(start.get(), &function, work.get());
    // Steps: relative to the parameters, which are logarithms. Gradients: of squared relative
    // residuals; 1e-14 belongs to residuals of 1e-8.
    int reason = 0;
    const int status = gsl_multifit_nlinear_driver(most_prony_steps, 1e-12, 1e-14, 0, nullptr,
                                                   nullptr, &reason, work.get());
    const double norm = gsl_blas_dnrm2(gsl_multifit_nlinear_residual(work.get()));
    // No progress: no step lowers the residuals any more, to the last digit.
    if ((status != GSL_SUCCESS && status != GSL_ENOPROG) || !std::isfinite(norm)) return {};
    return PronyDescent{series_of(gsl_multifit_nlinear_position(work.get()), problem), norm * norm};
}

// G'' at the frequency of the table next to this one.
double loss_near(const DmaTable& table, double omega) {
    const auto it = std::lower_bound(table.omega.begin(), table.omega.end(), omega);
    const auto k = std::min<std::size_t>(it - table.omega.begin(), table.size() - 1);
    return table.loss[k];
}

// Times in the middle of n equal parts of the window's logarithm.
PronySeries spread_out(const DmaTable& table, std::size_t n) {
    PronySeries out{table.storage.front(), {}, {}};
    const double span = std::log(table.omega.back() / table.omega.front());
    for (std::size_t i = 0; i < n; ++i) {
        const double omega = table.omega.back() * std::exp(-span * (i + 0.5) / n);
        out.times.push_back(1 / omega);
        out.moduli.push_back(loss_near(table, omega));
    }
    return out;
}

// One term more, at the fast (0) or the slow end (1) of the window.
PronySeries with_one_more(PronySeries series, const DmaTable& table, double where) {
    const double span = std::log(table.omega.back() / table.omega.front());
    const double omega = table.omega.back() * std::exp(-span * where);
    series.times.push_back(1 / omega);
    series.moduli.push_back(loss_near(table, omega) / 2);
    return series;
}

// Of several first guesses the one that ends lowest.
std::optional<PronyDescent> best_of(const DmaTable& table, std::size_t n,
                                    const std::optional<PronyDescent>& fewer) {
    std::vector<PronySeries> guesses{spread_out(table, n)};
    if (fewer)
        for (const double where : {0., 1.})
            guesses.push_back(with_one_more(fewer->series, table, where));
    std::optional<PronyDescent> best;
    for (const PronySeries& guess : guesses) {
        auto candidate = descend(table, guess);
        if (candidate && (!best || candidate->squares < best->squares)) best = std::move(candidate);
    }
    return best;
}

double schwarz_criterion(const PronyDescent& candidate, const DmaTable& table) {
    const double n = 2. * table.size();
    const double parameters = 2. * candidate.series.times.size() + 1;
    const double mean = std::max(candidate.squares / n, exact_rms * exact_rms);
    return n * std::log(mean) + parameters * std::log(n);
}

std::size_t most_terms(const DmaTable& table) {
    const double decades = std::log10(table.omega.back() / table.omega.front());
    return std::min<std::size_t>(table.size() / 2, 1 + static_cast<std::size_t>(decades + 0.5));
}

PronyDescent best_series(const DmaTable& table) {
    std::optional<PronyDescent> best, last;
    for (std::size_t n = 1; n <= most_terms(table); ++n) {
        auto candidate = best_of(table, n, last);
        if (!candidate) continue;
        if (!best || schwarz_criterion(*candidate, table) < schwarz_criterion(*best, table))
            best = candidate;
        last = std::move(candidate);
    }
    if (!best)
        throw NotConverged(
            fmt::format("{}: no Prony series of up to {} terms: the least squares "
                        "did not converge in {} steps",
                        table.name, most_terms(table), most_prony_steps));
    return *best;
}

// As branches in the order of their times; terms at the same time become one.
Relaxation branches_of(const PronySeries& series) {
    Relaxation out;
    for (std::size_t i = 0; i < series.times.size(); ++i)
        out.branches.push_back({series.moduli[i] / series.relaxed, series.times[i]});
    auto& b = out.branches;
    std::sort(b.begin(), b.end(), [](const auto& x, const auto& y) { return x.time < y.time; });
    for (std::size_t i = 1; i < b.size();) {
        if (b[i].time > b[i - 1].time * (1 + equal_times)) {
            ++i;
            continue;
        }
        b[i - 1].ratio += b[i].ratio;
        b.erase(b.begin() + static_cast<std::ptrdiff_t>(i));
    }
    // A term that vanished in the course of the descent.
    const double least = exact_rms * out.instantaneous_ratio();
    std::erase_if(b, [&](const auto& branch) { return !(branch.ratio > least); });
    return out;
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
    const auto [series, squares] = best_series(table);
    const double largest = *std::max_element(table.storage.begin(), table.storage.end());
    if (!(series.relaxed > least_relaxed_ratio * largest))
        throw InputError(fmt::format(
            "{}: no relaxed modulus: the best Prony series is that of a fluid, with residuals "
            "(root mean square) of {:.2g} %; measure at lower frequencies, or give moduli and "
            "times",
            table.name, 100 * std::sqrt(squares / (2. * table.size()))));
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
    if (std::max(fit.storage_rms, fit.loss_rms) > poor_rms)
        out.push_back(
            fmt::format("{}: poor fit: residuals above {:g} %; no relaxing solid with "
                        "positive moduli has this table, or its frequencies are too far "
                        "apart",
                        fit.table.name, 100 * poor_rms));
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
