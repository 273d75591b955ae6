#pragma once

#include <map>
#include <span>
#include <string>
#include <utility>

#include "experiments/identification/estimation/best_sum_of_squares.h"
#include "experiments/identification/loop_findings.h"

namespace tricontact::experiments {

/// How likely a loop's contact slides as a whole at its reversals. Beside one number of friction
/// by the likelihood: the root of what the sum of squares rises by where friction is moved until
/// the loop just reaches sliding, other parameters at their best. Beside several by the linearised
/// model.
class SlidingChance {
  public:
    /// All of it is to outlive this.
    SlidingChance(const IdentificationInput& input, const IdentificationTask& task,
                  const Identification& found);

    /// `way`: amplitude of the shift over that at which all slides.
    double at(double way);

  private:
    double deviations(double way) const;

    const Identification& found_;
    BestSumOfSquares squares_;
    std::size_t friction_ = 0;  // its place; of several the first
    bool has_profile_ = false;
    double relative_error_ = 0;  // of the shift at which all slides
    std::map<double, double> known_;
};

/// The regime that is likeliest of some cycles, "mixed" where some slide and others do not, and
/// its probability: that of the least certain cycle.
std::pair<std::string, double> regime_of_series(std::span<const LoopFinding> loops);

}  // namespace tricontact::experiments
