#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace tricontact::fem {

/// A Cholesky factor in single precision, by panels of a few columns whose rows below the triangle
/// are the same. Half the memory and less than half the time of the factor itself, which goes into
/// reading it; with an error of 1e-6 or more: for corrections, which are computed again from what
/// the last one left. Solutions come in two halves, for forces on the contact unknowns that depend
/// on what the others do there.
class SingleFactor {
  public:
    /// Most columns of a panel: more read more zeros, fewer say too often which rows they have.
    static constexpr std::int64_t widest_panel = 96;

    /// `order`: unknown that is eliminated k-th; the first `n_interior` are those before the
    /// contact unknowns. `n_values`: at least as many as the panels hold.
    SingleFactor(std::vector<int> order, int n_interior, std::size_t n_values);
    /// The next columns, at most widest_panel, of the interior or of the contact unknowns. `row`:
    /// places in `order`, the columns' own first. `column`: `row.size()` entries of each, `ld`
    /// between them.
    void add(int n_columns, std::span<const std::int64_t> row, const double* column,
             std::size_t ld);

    /// L^-1 f for `forces` f on all unknowns [N].
    std::vector<float> eliminate(std::span<const double> forces) const;
    /// Displacements of the contact unknowns under what was eliminated [m].
    std::vector<double> contact_displacements(std::span<const float> eliminated) const;
    /// All displacements [m] if `contact_forces` [N] act beside what was eliminated.
    std::vector<double> complete(std::span<const float> eliminated,
                                 std::span<const double> contact_forces) const;

  private:
    /// The columns of a panel, inverted: [L11^-1; L21 L11^-1], n_rows x n_columns.
    struct Panel {
        int column, n_columns, n_rows;
        std::size_t first_row;  ///< in rows_: those below the triangle
        std::size_t first;      ///< in values_
    };
    void divide(std::vector<float>& x, std::span<const Panel> panels) const;
    void divide_transposed(std::vector<float>& x, std::span<const Panel> panels) const;
    std::span<const Panel> contact_panels() const;

    std::vector<int> order_;
    int n_interior_;
    std::vector<Panel> panels_;
    std::vector<int> rows_;
    std::vector<float> values_;
    std::size_t n_interior_panels_ = 0;
    int most_rows_ = 0;
};

}  // namespace tricontact::fem
