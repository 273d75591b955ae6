#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace tricontact::statistics {

/// Of a sparse polynomial and of a sample sequence.
inline constexpr int most_variables = 6;

/// p(x) = sum over terms t of coefficients[t] prod_d T_k(x_d) with k = degrees[t * n_variables + d]
/// and T_k Chebyshev's polynomials of the first kind; meant for x in [-1, 1]^n_variables, outside
/// of which it grows like |2 x|^k. In any order; in lexicographic order of degrees `evaluate` of
/// many points shares most products.
struct SparsePolynomial {
    int n_variables = 0;                ///< 1 ... most_variables
    std::vector<std::uint8_t> degrees;  ///< n_variables per term, term after term
    std::vector<double> coefficients;   ///< one per term

    std::size_t n_terms() const { return coefficients.size(); }
    /// Of each variable; zeros without terms.
    std::vector<int> largest_degrees() const;
};

/// T_k(x_d) of one point, shared by all polynomials that are wanted there.
class ChebyshevTable {
  public:
    /// Throws std::invalid_argument unless n_variables is 1 ... most_variables.
    explicit ChebyshevTable(int n_variables);

    /// From the next point on the table reaches as far as this polynomial needs. Throws
    /// std::invalid_argument if it has other variables, or sizes that do not agree.
    void cover(const SparsePolynomial& polynomial);

    /// n_variables coordinates.
    void set_point(std::span<const double> x);

    int n_variables() const { return n_variables_; }
    /// Of a polynomial that the table covers; of another one the value is meaningless.
    double evaluate(const SparsePolynomial& polynomial) const;

  private:
    static constexpr int n_degrees = 256;  // all that a degree of eight bits can say

    int n_variables_;
    std::array<int, most_variables> largest_{};
    std::array<double, most_variables * n_degrees> values_{};
};

/// At one point: makes a table for it. Throws std::invalid_argument as `cover`, and if x is not a
/// coordinate per variable.
double evaluate(const SparsePolynomial& polynomial, std::span<const double> x);

/// At many points, the n_variables coordinates of one after those of the other; faster per point
/// than one by one, and equal to that but for rounding. Throws as above.
std::vector<double> evaluate_all(const SparsePolynomial& polynomial,
                                 std::span<const double> points);

}  // namespace tricontact::statistics
