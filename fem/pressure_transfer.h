#pragma once

#include <vector>

namespace tricontact::fem {

/// int phi_i psi_k dA over a pressure grid [m^2], of the nodes i of a surface and the grid's points
/// k: forces on nodes are its product with the pressures of points (mortar/pressure_grid.h).
struct PressureTransfer {
    struct Entry {
        int node, point;
        double value;
    };
    int n_nodes = 0, n_points = 0;
    std::vector<Entry> entries;  ///< those of one place are summed up
};

}  // namespace tricontact::fem
