#include "fem/planar/node_line.h"

#include <stdexcept>

#include "meshes/layer_grid.h"

namespace tricontact::fem::planar {

namespace {

void add_element(NodeLine& line, double end) {
    line.push_back((line.back() + end) / 2);
    line.push_back(end);
}

}  // namespace

NodeLine equal_elements(int n, double size) {
    NodeLine line{0};
    for (int k = 1; k <= 2 * n; ++k) line.push_back(k * size / 2);
    return line;
}

NodeLine continued(NodeLine line, double end, double growth) {
    const double last = line.back() - line[line.size() - 3], rest = end - line.back();
    if (!(rest >= -1e-9 * last))
        throw std::invalid_argument("continued: the line ends behind its end");
    if (rest <= 1e-9 * last) return line;
    // Together with the last one, over its length.
    const double total = 1 + rest / last;
    int n = 1;
    while (meshes::geometric_sum(n + 1, growth) < total) ++n;
    const double factor = meshes::growth_ratio(n + 1, total, growth);
    double size = last;
    for (int k = 1; k < n; ++k) add_element(line, line.back() + (size *= factor));
    add_element(line, end);
    return line;
}

NodeLine normalised(const NodeLine& line) {
    NodeLine unit(line);
    for (double& x : unit) x = (x - line.front()) / (line.back() - line.front());
    unit.back() = 1;
    return unit;
}

NodeLine reversed(const NodeLine& line) {
    NodeLine other(line.rbegin(), line.rend());
    for (double& x : other) x = 1 - x;
    return other;
}

}  // namespace tricontact::fem::planar
