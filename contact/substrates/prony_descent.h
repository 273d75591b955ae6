#pragma once

#include <optional>
#include <vector>

#include "contact/substrates/dma_fit.h"

namespace tricontact::contact {

/// Moduli and times of a Prony series, all positive: what the least squares of a fit vary.
struct PronySeries {
    double relaxed = 0;          ///< G_inf [Pa]
    std::vector<double> moduli;  ///< G_i [Pa]
    std::vector<double> times;   ///< tau_i [s]
};

struct PronyDescent {
    PronySeries series;
    double squares = 0;  ///< sum of the squared relative residuals of G' and G'' [-]
};

/// From a first guess to the least squares nearest below it; empty if they do not converge in
/// `most_prony_steps`. Times stay between 0.1 over the highest and 10 over the lowest frequency.
/// The table must be sound (see fit_prony) and have at least as many rows as the guess has terms,
/// and one.
std::optional<PronyDescent> descend(const DmaTable& table, const PronySeries& guess);

inline constexpr std::size_t most_prony_steps = 500;

}  // namespace tricontact::contact
