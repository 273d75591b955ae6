#pragma once

#include <optional>

#include "contact/attraction/attraction_law.h"

namespace tricontact::contact {

/// Surfaces that attract each other: a tension sigma(g) over the gap g, whose integral is the work
/// of separation, or none but at the edge of the contact (range 0).
struct Adhesion {
    enum class Law {
        dugdale,     ///< sigma_0 = w/range up to the gap `range`, nothing beyond
        exponential  ///< sigma = w/range exp(-g/range)
    };
    double work = 0;  ///< w [J/m^2], of separation
    /// w_a [J/m^2], gained as surfaces come together, at most w; empty: w. Between both the edge of
    /// the contact stays where it is.
    std::optional<double> approach_work;
    std::optional<double> range;        ///< [m]; 0 or no peak stress: Johnson, Kendall and Roberts
    std::optional<double> peak_stress;  ///< sigma_0 [Pa], instead
    Law law = Law::dugdale;             ///< of a range above 0

    /// The length in the law [m]; 0: short-ranged.
    double distance() const { return peak_stress ? work / *peak_stress : range.value_or(0); }
    AttractionLaw attraction() const { return {work, distance(), law == Law::exponential}; }
    bool is_reversible() const { return approach_work.value_or(work) == work; }
    bool is_short_ranged() const { return distance() == 0; }
    /// sigma_0 [Pa] of a range above 0.
    double strength() const { return peak_stress ? *peak_stress : work / *range; }
};

}  // namespace tricontact::contact
