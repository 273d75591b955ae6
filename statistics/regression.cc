#include "statistics/regression.h"

#include <fmt/format.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_multifit.h>
#include <gsl/gsl_multifit_nlinear.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>
#include <memory>
#include <stdexcept>

#include "contact/base/error.h"
#include "contact/base/gsl.h"

namespace tricontact::statistics {

namespace {

constexpr int most_iterations = 200;
// Of parameters, gradient and sum of squares: an order above what differences of a double allow.
constexpr double parameter_tolerance = 1e-12;
constexpr double gradient_tolerance = 1e-14;
// Singular values below this ratio of the largest: the columns are dependent.
constexpr double least_singular_ratio = 1e-12;

template <auto Free>
struct Freeing {
    template <typename T>
    void operator()(T* p) const {
        Free(p);
    }
};
using Vector = std::unique_ptr<gsl_vector, Freeing<gsl_vector_free>>;
using Matrix = std::unique_ptr<gsl_matrix, Freeing<gsl_matrix_free>>;

auto view_of(const std::vector<double>& values) {
    return gsl_vector_const_view_array(values.data(), values.size());
}

std::vector<double> weights_of(const FitOptions& options, std::size_t n) {
    return options.weights.empty() ? std::vector<double>(n, 1.) : options.weights;
}

void check_sizes(std::size_t n, std::size_t n_parameters, const FitOptions& options) {
    if (n_parameters == 0 || n <= n_parameters)
        throw std::invalid_argument(fmt::format(
            "{} observations do not determine {} parameters and their errors", n, n_parameters));
    if (!options.weights.empty() && options.weights.size() != n)
        throw std::invalid_argument("one weight per observation");
    if (!(options.confidence > 0 && options.confidence < 1))
        throw std::invalid_argument("a level of confidence lies between 0 and 1");
}

// Errors and goodness from parameters, model values, and the covariance at unit variance.
Fit with_errors(const std::vector<double>& parameters, const std::vector<double>& y,
                std::vector<double> fitted, const gsl_matrix& unit_covariance, bool has_constant,
                const FitOptions& options) {
    const std::size_t n = y.size(), m = parameters.size();
    Fit fit;
    fit.confidence = options.confidence;
    fit.degrees_of_freedom = static_cast<int>(n - m);
    fit.fitted = std::move(fitted);
    const std::vector<double> weights = weights_of(options, n);
    double mean = 0, sum_of_weights = 0, total = 0;
    for (std::size_t i = 0; i < n; ++i) {
        mean += weights[i] * y[i];
        sum_of_weights += weights[i];
    }
    mean = has_constant ? mean / sum_of_weights : 0;
    for (std::size_t i = 0; i < n; ++i) {
        fit.residuals.push_back(y[i] - fit.fitted[i]);
        fit.residual_sum_of_squares += weights[i] * fit.residuals[i] * fit.residuals[i];
        total += weights[i] * (y[i] - mean) * (y[i] - mean);
    }
    fit.explained_sum_of_squares = total - fit.residual_sum_of_squares;
    const double variance = fit.residual_sum_of_squares / fit.degrees_of_freedom;
    fit.residual_standard_deviation = std::sqrt(variance);
    const double scale = options.weights_are_absolute ? 1 : variance;
    const double t = options.weights_are_absolute
                         ? normal_quantile(options.confidence)
                         : student_t(options.confidence, fit.degrees_of_freedom);
    for (std::size_t k = 0; k < m; ++k) {
        std::vector<double> row;
        for (std::size_t l = 0; l < m; ++l)
            row.push_back(scale * gsl_matrix_get(&unit_covariance, k, l));
        fit.parameters.push_back(with_interval(parameters[k], std::sqrt(row[k]), t));
        fit.covariance.push_back(std::move(row));
    }
    return fit;
}

bool is_constant(const std::vector<double>& column) {
    return column.front() != 0 &&
           std::ranges::all_of(column, [&](double v) { return v == column.front(); });
}

// What the solver calls; an exception of the model waits until GSL's C code has returned.
struct Problem {
    const FitModel& model;
    const std::vector<double>& y;
    const std::vector<double>& scale;
    std::exception_ptr failure = nullptr;

    std::vector<double> parameters(const gsl_vector& scaled) const {
        std::vector<double> p;
        for (std::size_t k = 0; k < scale.size(); ++k)
            p.push_back(gsl_vector_get(&scaled, k) * scale[k]);
        return p;
    }
};

int deviations(const gsl_vector* scaled, void* data, gsl_vector* out) {
    auto& problem = *static_cast<Problem*>(data);
    try {
        const std::vector<double> values = problem.model(problem.parameters(*scaled));
        for (std::size_t i = 0; i < values.size(); ++i)
            gsl_vector_set(out, i, values[i] - problem.y[i]);
        return GSL_SUCCESS;
    } catch (...) {
        problem.failure = std::current_exception();
        return GSL_EBADFUNC;
    }
}

}  // namespace

double Fit::r_squared() const {
    const double total = explained_sum_of_squares + residual_sum_of_squares;
    return total > 0 ? explained_sum_of_squares / total : std::numeric_limits<double>::quiet_NaN();
}

Fit fit_linear(const std::vector<std::vector<double>>& columns, const std::vector<double>& y,
               const FitOptions& options) {
    const std::size_t n = y.size(), m = columns.size();
    check_sizes(n, m, options);
    contact::return_gsl_errors();
    const Matrix design(gsl_matrix_alloc(n, m)), covariance(gsl_matrix_alloc(m, m));
    for (std::size_t k = 0; k < m; ++k) {
        if (columns[k].size() != n) throw std::invalid_argument("columns of different lengths");
        for (std::size_t i = 0; i < n; ++i) gsl_matrix_set(design.get(), i, k, columns[k][i]);
    }
    const std::vector<double> weights = weights_of(options, n);
    const auto weights_view = view_of(weights), observed = view_of(y);
    const Vector solution(gsl_vector_alloc(m));
    using Workspace =
        std::unique_ptr<gsl_multifit_linear_workspace, Freeing<gsl_multifit_linear_free>>;
    const Workspace work(gsl_multifit_linear_alloc(n, m));
    double squares = 0;
    std::size_t rank = 0;
    const int status = gsl_multifit_wlinear_tsvd(
        design.get(), &weights_view.vector, &observed.vector, least_singular_ratio, solution.get(),
        covariance.get(), &squares, &rank, work.get());
    if (status != GSL_SUCCESS || rank < m)
        throw contact::NotConverged(
            "least squares: the observations do not tell the parameters "
            "apart (dependent columns)");
    std::vector<double> parameters(solution->data, solution->data + m), values(n, 0.);
    for (std::size_t k = 0; k < m; ++k)
        for (std::size_t i = 0; i < n; ++i) values[i] += parameters[k] * columns[k][i];
    return with_errors(parameters, y, std::move(values), *covariance,
                       std::ranges::any_of(columns, is_constant), options);
}

Fit fit_nonlinear(const FitModel& model, const std::vector<double>& y,
                  const std::vector<double>& start, const FitOptions& options) {
    const std::size_t n = y.size(), m = start.size();
    check_sizes(n, m, options);
    if (std::ranges::count(start, 0.))
        throw std::invalid_argument("a start of zero tells no magnitude");
    contact::return_gsl_errors();
    // Parameters in units of their start: E in Pa and mu differ by ten orders.
    Problem problem{model, y, start};
    gsl_multifit_nlinear_fdf functions{};
    functions.f = deviations;
    functions.n = n;
    functions.p = m;
    functions.params = &problem;
    gsl_multifit_nlinear_parameters settings = gsl_multifit_nlinear_default_parameters();
    settings.fdtype = GSL_MULTIFIT_NLINEAR_CTRDIFF;
    using Workspace =
        std::unique_ptr<gsl_multifit_nlinear_workspace, Freeing<gsl_multifit_nlinear_free>>;
    const Workspace work(gsl_multifit_nlinear_alloc(gsl_multifit_nlinear_trust, &settings, n, m));
    const std::vector<double> weights = weights_of(options, n), ones(m, 1.);
    const auto weights_view = view_of(weights), ones_view = view_of(ones);
    int info = 0;
    int status =
        gsl_multifit_nlinear_winit(&ones_view.vector, &weights_view.vector, &functions, work.get());
    if (status == GSL_SUCCESS)
        status =
            gsl_multifit_nlinear_driver(most_iterations, parameter_tolerance, gradient_tolerance, 0,
                                        nullptr, nullptr, &info, work.get());
    if (problem.failure) std::rethrow_exception(problem.failure);
    // No progress: the sum of squares is as small as rounding lets it become. At the first step the
    // driver calls that something else.
    if (info == GSL_ENOPROG) status = GSL_ENOPROG;
    if (status != GSL_SUCCESS && status != GSL_ENOPROG)
        throw contact::NotConverged(fmt::format("least squares after {} iterations: {}",
                                                gsl_multifit_nlinear_niter(work.get()),
                                                gsl_strerror(status)));
    const Matrix covariance(gsl_matrix_alloc(m, m));
    gsl_multifit_nlinear_covar(gsl_multifit_nlinear_jac(work.get()), 0, covariance.get());
    for (std::size_t k = 0; k < m; ++k)
        for (std::size_t l = 0; l < m; ++l)
            *gsl_matrix_ptr(covariance.get(), k, l) *= start[k] * start[l];
    const std::vector<double> parameters =
        problem.parameters(*gsl_multifit_nlinear_position(work.get()));
    return with_errors(parameters, y, model(parameters), *covariance, true, options);
}

}  // namespace tricontact::statistics
