#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "contact/substrates/relaxation.h"

namespace tricontact::contact {

/// Moduli and times of a Prony series, all positive: what the least squares of a fit vary.
struct PronySeries {
    double relaxed = 0;          ///< G_inf [Pa]
    std::vector<double> moduli;  ///< G_i [Pa]
    std::vector<double> times;   ///< tau_i [s]
};

struct PronyDescent {
    PronySeries series;
    double squares = 0;  ///< sum of the squared relative residuals [-]
};

/// A measured modulus that is linear in those of the series.
struct PronyObservation {
    enum class Kind { storage, loss, relaxing };

    Kind kind = Kind::storage;
    double at = 0;     ///< angular frequency [rad/s], of a relaxing one the time [s]
    double value = 0;  ///< [Pa], > 0
};

/// What a fit knows beside its observations.
struct PronyProblem {
    std::string name;  ///< of the table, for messages
    std::vector<PronyObservation> observations;
    /// Window of the table in angular frequencies [rad/s], of a relaxation test 1/t.
    double lowest = 0, highest = 0;
    double relaxed = 0;                               ///< first guess of G_inf [Pa]
    std::function<double(double omega)> first_guess;  ///< of a G_i that relaxes in 1/omega [Pa]
    std::size_t most_terms = 1;  ///< 2 of them and 1 are no more than the observations
};

/// The series with the least squares of the relative residuals; moduli and relaxation times are
/// free, times within a decade of the window. As many terms as the observations support (Schwarz
/// 1978, Ann. Stat. 6, 461: a term more must lower N ln(rss/N) by more than 2 ln N), at most
/// `most_terms`. Least squares by the trust region method of GSL. Throws NotConverged if no fit
/// converges, InputError if it is that of a fluid: no relaxed modulus within the window, `remedy`.
PronyDescent best_series(const PronyProblem& problem, const std::string& remedy);

/// At most one term per decade of the window and one, and half the rows.
std::size_t most_prony_terms(std::size_t n_rows, double lowest, double highest);

/// As branches in the order of their times; terms at the same time become one, vanished ones none.
Relaxation branches_of(const PronySeries& series);

/// Relative residuals above are no scatter of a measurement [-].
inline constexpr double poor_prony_rms = 0.05;
/// Of the table's relaxed modulus against the case's, from which on it is said [-].
inline constexpr double largest_modulus_error = 0.1;

}  // namespace tricontact::contact
