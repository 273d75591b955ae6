#include "statistics/sparse_polynomial.h"

#include <algorithm>
#include <stdexcept>

// Clones do the same operations in wider vectors: without contraction they give the same bytes.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#define TRICONTACT_WIDER_VECTORS __attribute__((target_clones("arch=x86-64-v4", "avx2", "default")))
#else
#define TRICONTACT_WIDER_VECTORS
#endif

namespace tricontact::statistics {

namespace {

void check_polynomial(const SparsePolynomial& p) {
    if (p.n_variables < 1 || p.n_variables > most_variables)
        throw std::invalid_argument("a sparse polynomial has 1 to 6 variables");
    if (p.degrees.size() != p.coefficients.size() * static_cast<std::size_t>(p.n_variables))
        throw std::invalid_argument("a sparse polynomial has a degree per term and variable");
}

// Four sums: a single one would wait for each of its additions.
template <int D>
double sum_of_terms(const SparsePolynomial& p, const double* table, int stride) {
    constexpr std::size_t n_sums = 4;
    const std::uint8_t* degrees = p.degrees.data();
    const double* coefficients = p.coefficients.data();
    const auto term = [&](std::size_t t) {
        const std::uint8_t* k = degrees + t * D;
        double product = coefficients[t];
        for (int d = 0; d < D; ++d) product *= table[d * stride + k[d]];
        return product;
    };
    std::array<double, n_sums> sums{};
    const std::size_t n = p.n_terms();
    std::size_t t = 0;
    for (; t + n_sums <= n; t += n_sums)
        for (std::size_t s = 0; s < n_sums; ++s) sums[s] += term(t + s);
    for (; t < n; ++t) sums[0] += term(t);
    return (sums[0] + sums[1]) + (sums[2] + sums[3]);
}

// T_0 ... T_largest at x: T_(k+1) = 2 x T_k - T_(k-1).
void fill_row(double x, int largest, double* row) {
    row[0] = 1;
    if (largest > 0) row[1] = x;
    for (int k = 2; k <= largest; ++k) row[k] = 2 * x * row[k - 1] - row[k - 2];
}

// Points that are evaluated together: tables and products of a block stay in the first cache.
constexpr std::size_t n_lanes = 32;

// The same for n_lanes numbers, rows of which follow each other.
TRICONTACT_WIDER_VECTORS
void fill_lane_rows(const double* x, int largest, double* rows) {
    for (std::size_t i = 0; i < n_lanes; ++i) rows[i] = 1;
    if (largest > 0)
        for (std::size_t i = 0; i < n_lanes; ++i) rows[n_lanes + i] = x[i];
    for (int k = 2; k <= largest; ++k) {
        double* out = rows + static_cast<std::size_t>(k) * n_lanes;
        const double *before = out - n_lanes, *earlier = before - n_lanes;
        for (std::size_t i = 0; i < n_lanes; ++i) out[i] = 2 * x[i] * before[i] - earlier[i];
    }
}

// Adds up all terms for n_lanes points side by side. The rows T_k of variable d begin at
// table[begin[d]]; term t has its first shared[t] degrees from the term before.
TRICONTACT_WIDER_VECTORS
void add_lane_terms(const SparsePolynomial& p, const std::uint8_t* shared, const double* table,
                    const std::size_t* begin, double* sums) {
    const auto last = static_cast<std::size_t>(p.n_variables) - 1;
    std::array<std::array<double, n_lanes>, most_variables> products;  // of the first d factors
    products[0].fill(1);
    for (std::size_t i = 0; i < n_lanes; ++i) sums[i] = 0;
    for (std::size_t t = 0; t < p.n_terms(); ++t) {
        const std::uint8_t* k = p.degrees.data() + t * (last + 1);
        for (std::size_t d = shared[t]; d < last; ++d) {
            const double* row = table + begin[d] + k[d] * n_lanes;
            for (std::size_t i = 0; i < n_lanes; ++i) products[d + 1][i] = products[d][i] * row[i];
        }
        const double* row = table + begin[last] + k[last] * n_lanes;
        const double c = p.coefficients[t];
        for (std::size_t i = 0; i < n_lanes; ++i) sums[i] += c * products[last][i] * row[i];
    }
}

// The terms of a polynomial for blocks of points.
class Block {
  public:
    explicit Block(const SparsePolynomial& p) : p_(p), largest_(p.largest_degrees()) {
        std::size_t rows = 0;
        for (const int largest : largest_) {
            begin_.push_back(rows * n_lanes);
            rows += static_cast<std::size_t>(largest) + 1;
        }
        table_.resize(rows * n_lanes);
        find_shared();
    }

    // `n` <= n_lanes points; values of the lanes beyond are those of the first point.
    void evaluate(const double* points, std::size_t n, double* values) {
        const auto n_variables = static_cast<std::size_t>(p_.n_variables);
        for (std::size_t d = 0; d < n_variables; ++d) {
            for (std::size_t i = 0; i < n_lanes; ++i)
                x_[i] = points[(i < n ? i : 0) * n_variables + d];
            fill_lane_rows(x_.data(), largest_[d], table_.data() + begin_[d]);
        }
        add_lane_terms(p_, shared_.data(), table_.data(), begin_.data(), sums_.data());
        std::copy_n(sums_.data(), n, values);
    }

  private:
    // Of each term: its leading variables whose degrees are those of the term before.
    void find_shared() {
        const auto n_variables = static_cast<std::size_t>(p_.n_variables);
        for (std::size_t t = 0; t < p_.n_terms(); ++t) {
            std::size_t n = 0;
            const std::uint8_t* k = p_.degrees.data() + t * n_variables;
            if (t > 0)
                while (n + 1 < n_variables && k[n] == (k - n_variables)[n]) ++n;
            shared_.push_back(static_cast<std::uint8_t>(n));
        }
    }

    const SparsePolynomial& p_;
    std::vector<int> largest_;
    std::vector<std::size_t> begin_;  // of each variable's rows in the table
    std::vector<double> table_;       // rows of T_k, lanes side by side
    std::vector<std::uint8_t> shared_;
    std::array<double, n_lanes> x_{}, sums_{};
};

}  // namespace

std::vector<int> SparsePolynomial::largest_degrees() const {
    std::vector<int> largest(static_cast<std::size_t>(n_variables), 0);
    for (std::size_t t = 0; t < degrees.size(); t += largest.size())
        for (std::size_t d = 0; d < largest.size(); ++d)
            largest[d] = std::max<int>(largest[d], degrees[t + d]);
    return largest;
}

ChebyshevTable::ChebyshevTable(int n_variables) : n_variables_(n_variables) {
    if (n_variables < 1 || n_variables > most_variables)
        throw std::invalid_argument("a table of Chebyshev polynomials has 1 to 6 variables");
}

void ChebyshevTable::cover(const SparsePolynomial& polynomial) {
    check_polynomial(polynomial);
    if (polynomial.n_variables != n_variables_)
        throw std::invalid_argument("a polynomial of other variables than its table's");
    const std::vector<int> largest = polynomial.largest_degrees();
    for (std::size_t d = 0; d < largest.size(); ++d)
        largest_[d] = std::max(largest_[d], largest[d]);
}

void ChebyshevTable::set_point(std::span<const double> x) {
    if (x.size() != static_cast<std::size_t>(n_variables_))
        throw std::invalid_argument("a point has a coordinate per variable");
    for (std::size_t d = 0; d < x.size(); ++d)
        fill_row(x[d], largest_[d], values_.data() + d * n_degrees);
}

double ChebyshevTable::evaluate(const SparsePolynomial& polynomial) const {
    const double* table = values_.data();
    switch (n_variables_) {
        case 1:
            return sum_of_terms<1>(polynomial, table, n_degrees);
        case 2:
            return sum_of_terms<2>(polynomial, table, n_degrees);
        case 3:
            return sum_of_terms<3>(polynomial, table, n_degrees);
        case 4:
            return sum_of_terms<4>(polynomial, table, n_degrees);
        case 5:
            return sum_of_terms<5>(polynomial, table, n_degrees);
        default:
            return sum_of_terms<6>(polynomial, table, n_degrees);
    }
}

double evaluate(const SparsePolynomial& polynomial, std::span<const double> x) {
    ChebyshevTable table(polynomial.n_variables);
    table.cover(polynomial);
    table.set_point(x);
    return table.evaluate(polynomial);
}

std::vector<double> evaluate_all(const SparsePolynomial& polynomial,
                                 std::span<const double> points) {
    check_polynomial(polynomial);
    const auto n_variables = static_cast<std::size_t>(polynomial.n_variables);
    if (points.size() % n_variables != 0)
        throw std::invalid_argument("points have a coordinate per variable");
    const std::size_t n = points.size() / n_variables;
    std::vector<double> values(n);
    Block block(polynomial);
    for (std::size_t i = 0; i < n; i += n_lanes)
        block.evaluate(points.data() + i * n_variables, std::min(n_lanes, n - i),
                       values.data() + i);
    return values;
}

}  // namespace tricontact::statistics
