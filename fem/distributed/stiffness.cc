#include "fem/distributed/stiffness.h"

#include <deal.II/base/index_set.h>
#include <deal.II/distributed/tria.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/mapping_q1.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/petsc_sparse_matrix.h>
#include <deal.II/lac/petsc_vector.h>
#include <deal.II/lac/sparsity_tools.h>

#include <algorithm>
#include <map>

#include "fem/deal_ii/q2_elements.h"
#include "fem/discretisation.h"
#include "fem/element.h"

// The same stiffness as fem/assembly.cc, distributed: each rank has a part of the elements (p4est's
// space-filling curve) and the rows of its nodes. Held components keep a row, decoupled from the
// others: rows are then three per node on every rank (docs/how-to/scaling.md).

namespace tricontact::fem::distributed {

namespace {

using meshes::Boundary;
using meshes::HexMesh;

// Hexahedra and nodes; returns the new number of each old node, -1: not in the part.
std::vector<int> take_hexes(const HexMesh& mesh, std::span<const int> hexes, HexMesh& part) {
    std::vector<int> number(mesh.nodes.size(), -1);
    for (const int h : hexes) {
        auto& nodes = part.hexes.emplace_back(mesh.hexes[h]);
        part.regions.push_back(mesh.regions[h]);
        for (int& node : nodes) {
            if (number[node] < 0) {
                number[node] = static_cast<int>(part.nodes.size());
                part.nodes.push_back(mesh.nodes[node]);
            }
            node = number[node];
        }
    }
    return number;
}

using Triangulation = dealii::parallel::distributed::Triangulation<3>;
using Cell = dealii::DoFHandler<3>::active_cell_iterator;
using Number = dealii::types::global_dof_index;
using Nodes = std::array<std::array<double, 3>, 27>;
using Numbers = std::array<Number, 81>;  // of component c of node i at c * 27 + i
const MPI_Comm all_ranks = MPI_COMM_WORLD;

int id_of(Boundary boundary) {
    return static_cast<int>(boundary) + 1;
}

bool touches(const dealii::Triangulation<3>::cell_iterator& cell, Boundary boundary) {
    return std::ranges::any_of(cell->face_indices(), [&](unsigned f) {
        return cell->face(f)->at_boundary() &&
               static_cast<int>(cell->face(f)->boundary_id()) == id_of(boundary);
    });
}

bool has(const meshes::HexMesh& mesh, Boundary boundary) {
    return std::ranges::any_of(mesh.faces,
                               [&](const auto& face) { return face.boundary == boundary; });
}

Nodes nodes_of(const Q2Space& space, std::size_t cell) {
    Nodes nodes{};
    for (int i = 0; i < 27; ++i) nodes[i] = space.nodes[space.cells[cell][i]];
    return nodes;
}

std::size_t nearest(const Nodes& nodes, const dealii::Point<3>& x) {
    const auto distance = [&](const std::array<double, 3>& node) {
        return x.distance_square({node[0], node[1], node[2]});
    };
    return std::ranges::min_element(nodes, {}, distance) - nodes.begin();
}

}  // namespace

HexMesh part_of(const HexMesh& mesh, std::span<const int> hexes) {
    HexMesh part;
    const std::vector<int> number = take_hexes(mesh, hexes, part);
    const meshes::FaceTable table(part);
    std::vector<Boundary> names(table.n_faces(), Boundary::free_top);
    for (const auto& face : mesh.faces) {
        std::array<int, 4> nodes{};
        for (int i = 0; i < 4; ++i) nodes[i] = number[face.nodes[i]];
        const std::size_t at = table.find(nodes);
        if (at < table.n_faces()) names[at] = face.boundary;
    }
    for (std::size_t f = 0; f < table.n_faces(); ++f) {
        if (table.sides(f).size() != 1) continue;
        const auto& side = table.sides(f)[0];
        auto& face = part.faces.emplace_back(HexMesh::Face{{}, names[f]});
        for (int i = 0; i < 4; ++i)
            face.nodes[i] = part.hexes[side.hex][meshes::hex_faces[side.face][i]];
    }
    return part;
}

struct Stiffness::Parts {
    Triangulation triangulation{all_ranks};
    dealii::FESystem<3> fe{dealii::FE_Q<3>(2), 3};
    dealii::MappingQ1<3> mapping;
    dealii::DoFHandler<3> dofs{triangulation};
    std::vector<int> own_hexes;
    dealii::IndexSet relevant;
    dealii::AffineConstraints<double> held;
    dealii::PETScWrappers::MPI::SparseMatrix matrix;
    std::array<dealii::PETScWrappers::MPI::Vector, 3> held_rows;
    ContactSurface surface;
    std::vector<int> contact_rows;

    Parts(const LayerProblem& problem, const Session& session) {
        session.agree([&] {
            refuse_rigid_motions(has(problem.mesh, Boundary::base),
                                 has(problem.mesh, Boundary::sides), problem.base, problem.sides);
        });
        deal_ii::triangulate(problem.mesh, triangulation);
        session.agree([&] { require_names(); });
        dofs.distribute_dofs(fe);
        for (const Cell& cell : dofs.active_cell_iterators())
            if (cell->is_locally_owned()) own_hexes.push_back(cell->index());
        std::ranges::sort(own_hexes);
        dealii::DoFTools::extract_locally_relevant_dofs(dofs, relevant);
        hold(problem);
        session.agree([&] { number_contact(problem.mesh); });
        MPI_Allreduce(MPI_IN_PLACE, contact_rows.data(), static_cast<int>(contact_rows.size()),
                      MPI_INT, MPI_MAX, all_ranks);
        reserve();
        assemble(problem);
    }

    void require_names() const {
        for (const auto& cell : triangulation.active_cell_iterators())
            for (const unsigned f : cell->face_indices())
                if (cell->is_locally_owned() && cell->face(f)->at_boundary()) {
                    const auto x = cell->face(f)->center();
                    deal_ii::require_name(cell->face(f)->boundary_id(), {x[0], x[1], x[2]});
                }
    }

    void hold(const LayerProblem& problem) {
        held.reinit(relevant);
        for (int b = 0; b < meshes::n_boundaries; ++b) {
            const auto boundary = static_cast<Boundary>(b);
            const Directions directions = held_on(boundary, problem.base, problem.sides);
            dealii::ComponentMask mask(3, false);
            for (unsigned c = 0; c < 3; ++c) mask.set(c, directions >> c & 1);
            if (directions)
                dealii::DoFTools::make_zero_boundary_constraints(dofs, id_of(boundary), held, mask);
        }
        held.close();
    }

    Cell cell_of(int hex) const { return {&triangulation, 0, hex, &dofs}; }

    // The numbers of the components of `nodes`, those of the cell in any order.
    Numbers numbers_of(const Cell& cell, const Nodes& nodes) const {
        std::vector<Number> indices(fe.n_dofs_per_cell());
        cell->get_dof_indices(indices);
        Numbers numbers{};
        for (unsigned i = 0; i < indices.size(); ++i) {
            const auto x = mapping.transform_unit_to_real_cell(cell, fe.unit_support_point(i));
            numbers[fe.system_to_component_index(i).first * 27 + nearest(nodes, x)] = indices[i];
        }
        return numbers;
    }

    // All hexahedra at the contact: known to every rank, being coarse ones. One at the plane of
    // symmetry comes with them, for the surface to know about it.
    std::vector<int> hexes_at_contact() const {
        std::vector<int> hexes;
        bool symmetric = false;
        for (const auto& cell : triangulation.cell_iterators_on_level(0)) {
            const bool first_symmetric = !symmetric && touches(cell, Boundary::symmetry);
            symmetric = symmetric || first_symmetric;
            if (first_symmetric || touches(cell, Boundary::contact)) hexes.push_back(cell->index());
        }
        return hexes;
    }

    // Own rows only; -1 elsewhere.
    void number_contact(const meshes::HexMesh& mesh) {
        const std::vector<int> hexes = hexes_at_contact();
        const Q2Space strip(part_of(mesh, hexes));
        surface = contact_surface(strip);
        std::map<int, std::size_t> point_of_node;
        for (std::size_t i = 0; i < surface.nodes.size(); ++i) point_of_node[surface.nodes[i]] = i;
        contact_rows.assign(3 * surface.nodes.size(), -1);
        for (std::size_t k = 0; k < hexes.size(); ++k) {
            const Cell cell = cell_of(hexes[k]);
            if (!cell->is_locally_owned()) continue;
            const Numbers numbers = numbers_of(cell, nodes_of(strip, k));
            for (int i = 0; i < 81; ++i) {
                const auto point = point_of_node.find(strip.cells[k][i % 27]);
                if (point != point_of_node.end() && !held.is_constrained(numbers[i]))
                    contact_rows[i / 27 * surface.nodes.size() + point->second] =
                        static_cast<int>(numbers[i]);
            }
        }
    }

    void reserve() {
        dealii::DynamicSparsityPattern pattern(relevant);
        dealii::DoFTools::make_sparsity_pattern(dofs, pattern, held, false);
        const dealii::IndexSet& owned = dofs.locally_owned_dofs();
        dealii::SparsityTools::distribute_sparsity_pattern(pattern, owned, all_ranks, relevant);
        matrix.reinit(owned, owned, pattern, all_ranks);
        for (auto& row : held_rows) row.reinit(owned, all_ranks);
    }

    void assemble(const LayerProblem& problem) {
        if (!own_hexes.empty()) add_own_elements(problem);
        matrix.compress(dealii::VectorOperation::add);
        for (auto& row : held_rows) row.compress(dealii::VectorOperation::add);
    }

    void add_own_elements(const LayerProblem& problem) {
        const Q2Space space(part_of(problem.mesh, own_hexes));
        ElementValues values(space, 3);
        auto k = std::make_unique<ElementStiffness>();
        dealii::FullMatrix<double> local(81, 81);
        for (std::size_t c = 0; c < own_hexes.size(); ++c) {
            values.reinit(c);
            const auto& material = problem.materials[static_cast<int>(space.regions[c])];
            element_stiffness(values, moduli_of(material, problem.largest_bulk_ratio), *k);
            for (int i = 0; i < 81; ++i)
                for (int j = 0; j < 81; ++j) local(i, j) = (*k)[i][j];
            const Numbers numbers = numbers_of(cell_of(own_hexes[c]), nodes_of(space, c));
            held.distribute_local_to_global(local, std::vector(numbers.begin(), numbers.end()),
                                            matrix);
            add_held_rows(*k, numbers);
        }
    }

    void add_held_rows(const ElementStiffness& k, const Numbers& numbers) {
        for (int i = 0; i < 81; ++i) {
            if (!held.is_constrained(numbers[i])) continue;
            for (int j = 0; j < 81; ++j)
                if (!held.is_constrained(numbers[j])) held_rows[i / 27](numbers[j]) += k[i][j];
        }
    }
};

Stiffness::Stiffness(const LayerProblem& problem, const Session& session)
    : parts_(std::make_unique<Parts>(problem, session)) {
    auto& parts = *parts_;
    matrix = parts.matrix;
    for (int d = 0; d < 3; ++d) held_rows[d] = parts.held_rows[d];
    surface = std::move(parts.surface);
    contact_rows = std::move(parts.contact_rows);
    for (const auto i : parts.dofs.locally_owned_dofs())
        n_unknowns += !parts.held.is_constrained(i);
    MPI_Allreduce(MPI_IN_PLACE, &n_unknowns, 1, MPI_INT64_T, MPI_SUM, all_ranks);
}
Stiffness::~Stiffness() = default;

std::vector<std::array<double, 3>> Stiffness::owned_nodes() const {
    std::map<Number, dealii::Point<3>> points;
    dealii::DoFTools::map_dofs_to_support_points(parts_->mapping, parts_->dofs, points);
    std::vector<std::array<double, 3>> nodes;
    const dealii::IndexSet& owned = parts_->dofs.locally_owned_dofs();
    for (std::size_t i = 0; i < owned.n_elements(); i += 3) {
        const auto& x = points.at(owned.nth_index_in_set(i));
        nodes.push_back({x[0], x[1], x[2]});
    }
    return nodes;
}

}  // namespace tricontact::fem::distributed
