#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "fem/condensed_layer.h"
#include "fem/element.h"

namespace tricontact::fem {

/// One direction of a block between parallel planes.
struct BlockAxis {
    std::vector<double> planes;  ///< of elements [m], ascending
    /// Bit c of each end: displacement c is held there.
    std::array<std::uint8_t, 2> held{};

    int n_elements() const { return static_cast<int>(planes.size()) - 1; }
    int n_nodes() const { return 2 * n_elements() + 1; }
    double edge(int element) const { return planes[element + 1] - planes[element]; }
    double node(int k) const {
        return k % 2 ? .5 * (planes[k / 2] + planes[k / 2 + 1]) : planes[k / 2];
    }
};

/// A body whose elements are bricks between planes x, y, z = const, of layers in z, each of its
/// sides held in one way: the stiffness is a sum of products of matrices of one direction each.
/// Nodes and elements are numbered with x fastest.
struct BlockGrid {
    std::array<BlockAxis, 3> axes;
    std::vector<Moduli> moduli;  ///< per element along z
    bool mirrored = false;       ///< in the plane of least y

    std::size_t n_nodes() const {
        return static_cast<std::size_t>(axes[0].n_nodes()) * axes[1].n_nodes() * axes[2].n_nodes();
    }
    std::size_t n_elements() const {
        return static_cast<std::size_t>(axes[0].n_elements()) * axes[1].n_elements() *
               axes[2].n_elements();
    }
    std::size_t node(int i, int j, int k) const {
        return (static_cast<std::size_t>(k) * axes[1].n_nodes() + j) * axes[0].n_nodes() + i;
    }
    std::size_t nearest_node(const std::array<double, 3>& x) const;
};

/// The block that the problem's mesh is; empty if it is none, then `why` says what is in the way.
/// Throws contact::InputError when rigid motions remain.
std::optional<BlockGrid> block_grid(const LayerProblem& problem, std::string& why);

struct Discretisation;
/// Where each free unknown of the body stands among u_x of all nodes of the block, u_y, u_z.
std::vector<std::size_t> places_in_block(const Discretisation& body, const BlockGrid& grid);
/// The block's element that each cell of the body is.
std::vector<std::size_t> elements_in_block(const Discretisation& body, const BlockGrid& grid);

}  // namespace tricontact::fem
