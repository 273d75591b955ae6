#include "fem/condensed_layer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <new>

#include "fem/condensation.h"
#include "fem/discretisation.h"

namespace tricontact::fem {

namespace {

// The ground's reaction to a unit force on a component is minus the displacement there when all
// held components are moved by one (reciprocity): 1 in the direction moved, 0 in the others.
std::array<std::vector<double>, 3> missing_reaction(
    const Discretisation& discretisation, const Condensation& condensation,
    const std::array<std::vector<double>, 3>& held_rows) {
    const std::size_t n = discretisation.unknowns.n;
    const auto& unknowns = discretisation.unknowns.of_contact;
    std::vector<double> forces;
    for (const auto& row : held_rows)
        for (const double k : row) forces.push_back(-k);
    const auto moved = condensation.solve(forces);
    std::array<std::vector<double>, 3> missing;
    for (std::size_t direction = 0; direction < 3; ++direction) {
        missing[direction].assign(unknowns.size(), 0);
        for (std::size_t c = 0; c < unknowns.size(); ++c) {
            if (unknowns[c] < 0) continue;
            const int u = discretisation.unknowns.n_interior + unknowns[c];
            const double force = c / (unknowns.size() / 3) == direction ? 1 : 0;
            missing[direction][c] = force - moved[direction * n + u];
        }
    }
    return missing;
}

// Moves the leading square of the free unknowns to the places of all components; others are zero.
void spread(const std::vector<int>& unknown, std::vector<double>& compliance) {
    const std::size_t n = unknown.size();
    for (std::size_t c = n; c-- > 0;)
        for (std::size_t r = n; r-- > 0;) {
            const bool held = unknown[c] < 0 || unknown[r] < 0;
            compliance[c * n + r] = held ? 0 : compliance[unknown[c] * n + unknown[r]];
        }
}

[[noreturn]] void refuse(const std::string& what, double needed, double available) {
    throw MemoryShort(
        fmt::format("condensing the layer needs {}, {:.1f} GB are there; choose a larger "
                    "fem.size or a machine with more memory",
                    what, available / 1e9),
        needed, available);
}

void refuse_too_large(double needed) {
    const double available = available_bytes();
    if (needed > available)
        refuse(fmt::format("{:.1f} GB of memory", needed / 1e9), needed, available);
}

Condensation analyse(const Discretisation& discretisation, AssembledStiffness& stiffness) {
    return {std::move(stiffness.matrix), discretisation.unknowns.node_of_unknown,
            discretisation.unknowns.n_interior};
}

CondensedLayer condense_discretised(const Discretisation& discretisation) {
    auto stiffness = discretisation.assemble();
    Condensation condensation = analyse(discretisation, stiffness);
    const auto& unknowns = discretisation.unknowns.of_contact;
    const int n_components = static_cast<int>(unknowns.size());
    refuse_too_large(condensation.predicted_bytes(n_components) + blas_buffer_bytes());
    condensation.factorise();
    CondensedLayer layer;
    layer.points = discretisation.surface.points;
    layer.contact_mass = discretisation.surface.mass;
    layer.missing_reaction = missing_reaction(discretisation, condensation, stiffness.held_rows);
    layer.compliance = condensation.compliance(n_components);
    spread(unknowns, layer.compliance);
    return layer;
}

using contact::ContactPoints;

/// Share of each of the slice's points in the area of the line's point at the same x.
std::vector<double> shares(const ContactPoints& slice, const ContactPoints& line) {
    std::vector<double> share(slice.size());
    for (std::size_t k = 0; k < share.size(); ++k)
        share[k] = slice.area[k] / line.area[k % line.size()];
    return share;
}

ContactPoints line_points(const ContactPoints& slice) {
    const double length = 2 * *std::ranges::max_element(slice.y);
    ContactPoints line =
        ContactPoints::grid(slice.n_x, 1, {slice.first[0], 0}, {slice.spacing[0], length});
    std::ranges::copy_n(slice.x.begin(), slice.n_x, line.x.begin());
    std::ranges::fill(line.area, 0);
    for (std::size_t k = 0; k < slice.size(); ++k) line.area[k % line.size()] += slice.area[k];
    line.mirrored = true;
    return line;
}

}  // namespace

double CondensedLayer::reaction_error() const {
    double worst = 0;
    for (const auto& direction : missing_reaction)
        for (const double missing : direction) worst = std::max(worst, std::abs(missing));
    return worst;
}

CondensedLayer condense(const LayerProblem& problem) {
    const double available = available_bytes();
    try {
        return condense_discretised(Discretisation(problem));
    } catch (const std::bad_alloc&) {  // not even the matrix fitted, or others took the memory
        refuse("more memory", 0, available);
    }
}

double predicted_bytes(const LayerProblem& problem) {
    const Discretisation discretisation(problem);
    auto stiffness = discretisation.assemble();
    const Condensation condensation = analyse(discretisation, stiffness);
    return condensation.matrix_bytes() + condensation.predicted_bytes(static_cast<int>(
                                             discretisation.unknowns.of_contact.size()));
}

CondensedLayer contact_line(const CondensedLayer& slice) {
    CondensedLayer line;
    line.points = line_points(slice.points);
    const std::size_t n = slice.points.size(), m = line.points.size();
    const std::vector<double> share = shares(slice.points, line.points);
    line.compliance.assign(9 * m * m, 0);
    for (auto& missing : line.missing_reaction) missing.assign(3 * m, 0);
    for (const std::size_t c : {0, 2})
        for (std::size_t k = 0; k < n; ++k) {
            const std::size_t column = c * m + k % m;
            for (std::size_t d = 0; d < 3; ++d)
                line.missing_reaction[d][column] += share[k] * slice.missing_reaction[d][c * n + k];
            for (const std::size_t r : {0, 2})
                for (std::size_t l = 0; l < n; ++l)
                    line.compliance[column * 3 * m + r * m + l % m] +=
                        share[k] * share[l] * slice.compliance[(c * n + k) * 3 * n + r * n + l];
        }
    return line;
}

}  // namespace tricontact::fem
