#pragma once

#include <vector>

namespace tricontact::fem::planar {

/// Positions of the nodes of n quadratic elements along a line [m]: 2n + 1, increasing, ends and
/// middles by turns.
using NodeLine = std::vector<double>;

/// `n` elements of the length `size` [m] from 0 on.
NodeLine equal_elements(int n, double size);

/// `line` continued to `end` [m] by elements that grow from the last one by at most the factor
/// `growth` > 1 each, all by the same one. Throws std::invalid_argument if the line is longer.
NodeLine continued(NodeLine line, double end, double growth);

/// From 0 to 1, as `line` from its first to its last node.
NodeLine normalised(const NodeLine& line);
/// 1 - x of a normalised line, increasing.
NodeLine reversed(const NodeLine& line);

}  // namespace tricontact::fem::planar
