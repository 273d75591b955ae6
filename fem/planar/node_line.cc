#include "fem/planar/node_line.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace tricontact::fem::planar {

namespace {

void add_element(NodeLine& line, double end) {
    line.push_back((line.back() + end) / 2);
    line.push_back(end);
}

/// Length of n elements behind one of length 1, growing by a factor.
double grown_length(int n, double growth) {
    double sum = 0, size = 1;
    for (int k = 0; k < n; ++k) sum += size *= growth;
    return sum;
}

/// The factor with which n elements have this length, below `growth`.
double growth_for(int n, double length, double growth) {
    double low = 0, high = growth;
    for (int k = 0; k < 60; ++k) {
        const double middle = (low + high) / 2;
        (grown_length(n, middle) < length ? low : high) = middle;
    }
    return high;
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
    int n = 1;
    while (grown_length(n, growth) < rest / last) ++n;
    const double factor = growth_for(n, rest / last, growth);
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
