#pragma once

#include <cmath>
#include <map>
#include <memory>

#include "contact/solvers/compliance.h"
#include "contact/solvers/normal_solver.h"

namespace tricontact::contact {

/// The last solution at each phase of the period. A contact that rolls to and fro comes back to
/// nearly the same pressures and tractions one period later: the best start for an iteration that
/// is to find them. Starts change no result by more than the solvers' tolerance.
class PeriodStarts {
  public:
    struct Start {
        std::shared_ptr<const NormalSolution> normal;
        TangentialField traction;   ///< [Pa]
        Vector2 shift_increment{};  ///< [m]
    };

    /// `phase`: of the step, in periods; all that comes before rolling has phase 0.
    void keep(double phase, Start start) {
        const std::size_t bytes = 4 * sizeof(double) * start.traction.x.size();
        if (starts_.contains(key(phase)) || (starts_.size() + 1) * bytes <= most_bytes)
            starts_[key(phase)] = std::move(start);
    }
    /// Null where there was no step.
    const Start* find(double phase) const {
        const auto it = starts_.find(key(phase));
        return it == starts_.end() ? nullptr : &it->second;
    }
    void clear() { starts_.clear(); }

  private:
    static constexpr std::size_t most_bytes = std::size_t{1} << 28;

    /// The phase within its period, rounded: n + 1/3 has other last bits for each n.
    static long key(double phase) {
        constexpr long parts = 1'000'000'000;
        return std::lround((phase - std::floor(phase)) * parts) % parts;
    }

    std::map<long, Start> starts_;
};

}  // namespace tricontact::contact
