#include "contact/substrates/prony_descent.h"

#include <gsl/gsl_blas.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_multifit_nlinear.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace tricontact::contact {

namespace {

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

}  // namespace

std::optional<PronyDescent> descend(const DmaTable& table, const PronySeries& guess) {
    // GSL's own handler ends the program; what matters comes back as a code. Nobody else uses GSL.
    [[maybe_unused]] static gsl_error_handler_t* const old = gsl_set_error_handler_off();
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

}  // namespace tricontact::contact
