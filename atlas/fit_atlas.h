#pragma once

#include <vector>

#include "atlas/atlas.h"
#include "comparisons/quantities/results.h"

namespace tricontact::atlas {

/// The runs of one point of an atlas' study.
struct Sample {
    /// A run that is coarser in one way: cells, or steps.
    struct Coarser {
        comparisons::Results results;
        /// Of the difference finest - coarser, what is missing to no mesh or no steps, by
        /// Richardson: 1/(r^p - 1) at the ratio r of the resolutions and the order p.
        double factor;
    };

    std::vector<double> coordinates;  ///< one per axis [SI]
    contact::Case c;                  ///< of the finest run
    comparisons::Results finest;
    std::vector<Coarser> coarser;
};

/// What a map is fitted to at a sample: the quantity over its closed form, or its logarithm.
/// Empty where the quantity is undefined, and of a logarithm where the quotient is not positive.
std::optional<double> fitted_value(const Atlas& atlas, const comparisons::Quantity& q,
                                   const Sample& sample, const comparisons::Results& results,
                                   bool is_logarithmic);

/// The quantity itself at a sample, of one with a unit its quotient by the closed form; what the
/// coarser runs say is missing is added.
std::optional<double> extrapolated_value(const Atlas& atlas, const comparisons::Quantity& q,
                                         const Sample& sample);

/// Fits a map to a quantity. Throws contact::InputError if too few samples define it, or if it has
/// a unit and no closed form that makes it dimensionless.
Map fit_map(const Atlas& atlas, const comparisons::Quantity& q, const std::vector<Sample>& samples);

/// Cuts the axes of amplitude and load so that no sample inside lacks one of the maps' quantities,
/// each time at the end that costs the fewest samples: a contact that ratchets has no settled
/// shift, and none is told next to it. Leaves the axes as they are if it would cost more than a
/// fifth of the samples.
void cut_domain(Atlas& atlas, const std::vector<Sample>& samples);

/// The error that 95 % of the bars at the samples stay below: over the value, of a map that is none
/// of a logarithm over the root mean square of the values.
double typical_error(const Map& map, const std::vector<Sample>& samples, const Atlas& atlas);

}  // namespace tricontact::atlas
