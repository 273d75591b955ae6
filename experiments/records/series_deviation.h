#pragma once

#include <optional>
#include <string>
#include <vector>

#include "experiments/validation/series_error.h"

namespace tricontact::experiments {

struct ExperimentEvaluation;
struct ModelPrediction;

/// Name of the source of what a response has beyond the linear one, see nonlinear_error().
inline constexpr const char* nonlinear_response = "nonlinear response";

/// The shift over all periods measured and by a model: upright before the first one (n = 0) and
/// after each [m]. As Deviation is of a single quantity.
struct SeriesDeviation {
    std::string model;
    SeriesError error;             ///< by the case's uncertain numbers, the record and the mesh
    bool has_errors = false;       ///< the case states uncertainties
    bool rest_is_missing = false;  ///< of a relaxing substrate: how long F_T acted is not known
    bool is_spoilt = false;        ///< as of a Deviation
    bool slides = false;           ///< as of a Deviation
    /// Drift subtracted in one period that on a relaxing substrate may be creep [m].
    double creep_per_period = 0;

    double creep(std::size_t n) const { return static_cast<double>(n) * creep_per_period; }
    /// The comparison disagrees in one of the periods, there also with the creep back in the
    /// measured value. Empty where that cannot be told.
    std::optional<bool> differs() const;
};

/// Of a prediction over the periods of the evaluation. What the record gives: the scatter of its
/// runs (run_scatter.h), and what all of them may have wrong in common; of a single one its noise,
/// which is independent from period to period, its drift, which grows with time, and its zero, the
/// same in all.
SeriesDeviation series_deviation(const ExperimentEvaluation& evaluation,
                                 const ModelPrediction& prediction);

}  // namespace tricontact::experiments
