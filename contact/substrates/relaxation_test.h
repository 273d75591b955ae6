#pragma once

#include <string>
#include <vector>

#include "contact/substrates/relaxation.h"

namespace tricontact::contact {

/// Relaxation test: modulus over the time since the strain was applied at once.
struct RelaxationTest {
    std::string name;             ///< for messages
    bool is_young = false;        ///< E(t), else G(t)
    std::vector<double> time;     ///< [s], >= 0, strictly increasing
    std::vector<double> modulus;  ///< [Pa], > 0

    std::size_t size() const { return time.size(); }
    const char* symbol() const { return is_young ? "E" : "G"; }
};

/// Prony series fitted to a test, and how well it does. Residuals are relative: (fit -
/// table)/table.
struct RelaxationTestFit {
    RelaxationTest table;
    Relaxation relaxation;       ///< moduli over the fit's own relaxed one, times increasing
    double relaxed_modulus = 0;  ///< E_inf or G_inf [Pa]
    double rms = 0;              ///< root mean square of the residuals [-]
    double worst_residual = 0;   ///< the largest in magnitude [-]
    double worst_time = 0;       ///< where [s]

    /// Modulus at a time [Pa].
    double modulus(double time) const;
};

/// As fit_prony of a DMA table: the series with the least squares of the relative residuals. Throws
/// InputError if the table has fewer than four rows, rows that are not positive or times that do
/// not increase, if nothing relaxes, or if the modulus relaxes to nothing; NotConverged if no fit
/// converges.
RelaxationTestFit fit_prony(const RelaxationTest& table);

/// The fit in sentences, as those of a DMA table; `relaxed_modulus` [Pa]: the case's, E or G as in
/// the table.
std::vector<std::string> remarks(const RelaxationTestFit& fit, double relaxed_modulus);

}  // namespace tricontact::contact
