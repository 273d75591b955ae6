#include "fem/case/row_response.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

// Both bodies are the same anywhere along their surface: a cylinder around its hub, by elements
// that are equal along it; a layer but for its sides. Tractions on whole elements, and the mean
// displacements of these, then depend on the distance alone: the response of the middle of a patch
// is that of any place. How far that is from being true, the other rows of the matrix tell.

namespace tricontact::fem {

namespace {

/// The matrix of a row of points of equal area, displacement over traction.
class RowMatrix {
  public:
    RowMatrix(std::span<const double> matrix, double area)
        : matrix_(matrix), n_(row_length(matrix)), area_(area) {}
    int n() const { return n_; }
    /// Components: 0 x, 2 z.
    double at(int component, int i, int of_traction, int k) const {
        const std::size_t n = n_, row = component * n + i, column = of_traction * n + k;
        return matrix_[column * 3 * n + row] * area_;
    }

  private:
    static int row_length(std::span<const double> matrix) {
        return static_cast<int>(std::lround(std::sqrt(static_cast<double>(matrix.size())) / 3));
    }

    std::span<const double> matrix_;
    int n_;
    double area_;
};

/// Of both cells in the middle, to both sides.
CellResponse::Coefficients middle_response(const RowMatrix& a, int distance) {
    CellResponse::Coefficients sum;
    for (const int k : {a.n() / 2 - 1, a.n() / 2})
        for (const int sign : {-1, 1}) {
            const int i = k + sign * distance;
            // Farther than the patch on one side: the other one tells.
            const int at = i < 0 || i >= a.n() ? k - sign * distance : i;
            sum.xx += a.at(0, at, 0, k) / 4;
            sum.zz += a.at(2, at, 2, k) / 4;
            sum.xz += (at < k ? -1 : 1) * (distance > 0 ? a.at(0, at, 2, k) / 4 : 0);
        }
    sum.yy = sum.xx;  // nothing acts along y
    return sum;
}

/// See CellResponse::variation, for cells this far from the middle.
double variation_within(const RowMatrix& a, const CellResponse& r, int reach) {
    const int first = std::max(0, a.n() / 2 - reach), last = std::min(a.n() - 1, a.n() / 2 + reach);
    double worst = 0;
    for (int k = first; k <= last; ++k)
        for (int i = first; i <= last; ++i) {
            const auto& one = r.cells[std::min(std::abs(i - k), r.n_x - 1)];
            const double xz = i < k ? -one.xz : one.xz;
            worst =
                std::max({worst, std::abs(a.at(0, i, 0, k) - one.xx),
                          std::abs(a.at(2, i, 2, k) - one.zz), std::abs(a.at(0, i, 2, k) - xz)});
        }
    return worst / r.cells.front().zz;
}

}  // namespace

void set_row_response(std::span<const double> matrix, double area, int n_positions,
                      CellResponse& response) {
    const RowMatrix on_cells(matrix, area);
    response.n_x = n_positions;
    response.n_y = 1;
    response.cells.clear();
    for (int i = 0; i < n_positions; ++i) response.cells.push_back(middle_response(on_cells, i));
    const int reach = static_cast<int>(std::ceil(response.contact_radius / response.size));
    response.variation = variation_within(on_cells, response, reach);
}

void say_cells(const std::string& model, const CellResponse& response, const Say& say) {
    if (!say) return;
    std::string line = fmt::format("{}: cells of {:.4g} mm, {:.3g} across the contact", model,
                                   1e3 * response.size, response.contact_radius / response.size);
    if (response.variation)
        line += fmt::format(
            "; by where it is, the response of a cell varies within the contact by {:.2g} of that "
            "to itself",
            *response.variation);
    say(line);
}

}  // namespace tricontact::fem
