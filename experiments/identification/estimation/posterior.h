#pragma once

#include <optional>
#include <vector>

#include "experiments/identification/estimation/identification.h"

namespace tricontact::experiments {

/// What the data leave of the parameters, with the uncertain inputs at any of their values: points
/// of the posterior density.
struct Posterior {
    std::vector<std::vector<double>> points;  ///< of the parameters' values
    std::vector<double> median;               ///< one per parameter
    std::vector<Interval> interval;           ///< equal tails of `confidence`
    /// Of each two parameters.
    std::vector<std::vector<double>> correlation;
    double acceptance = 0;            ///< of the sampler's proposals
    double autocorrelation_time = 0;  ///< the longest one [steps]
    double effective_size = 0;        ///< independent points that are as good
    /// Where another observation instead of each one would lie, of `confidence`: the model's
    /// values at points of the posterior, with the noise of the table.
    std::vector<Interval> predicted;
};

/// `changes`: of the parameters by one standard error of each uncertain input. Prior: flat in the
/// coordinates of the parameters between their bounds (ln E, F_T/(mu F_N), nu ...); known errors of
/// the observations, else Jeffreys' prior of the standard deviation of each table. Correlated
/// errors (Identification::widening) flatten the likelihood by the largest of the factors, in
/// squares. statistics::sample_ensemble draws. Each point is then moved by normal draws of the
/// inputs, to first order as in the printed interval: inputs are as they are stated, the data are
/// not asked to tell them. Throws contact::NotConverged as sample_ensemble.
Posterior sample_posterior(const IdentificationTask& task, const Identification& found,
                           const std::vector<std::vector<double>>& changes);

}  // namespace tricontact::experiments
