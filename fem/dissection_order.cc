#include "fem/dissection_order.h"

#include <metis.h>

#include <csignal>
#include <new>
#include <stdexcept>

#include "contact/base/interruption.h"
#include "fem/memory.h"

// Nested dissection on the graph of nodes instead of unknowns: a third of the vertices, and the
// three directions of a node stay together, which makes supernodes wide. METIS has a seed, so the
// order and with it every bit of the compliance is the same in every run.

namespace tricontact::fem {

namespace {

// Interior nodes with their unknowns, and which of them share an element.
struct NodeGraph {
    std::vector<int> first_unknown;  // unknowns of node i: first_unknown[i] to [i + 1], excluded
    std::vector<idx_t> start, neighbour;

    NodeGraph(const SparseMatrix& stiffness, std::span<const int> node_of_unknown, int n_interior) {
        std::vector<int> graph_node(n_interior);
        for (int u = 0; u < n_interior; ++u) {
            if (u == 0 || node_of_unknown[u] != node_of_unknown[u - 1]) first_unknown.push_back(u);
            graph_node[u] = static_cast<int>(first_unknown.size()) - 1;
        }
        first_unknown.push_back(n_interior);
        // One unknown speaks for its node: all of two nodes couple or none.
        const auto for_pairs = [&](auto visit) {
            for (int i = 0; i < size(); ++i) {
                const int u = first_unknown[i];
                for (auto k = stiffness.column_start[u]; k < stiffness.column_start[u + 1]; ++k) {
                    const auto r = stiffness.row[k];
                    if (r >= n_interior) break;
                    const int j = graph_node[r];
                    if (j != i && first_unknown[j] == r) visit(i, j);
                }
            }
        };
        start.assign(size() + 1, 0);
        for_pairs([&](int i, int j) { ++start[i + 1], ++start[j + 1]; });
        for (int i = 0; i < size(); ++i) start[i + 1] += start[i];
        reserve_large(neighbour, start.back());
        neighbour.resize(start.back());
        std::vector<idx_t> next(start.begin(), start.end() - 1);
        for_pairs([&](int i, int j) { neighbour[next[i]++] = j, neighbour[next[j]++] = i; });
    }

    int size() const { return static_cast<int>(first_unknown.size()) - 1; }
};

std::vector<idx_t> nested_dissection(NodeGraph& graph) {
    std::vector<idx_t> order(graph.size()), position(graph.size());
    idx_t options[METIS_NOPTIONS];
    METIS_SetDefaultOptions(options);
    options[METIS_OPTION_NUMBERING] = 0;
    options[METIS_OPTION_SEED] = 1;  // the same order in every run
    idx_t n = graph.size();
    const auto dissect = [&] {
        return METIS_NodeND(&n, graph.start.data(), graph.neighbour.data(), nullptr, options,
                            order.data(), position.data());
    };
    int status = dissect();
    // METIS catches SIGTERM while it works and returns this error. The signal is sent once more,
    // now that METIS' handler is gone; who outlives it (a handler of Python's, none at all) goes
    // on.
    if (status == METIS_ERROR) {
        std::raise(SIGTERM);
        contact::interruption_point();
        status = dissect();
    }
    if (status == METIS_ERROR_MEMORY) throw std::bad_alloc();
    if (status != METIS_OK) throw std::logic_error("METIS_NodeND refuses the graph of the nodes");
    return order;
}

}  // namespace

std::vector<std::int64_t> dissection_order(const SparseMatrix& stiffness,
                                           std::span<const int> node_of_unknown, int n_interior) {
    std::vector<std::int64_t> order;
    order.reserve(stiffness.n);
    if (n_interior > 0) {
        NodeGraph graph(stiffness, node_of_unknown, n_interior);
        for (const idx_t node : nested_dissection(graph))
            for (int u = graph.first_unknown[node]; u < graph.first_unknown[node + 1]; ++u)
                order.push_back(u);
    }
    for (int u = n_interior; u < stiffness.n; ++u) order.push_back(u);
    return order;
}

}  // namespace tricontact::fem
