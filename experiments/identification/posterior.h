#pragma once

#include <optional>
#include <vector>

#include "experiments/identification/identification.h"

namespace tricontact::experiments {

/// What the data leave of E and mu, with the uncertain inputs at any of their values: points of the
/// posterior density.
struct Posterior {
    std::vector<Properties> points;
    PerProperty<double> median;
    PerProperty<Interval> interval;     ///< equal tails of `confidence`
    std::optional<double> correlation;  ///< of E and mu, if both were free
    double acceptance = 0;              ///< of the sampler's proposals
    double autocorrelation_time = 0;    ///< the longest one [steps]
    double effective_size = 0;          ///< independent points that are as good
};

/// `changes`: of E [Pa] and mu by one standard error of each uncertain input. Prior: flat in ln E
/// and in least_friction/mu between 0 and 1; known errors of the observations, else Jeffreys' prior
/// of their common standard deviation. statistics::sample_ensemble draws. Each point is then moved
/// by normal draws of the inputs, to first order as in the printed interval: inputs are as they are
/// stated, the data are not asked to tell them. Throws contact::NotConverged as sample_ensemble.
Posterior sample_posterior(const IdentificationTask& task, const Identification& found,
                           const std::vector<Properties>& changes);

}  // namespace tricontact::experiments
