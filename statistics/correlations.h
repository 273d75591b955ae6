#pragma once

#include <string>
#include <vector>

namespace tricontact::statistics {

/// Coefficients of correlation of quantities by their names; pairs that are not stated are
/// independent.
class Correlations {
  public:
    /// A matrix has a row per quantity; an empty one: all are independent.
    using Matrix = std::vector<std::vector<double>>;

    /// Throws std::invalid_argument unless -1 < coefficient < 1 and the pair is new and of two.
    void add(const std::string& first, const std::string& second, double coefficient);
    bool empty() const { return pairs_.empty(); }

    /// r_ij of these quantities; empty if none of them are correlated with each other.
    Matrix of(const std::vector<std::string>& names) const;
    /// Whether there are quantities with the correlations of these.
    bool is_possible(const std::vector<std::string>& names) const;

  private:
    struct Pair {
        std::string first, second;
        double coefficient;
    };
    std::vector<Pair> pairs_;
};

/// Variance sum_ij c_i r_ij c_j of what changes by c_i with the standard error of each quantity
/// (JCGM 100:2008, eq. 16).
double combined_variance(const std::vector<double>& changes,
                         const Correlations::Matrix& correlation);

/// The part of it that the correlations add: 0 of independent quantities.
double covariance_part(const std::vector<double>& changes, const Correlations::Matrix& correlation);

/// L with L L' = r, lower triangle: L z is correlated like r if z is independent. The unit matrix
/// of an empty one of `n`. Throws std::invalid_argument unless positive definite.
Correlations::Matrix triangular_root(const Correlations::Matrix& correlation, std::size_t n);
/// L z of such a root.
std::vector<double> correlated(const Correlations::Matrix& root,
                               const std::vector<double>& independent);

}  // namespace tricontact::statistics
