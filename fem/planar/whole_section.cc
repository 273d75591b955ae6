#include "fem/planar/whole_section.h"

#include <cmath>
#include <numbers>
#include <numeric>

// Nodes of a section repeat in layers along y, or around the axis; a hexahedron of 27 nodes stands
// on three of them. Its own third axis is x cross z = -y: layers follow each other that way.

namespace tricontact::fem::planar {

namespace {

using contact::Interior;

constexpr int n_sectors = 12;  // of a body of revolution: biquadratic arcs of 30 degrees, 3e-5

/// Per node: the means of its elements' stresses; per element its density of energy.
struct State {
    std::vector<std::array<double, 4>> stress;
    std::vector<double> energy_density;
    double energy = 0;
};

State state_of(const BodyProblem& problem, const std::vector<Point>& displacement) {
    const Moduli moduli = moduli_of(problem.material, problem.largest_bulk_ratio);
    State state;
    state.stress.assign(problem.mesh.nodes.size(), {});
    std::vector<int> uses(problem.mesh.nodes.size(), 0);
    for (const auto& cell : problem.mesh.cells) {
        ElementNodes nodes;
        std::array<double, n_element_unknowns> u{};
        for (std::size_t i = 0; i < 9; ++i) {
            nodes[i] = problem.mesh.nodes[cell[i]];
            for (std::size_t a = 0; a < 2; ++a) u[a * 9 + i] = displacement[cell[i]][a];
        }
        const ElementState element = element_state(nodes, problem.solid, moduli, u);
        state.energy += element.energy;
        state.energy_density.push_back(element.energy / element.volume);
        for (std::size_t i = 0; i < 9; ++i) {
            ++uses[cell[i]];
            for (std::size_t k = 0; k < 4; ++k) state.stress[cell[i]][k] += element.stress[i][k];
        }
    }
    for (std::size_t node = 0; node < uses.size(); ++node)
        for (double& component : state.stress[node]) component /= uses[node];
    return state;
}

/// A layer of nodes: at y [m], or turned by the angle.
struct Layer {
    double y, cosine, sine;
};

std::vector<Layer> layers_of(Solid solid, double length) {
    if (solid == Solid::plane_strain) return {{length / 2, 1, 0}, {0, 1, 0}, {-length / 2, 1, 0}};
    std::vector<Layer> layers;
    for (int k = 0; k < 2 * n_sectors; ++k) {
        const double angle = -k * std::numbers::pi / n_sectors;
        layers.push_back({0, std::cos(angle), std::sin(angle)});
    }
    return layers;
}

/// The hexahedron on a cell between the layers that begin with these numbers of nodes, in VTK's
/// order: corners, edges below, above and between, faces, centre.
std::array<int, 27> hex_on(const std::array<int, 9>& cell, const std::array<int, 3>& first) {
    std::array<int, 27> hex{};
    for (int i = 0; i < 4; ++i) {
        hex[i] = first[0] + cell[i];
        hex[4 + i] = first[2] + cell[i];
        hex[8 + i] = first[0] + cell[4 + i];
        hex[12 + i] = first[2] + cell[4 + i];
        hex[16 + i] = first[1] + cell[i];
    }
    constexpr std::array<int, 4> sides{7, 5, 4, 6};
    for (int i = 0; i < 4; ++i) hex[20 + i] = first[1] + cell[sides[i]];
    for (int i = 0; i < 2; ++i) hex[24 + i] = first[2 * i] + cell[8];
    hex[26] = first[1] + cell[8];
    return hex;
}

void add_layer(const Layer& layer, const Mesh& mesh, const std::vector<Point>& displacement,
               const State& state, double sign, Interior& solid) {
    const auto [y, c, s] = layer;
    for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
        const auto [x, z] = mesh.nodes[i];
        const auto [u, w] = displacement[i];
        const auto [xx, zz, across, xz] = state.stress[i];
        solid.points.push_back({x * c, y + x * s, z});
        solid.displacement.push_back({sign * u * c, sign * u * s, sign * w});
        solid.stress.push_back({sign * (xx * c * c + across * s * s),
                                sign * (xx * s * s + across * c * c), sign * zz,
                                sign * (xx - across) * s * c, sign * xz * s, sign * xz * c});
    }
}

}  // namespace

WholeSection::WholeSection(BodyProblem problem, SectionSurface surface, SectionUnknowns unknowns,
                           Condensation condensation, std::vector<double> even_load)
    : problem_(std::move(problem)),
      surface_(std::move(surface)),
      unknowns_(std::move(unknowns)),
      condensation_(std::move(condensation)),
      even_load_(std::move(even_load)) {}

std::vector<Point> WholeSection::displacement(std::span<const double> forces) const {
    const std::size_t n = surface_.nodes.size();
    std::vector<double> load(unknowns_.node_of_unknown.size(), 0);
    double along_z = 0;
    for (std::size_t i = 0; i < n; ++i) {
        const auto frame = frame_at(problem_, surface_.along[i]);
        for (std::size_t a = 0; a < 2; ++a) {
            const double force = frame[0][a] * forces[i] + frame[1][a] * forces[n + i];
            if (a == 1) along_z += force;
            if (const int k = unknowns_.of_node[surface_.nodes[i]][a]; k >= 0) load[k] += force;
        }
    }
    for (std::size_t k = 0; k < even_load_.size(); ++k) load[k] -= along_z * even_load_[k];
    const std::vector<double> solved = condensation_.solve(load);
    const double mean =
        std::inner_product(even_load_.begin(), even_load_.end(), solved.begin(), 0.);
    std::vector<Point> u(problem_.mesh.nodes.size(), Point{});
    for (std::size_t node = 0; node < u.size(); ++node)
        for (std::size_t a = 0; a < 2; ++a) {
            if (const int k = unknowns_.of_node[node][a]; k >= 0) u[node][a] = solved[k];
            if (a == 1) u[node][a] -= mean;
        }
    return u;
}

Interior WholeSection::interior(std::span<const double> forces, double sign, double length,
                                double copies) const {
    const std::vector<Point> u = displacement(forces);
    const State state = state_of(problem_, u);
    const bool line = problem_.solid == Solid::plane_strain;
    const std::vector<Layer> layers = layers_of(problem_.solid, length);
    Interior solid;
    for (const Layer& layer : layers) add_layer(layer, problem_.mesh, u, state, sign, solid);
    const auto n_layers = static_cast<int>(layers.size());
    const auto n_nodes = static_cast<int>(u.size());
    for (int k = 0; k + 2 <= n_layers; k += 2)
        for (std::size_t c = 0; c < problem_.mesh.cells.size(); ++c) {
            solid.hexes.push_back(hex_on(problem_.mesh.cells[c], {k * n_nodes, (k + 1) * n_nodes,
                                                                  (k + 2) % n_layers * n_nodes}));
            solid.region.push_back(0);
            solid.energy_density.push_back(state.energy_density[c]);
        }
    solid.strain_energy = (line ? copies * length : 1) * state.energy;
    return solid;
}

}  // namespace tricontact::fem::planar
