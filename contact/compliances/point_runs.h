#pragma once

#include <algorithm>
#include <vector>

namespace tricontact::contact {

/// Some of the points, as runs of neighbours: what is gathered from columns of a large matrix is
/// waited for run by run.
class PointRuns {
  public:
    /// `points` in ascending order.
    explicit PointRuns(const std::vector<std::size_t>& points) {
        for (const std::size_t i : points)
            if (!runs_.empty() && i == runs_.back().first + runs_.back().n)
                ++runs_.back().n;
            else
                runs_.push_back({i, 1});
    }

    /// Entries of these points one after the other.
    void gather(const double* from, double* to) const {
        for (const auto& [first, n] : runs_) to = std::copy_n(from + first, n, to);
    }
    /// Announces that `from` is gathered from soon.
    void prefetch(const double* from) const {
        constexpr std::size_t line = 8;  // numbers
        for (const auto& [first, n] : runs_)
            for (std::size_t k = 0; k < n + line; k += line) __builtin_prefetch(from + first + k);
    }

  private:
    struct Run {
        std::size_t first, n;
    };
    std::vector<Run> runs_;
};

}  // namespace tricontact::contact
