#pragma once

#include <functional>
#include <map>
#include <utility>
#include <vector>

namespace tricontact::report {

/// Values at one place of a table, equally many everywhere.
using TableNode = std::function<std::vector<double>(double x, double z)>;

/// Smooth functions of x and z, interpolated by cubic polynomials between places x = i x_step,
/// z = k z_step that are computed when first needed. Relative error of order step^4.
class LazyTable {
  public:
    struct Rows {
        int first = 0, last = 0;  ///< of k; beyond them values are extrapolated
    };
    /// At least four `rows`, or one: then nothing depends on z.
    LazyTable(TableNode node, double x_step, double z_step, Rows rows);

    std::vector<double> at(double x, double z);
    /// Places computed so far.
    std::size_t n_nodes() const { return nodes_.size(); }

  private:
    const std::vector<double>& node(int i, int k);

    TableNode node_;
    double x_step_, z_step_;
    Rows rows_;
    std::map<std::pair<int, int>, std::vector<double>> nodes_;
};

}  // namespace tricontact::report
