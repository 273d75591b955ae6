#include "contact/substrates/prony_fit.h"

#include <fmt/format.h>
#include <gsl/gsl_blas.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_multifit_nlinear.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "contact/base/error.h"
#include "contact/base/gsl.h"

namespace tricontact::contact {

namespace {

using Kind = PronyObservation::Kind;

// Relative residuals below this are rounding, not measurement: no reason for a further term.
constexpr double exact_rms = 1e-8;
constexpr double least_relaxed_ratio = 1e-6;  // G_inf over the largest: below, a fluid's
constexpr double equal_times = 1e-3;          // closer times [-] are one term

constexpr std::size_t most_prony_steps = 500;

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

TimeBounds bounds_of(const PronyProblem& problem) {
    const double low = std::log(0.1 / problem.highest);
    const double high = std::log(10 / problem.lowest);
    return {(low + high) / 2, (high - low) / 2};
}

struct Descent {
    const std::vector<PronyObservation>& observations;
    TimeBounds bounds;
    std::size_t n_terms;

    std::size_t n_parameters() const { return 2 * n_terms + 1; }
};

// Parameters: ln G_inf; ln G_i; those of tau_i.
PronySeries series_of(const gsl_vector* p, const Descent& descent) {
    PronySeries out{std::exp(gsl_vector_get(p, 0)), {}, {}};
    for (std::size_t i = 0; i < descent.n_terms; ++i) {
        out.moduli.push_back(std::exp(gsl_vector_get(p, 1 + i)));
        out.times.push_back(descent.bounds.time(gsl_vector_get(p, 1 + descent.n_terms + i)));
    }
    return out;
}

// What a term contributes, and its derivative by ln tau.
struct Term {
    double value, slope;
};

Term term(Kind kind, double at, double modulus, double time) {
    if (kind == Kind::relaxing) {
        const double x = at / time, value = modulus * std::exp(-x);
        return {value, value * x};
    }
    const double x = at * time, y = 1 + x * x;
    if (kind == Kind::storage) return {modulus * x * x / y, modulus * 2 * x * x / (y * y)};
    return {modulus * x / y, modulus * x * (1 - x * x) / (y * y)};
}

int residuals(const gsl_vector* p, void* data, gsl_vector* f) {
    const Descent& descent = *static_cast<const Descent*>(data);
    const PronySeries series = series_of(p, descent);
    for (std::size_t k = 0; k < descent.observations.size(); ++k) {
        const auto& [kind, at, value] = descent.observations[k];
        double sum = kind == Kind::loss ? 0 : series.relaxed;
        for (std::size_t i = 0; i < descent.n_terms; ++i)
            sum += term(kind, at, series.moduli[i], series.times[i]).value;
        gsl_vector_set(f, k, sum / value - 1);
    }
    return GSL_SUCCESS;
}

int derivatives(const gsl_vector* p, void* data, gsl_matrix* jacobian) {
    const Descent& descent = *static_cast<const Descent*>(data);
    const PronySeries series = series_of(p, descent);
    gsl_matrix_set_zero(jacobian);
    for (std::size_t k = 0; k < descent.observations.size(); ++k) {
        const auto& [kind, at, value] = descent.observations[k];
        if (kind != Kind::loss) gsl_matrix_set(jacobian, k, 0, series.relaxed / value);
        for (std::size_t i = 0; i < descent.n_terms; ++i) {
            const std::size_t at_modulus = 1 + i, at_time = 1 + descent.n_terms + i;
            const Term of = term(kind, at, series.moduli[i], series.times[i]);
            gsl_matrix_set(jacobian, k, at_modulus, of.value / value);
            gsl_matrix_set(jacobian, k, at_time,
                           of.slope / value * descent.bounds.slope(gsl_vector_get(p, at_time)));
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
std::optional<PronyDescent> descend(const PronyProblem& problem, const PronySeries& guess) {
    return_gsl_errors();
    Descent descent{problem.observations, bounds_of(problem), guess.times.size()};
    const std::size_t n = descent.n_terms;
    const Owned<gsl_vector> start(gsl_vector_alloc(descent.n_parameters()));
    gsl_vector_set(start.get(), 0, std::log(guess.relaxed));
    for (std::size_t i = 0; i < n; ++i) {
        gsl_vector_set(start.get(), 1 + i, std::log(guess.moduli[i]));
        gsl_vector_set(start.get(), 1 + n + i, descent.bounds.parameter(guess.times[i]));
    }
    gsl_multifit_nlinear_parameters options = gsl_multifit_nlinear_default_parameters();
    options.trs = gsl_multifit_nlinear_trs_lm;
    const Owned<gsl_multifit_nlinear_workspace> work(gsl_multifit_nlinear_alloc(
        gsl_multifit_nlinear_trust, &options, descent.observations.size(), descent.n_parameters()));
    gsl_multifit_nlinear_fdf function{};
    function.f = residuals;
    function.df = derivatives;
    function.n = descent.observations.size();
    function.p = descent.n_parameters();
    function.params = &descent;
    gsl_multifit_nlinear_init(start.get(), &function, work.get());
    // Steps: relative to the parameters, which are logarithms. Gradients: of squared relative
    // residuals; 1e-14 belongs to residuals of 1e-8.
    int reason = 0;
    const int status = gsl_multifit_nlinear_driver(most_prony_steps, 1e-12, 1e-14, 0, nullptr,
                                                   nullptr, &reason, work.get());
    const double norm = gsl_blas_dnrm2(gsl_multifit_nlinear_residual(work.get()));
    // No progress: no step lowers the residuals any more, to the last digit.
    if ((status != GSL_SUCCESS && status != GSL_ENOPROG) || !std::isfinite(norm)) return {};
    return PronyDescent{series_of(gsl_multifit_nlinear_position(work.get()), descent), norm * norm};
}

// Times in the middle of n equal parts of the window's logarithm.
PronySeries spread_out(const PronyProblem& problem, std::size_t n) {
    PronySeries out{problem.relaxed, {}, {}};
    const double span = std::log(problem.highest / problem.lowest);
    for (std::size_t i = 0; i < n; ++i) {
        const double omega = problem.highest * std::exp(-span * (i + 0.5) / n);
        out.times.push_back(1 / omega);
        out.moduli.push_back(problem.first_guess(omega));
    }
    return out;
}

// One term more, at the fast (0) or the slow end (1) of the window.
PronySeries with_one_more(PronySeries series, const PronyProblem& problem, double where) {
    const double span = std::log(problem.highest / problem.lowest);
    const double omega = problem.highest * std::exp(-span * where);
    series.times.push_back(1 / omega);
    series.moduli.push_back(problem.first_guess(omega) / 2);
    return series;
}

// Of several first guesses the one that ends lowest.
std::optional<PronyDescent> best_of(const PronyProblem& problem, std::size_t n,
                                    const std::optional<PronyDescent>& fewer) {
    std::vector<PronySeries> guesses{spread_out(problem, n)};
    if (fewer)
        for (const double where : {0., 1.})
            guesses.push_back(with_one_more(fewer->series, problem, where));
    std::optional<PronyDescent> best;
    for (const PronySeries& guess : guesses) {
        auto candidate = descend(problem, guess);
        if (candidate && (!best || candidate->squares < best->squares)) best = std::move(candidate);
    }
    return best;
}

double schwarz_criterion(const PronyDescent& candidate, std::size_t n_observations) {
    const auto n = static_cast<double>(n_observations);
    const double parameters = 2. * candidate.series.times.size() + 1;
    const double mean = std::max(candidate.squares / n, exact_rms * exact_rms);
    return n * std::log(mean) + parameters * std::log(n);
}

}  // namespace

std::size_t most_prony_terms(std::size_t n_rows, double lowest, double highest) {
    const double decades = std::log10(highest / lowest);
    return std::min<std::size_t>(n_rows / 2, 1 + static_cast<std::size_t>(decades + 0.5));
}

PronyDescent best_series(const PronyProblem& problem, const std::string& remedy) {
    std::optional<PronyDescent> best, last;
    const std::size_t n_observations = problem.observations.size();
    for (std::size_t n = 1; n <= problem.most_terms; ++n) {
        auto candidate = best_of(problem, n, last);
        if (!candidate) continue;
        if (!best || schwarz_criterion(*candidate, n_observations) <
                         schwarz_criterion(*best, n_observations))
            best = candidate;
        last = std::move(candidate);
    }
    if (!best)
        throw NotConverged(
            fmt::format("{}: no Prony series of up to {} terms: the least squares "
                        "did not converge in {} steps",
                        problem.name, problem.most_terms, most_prony_steps));
    double largest = 0;
    for (const PronyObservation& one : problem.observations)
        if (one.kind != Kind::loss) largest = std::max(largest, one.value);
    if (!(best->series.relaxed > least_relaxed_ratio * largest))
        throw InputError(fmt::format(
            "{}: no relaxed modulus: the best Prony series is that of a fluid, with residuals "
            "(root mean square) of {:.2g} %; {}, or give moduli and times",
            problem.name, 100 * std::sqrt(best->squares / static_cast<double>(n_observations)),
            remedy));
    return *best;
}

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

}  // namespace tricontact::contact
