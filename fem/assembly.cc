#include "fem/assembly.h"

#include <algorithm>

namespace tricontact::fem {

namespace {

using Cell = std::array<int, 27>;

// Cells of each node, by compressed rows.
struct CellsOfNodes {
    std::vector<int> start, cell;

    explicit CellsOfNodes(const Q2Space& space) : start(space.nodes().size() + 1, 0) {
        for (const Cell& nodes : space.cells())
            for (const int node : nodes) ++start[node + 1];
        for (std::size_t i = 1; i < start.size(); ++i) start[i] += start[i - 1];
        cell.resize(start.back());
        std::vector<int> next(start.begin(), start.end() - 1);
        for (std::size_t c = 0; c < space.cells().size(); ++c)
            for (const int node : space.cells()[c]) cell[next[node]++] = static_cast<int>(c);
    }
};

// Calls visit(node, sorted unknowns of all nodes that share a cell with it).
template <typename Visit>
void for_neighbourhoods(const Q2Space& space, const Unknowns& unknowns, Visit visit) {
    const CellsOfNodes cells(space);
    std::vector<int> seen_by(space.nodes().size(), -1), neighbours;
    for (int node = 0; node < static_cast<int>(seen_by.size()); ++node) {
        neighbours.clear();
        for (int k = cells.start[node]; k < cells.start[node + 1]; ++k)
            for (const int other : space.cells()[cells.cell[k]]) {
                if (seen_by[other] == node) continue;
                seen_by[other] = node;
                for (const int unknown : unknowns.of_node[other])
                    if (unknown >= 0) neighbours.push_back(unknown);
            }
        std::ranges::sort(neighbours);
        visit(node, neighbours);
    }
}

SparseMatrix pattern(const Q2Space& space, const Unknowns& unknowns) {
    SparseMatrix matrix;
    matrix.n = unknowns.n;
    matrix.column_start.assign(unknowns.n + 1, 0);
    const auto below = [](const std::vector<int>& neighbours, int unknown) {
        return std::ranges::lower_bound(neighbours, unknown);
    };
    for_neighbourhoods(space, unknowns, [&](int node, const std::vector<int>& neighbours) {
        for (const int u : unknowns.of_node[node])
            if (u >= 0) matrix.column_start[u + 1] = neighbours.end() - below(neighbours, u);
    });
    for (int u = 0; u < unknowns.n; ++u) matrix.column_start[u + 1] += matrix.column_start[u];
    matrix.row.resize(matrix.column_start.back());
    for_neighbourhoods(space, unknowns, [&](int node, const std::vector<int>& neighbours) {
        for (const int u : unknowns.of_node[node])
            if (u >= 0)
                std::copy(below(neighbours, u), neighbours.end(),
                          matrix.row.begin() + matrix.column_start[u]);
    });
    matrix.value.assign(matrix.row.size(), 0.0);
    return matrix;
}

// The unknowns of one element: increasing, each with its row in the element's stiffness; and its
// held components.
struct LocalUnknowns {
    struct Pair {
        int unknown, local;
    };
    std::vector<Pair> free, held;

    void gather(const Cell& nodes, const Unknowns& unknowns) {
        free.clear();
        held.clear();
        for (int c = 0; c < 3; ++c)
            for (int i = 0; i < 27; ++i) {
                const int unknown = unknowns.of_node[nodes[i]][c];
                (unknown >= 0 ? free : held).push_back({unknown, c * 27 + i});
            }
        std::ranges::sort(free, {}, &Pair::unknown);
    }
};

void add(const ElementStiffness& k, const LocalUnknowns& local, AssembledStiffness& to) {
    auto& [n, start, row, value] = to.matrix;
    for (std::size_t c = 0; c < local.free.size(); ++c) {
        const auto [column, local_column] = local.free[c];
        std::int64_t at = start[column];
        for (std::size_t r = c; r < local.free.size(); ++r) {
            while (row[at] != local.free[r].unknown) ++at;
            value[at] += k[local_column][local.free[r].local];
        }
        for (const auto& held : local.held)
            to.held_rows[held.local / 27][column] += k[local_column][held.local];
    }
}

}  // namespace

AssembledStiffness assemble(const Q2Space& space, const Unknowns& unknowns,
                            const std::array<Moduli, meshes::n_regions>& moduli) {
    AssembledStiffness stiffness;
    stiffness.matrix = pattern(space, unknowns);
    for (auto& row : stiffness.held_rows) row.assign(unknowns.n, 0.0);
    ElementValues values(space, 3);
    LocalUnknowns local;
    auto k = std::make_unique<ElementStiffness>();
    for (std::size_t c = 0; c < space.cells().size(); ++c) {
        values.reinit(c);
        element_stiffness(values, moduli[static_cast<int>(space.regions()[c])], *k);
        local.gather(space.cells()[c], unknowns);
        add(*k, local, stiffness);
    }
    return stiffness;
}

std::array<double, 3> held_forces(const Q2Space& space, const Unknowns& unknowns,
                                  const std::array<Moduli, meshes::n_regions>& moduli,
                                  const std::vector<std::array<double, 3>>& displacement) {
    std::array<double, 3> forces{};
    ElementValues values(space, 3);
    LocalUnknowns local;
    auto k = std::make_unique<ElementStiffness>();
    for (std::size_t c = 0; c < space.cells().size(); ++c) {
        const Cell& nodes = space.cells()[c];
        local.gather(nodes, unknowns);
        if (local.held.empty()) continue;
        values.reinit(c);
        element_stiffness(values, moduli[static_cast<int>(space.regions()[c])], *k);
        for (const auto& held : local.held)
            for (int r = 0; r < 81; ++r)
                forces[held.local / 27] +=
                    (*k)[held.local][r] * displacement[nodes[r % 27]][r / 27];
    }
    return forces;
}

}  // namespace tricontact::fem
