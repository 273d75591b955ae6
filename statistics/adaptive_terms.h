#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <set>
#include <span>
#include <vector>

#include "statistics/growing_least_squares.h"
#include "statistics/sparse_polynomial.h"

namespace tricontact::statistics {

/// Degrees of a term; zero beyond its variables.
using Degrees = std::array<std::uint8_t, most_variables>;

/// prod_d T_k(x_d) at many points, each factor of degree > 0 times sqrt(2): orthonormal under the
/// Chebyshev measure.
class TermColumns {
  public:
    /// The points stay with the caller.
    TermColumns(std::span<const double> points, int n_variables);
    std::vector<double> column(const Degrees& degrees);
    std::size_t n_points() const { return n_points_; }
    int n_variables() const { return n_variables_; }

  private:
    const std::vector<double>& factor(std::size_t variable, std::size_t degree);

    std::span<const double> points_;
    std::size_t n_points_;
    int n_variables_;
    // sqrt(2) T_k of each variable, from degree 1 on, at all points.
    std::array<std::vector<std::vector<double>>, most_variables> factors_;
};

/// The polynomial of these terms with the coefficients of their columns, in lexicographic order,
/// without those of at most `least` in amount.
SparsePolynomial make_polynomial(const std::vector<Degrees>& terms,
                                 const std::vector<double>& coefficients, int n_variables,
                                 double least);

/// All terms of total degree `degree`.
std::vector<Degrees> terms_of_degree(int degree, int n_variables);

/// A set of terms and its admissible neighbours: terms outside which in each variable that they
/// have are supported by one of degree lower by one or two in the set. With one only, the sets
/// would be downward closed, and an even function, of which no odd term explains anything, would
/// lose its way or take 2^D times its terms along.
class AdaptiveTerms {
  public:
    /// Columns and least squares stay with the caller.
    AdaptiveTerms(TermColumns& columns, GrowingLeastSquares& squares);

    /// False, and nothing appended, if the column depends on those before.
    bool append(const Degrees& degrees);
    /// Those that explain most of the residual, the best one first: a few per hundred terms, as far
    /// as they come near it. Where a neighbour explains little, but the next degree in one of its
    /// variables much, the mean of the two counts: without, a search stops at the first term that
    /// happens to be zero.
    std::vector<Degrees> best_neighbours() const;
    /// In the order of appending.
    const std::vector<Degrees>& terms() const { return terms_; }

  private:
    struct Neighbour {
        std::vector<double> column;
        double length_squared = 0;
        bool is_admissible = false;  ///< else only looked at
    };
    bool admits(const Degrees& degrees) const;
    Neighbour& look_at(const Degrees& degrees);

    TermColumns& columns_;
    GrowingLeastSquares& squares_;
    std::vector<Degrees> terms_;
    std::set<Degrees> set_, dependent_;
    std::map<Degrees, Neighbour> neighbours_;
};

}  // namespace tricontact::statistics
