#pragma once

#include <vector>

#include "contact/history.h"

namespace tricontact::contact {

/// What the verdict looks at, dimensionless so that every model is judged alike.
struct Evolution {
    double static_shift_ratio;                     ///< U_stat / U_max
    const std::vector<double>& shift_ratio;        ///< U / U_max, roller upright, n = 1, 2, ...
    const std::vector<double>& dissipation_ratio;  ///< per period, over mu F_N U_max
};

/// |U(n) - U(n-1)| / U_max of the last period; 0 before the first.
double last_increment(const Evolution& evolution);

/// Nothing happens any more: shift below 1e-7 and dissipation below 1e-6 in the last period.
bool has_settled(const Evolution& evolution);

/// Shakedown: settled, or the increments of the shift decay geometrically (ratio steady and below
/// 0.95, Aitken's limit of them below a tenth of the last) with less than 1e-3 still to come; below
/// 1e-5 Aitken's limit is not asked. Ratcheting: the increments tend to a constant, by Aitken's
/// limit at least 0.6 of the last one, or changed by less than 1 %. Aitken's three increments lie a
/// sixth of the periods apart, so that the solver's noise does not spoil their differences. Else
/// undecided: run more periods. A contact that slips to and fro in every period without getting
/// anywhere is neither and remains undecided.
State judge(const Evolution& evolution);

}  // namespace tricontact::contact
