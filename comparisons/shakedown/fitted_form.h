#pragma once

#include <optional>
#include <string>
#include <vector>

#include "statistics/regression.h"

namespace tricontact::comparisons {

/// Goodness of a fit, of the quantity on the left of the form. Names as in the field and in table
/// A.1.1 of the thesis (under SSE it has 3e-7 beside R^2 = 1); its equations exchange the two.
struct Goodness {
    double explained = 0;  ///< SSR, of the regression: sum of (fitted - mean observed)^2 (A.1.8)
    double residual = 0;   ///< SSE, of the errors: sum of (observed - fitted)^2 (A.1.9)
    double r_squared = 0;  ///< SSR/(SSR + SSE) (A.1.10); NaN where nothing varies
};
Goodness goodness(const std::vector<double>& observed, const std::vector<double>& fitted);

/// A formula, linear in its parameters, fitted to the points of one model and group.
struct FittedForm {
    std::string form;                     ///< plain text: "Du = eta (w - w_lim)"
    std::vector<std::string> parameters;  ///< names, in the order of the fit's
    statistics::Fit fit;
    Goodness of_left_side;
};

/// `observed`: the left side, columns * parameters plus `offset`, if any. Empty where there are not
/// `least_n` observations or these do not tell the parameters apart.
std::optional<FittedForm> fit_form(const std::string& form,
                                   const std::vector<std::string>& parameters,
                                   const std::vector<std::vector<double>>& columns,
                                   const std::vector<double>& observed, double confidence,
                                   std::size_t least_n, const std::vector<double>& offset = {});

}  // namespace tricontact::comparisons
