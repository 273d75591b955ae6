#pragma once

#include <map>
#include <string>

#include "comparisons/quantities/quantity.h"
#include "comparisons/resolution/numerical_error.h"

namespace tricontact::random_cases {

/// How many half widths cover what they are held against: in all, per quantity, per model and
/// quantity, per kind of loading.
class BarTally {
  public:
    /// Where a run stands: "17", and what it is.
    struct Place {
        int i;
        std::string model, body, loading;
        std::string text() const;
        /// The loading without its numbers.
        std::string kind() const;
    };

    /// Counts the run's half width of `q` beside `truth`, whose own is `more`; prints one that does
    /// not cover it, or is 0 of what is not exact. Nothing where there is no value or no half
    /// width.
    void count(const Place& place, const comparisons::NumericalError& error,
               const comparisons::Quantity& q, std::optional<double> truth, double more = 0);
    void print() const;
    /// None is 0 and as many as of 95 % are covered, in all and of each quantity, less two standard
    /// deviations of a count of so many.
    bool passed() const;

  private:
    struct Count {
        int n_told = 0, n_held = 0;

        bool is_enough() const;
    };

    Count all_;
    int n_zero_ = 0;
    std::map<std::string, Count> of_quantity_, of_model_, of_kind_;
};

}  // namespace tricontact::random_cases
