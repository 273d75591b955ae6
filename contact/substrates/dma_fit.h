#pragma once

#include <string>
#include <vector>

#include "contact/substrates/relaxation.h"

namespace tricontact::contact {

/// Dynamic mechanical analysis in shear: one row per frequency.
struct DmaTable {
    std::string name;             ///< for messages
    std::vector<double> omega;    ///< angular frequency [rad/s], > 0, strictly increasing
    std::vector<double> storage;  ///< G' [Pa], > 0
    std::vector<double> loss;     ///< G'' [Pa], > 0

    std::size_t size() const { return omega.size(); }
};

/// Prony series fitted to a table, and how well it does. Residuals are relative: (fit -
/// table)/table.
struct DmaFit {
    struct Worst {
        double residual = 0;  ///< of all, the largest in magnitude [-]
        double omega = 0;     ///< where [rad/s]
        bool loss = false;    ///< of G'', else of G'
    };

    DmaTable table;
    Relaxation relaxation;       ///< G_i over the fit's own G_inf, times increasing
    double relaxed_modulus = 0;  ///< G_inf [Pa]
    double storage_rms = 0;      ///< root mean square of the residuals of G' [-]
    double loss_rms = 0;         ///< of G'' [-]
    Worst worst;
};

/// The series with the least squares of the relative residuals of G' and G'' together; moduli and
/// relaxation times are free, times within a decade of the window of the table. As many terms as
/// the table supports (Schwarz 1978, Ann. Stat. 6, 461: a term more must lower N ln(rss/N) by more
/// than 2 ln N, N = 2 rows), at most one per decade and one, and half the rows. Least squares by
/// the trust region method of GSL. Throws InputError if the table has fewer than four rows, rows
/// that are not positive or frequencies that do not increase, or if it is that of a fluid (no
/// relaxed modulus within the window); NotConverged if no fit converges.
DmaFit fit_prony(const DmaTable& table);

/// The fit in sentences: terms and residuals, whether they are too large for a Prony series, and
/// whether the table's relaxed modulus differs by more than 10 % from `relaxed_modulus` [Pa], the
/// case's own, which the fit's ratios are applied to.
std::vector<std::string> remarks(const DmaFit& fit, double relaxed_modulus);

}  // namespace tricontact::contact
