#include "fem/condensed_layer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <new>
#include <numeric>
#include <span>

#include "fem/body_parts.h"
#include "fem/discretisation.h"

// From parts to the compliance of the patch (docs/explanation/models/fem.md, "Condensation"): parts
// are condensed one after the other, so that one factor exists at a time, and added up with the
// signs of their displacements.
//
// Missing reaction: the ground's force under a unit force on the patch has to be its opposite. By
// reciprocity it is minus the displacement of the patch when the ground moves by one, one solution
// per direction instead of one per contact component. What is left is rounding, which K/G
// multiplies.

namespace tricontact::fem {

namespace {

using ByDirection = std::array<std::vector<double>, 3>;

// A component of the contact that moves with a part.
struct PartComponent {
    std::size_t component;
    int unknown;        // of the part
    std::size_t place;  // in its compliance
    double sign;
};

std::vector<PartComponent> components_of(const BodyPart& part, const Unknowns& body) {
    const auto contact = part.condensation.contact();
    std::vector<std::size_t> place(part.condensation.n());
    for (std::size_t k = 0; k < contact.size(); ++k) place[contact[k]] = k;
    std::vector<PartComponent> components;
    for (std::size_t c = 0; c < body.of_contact.size(); ++c) {
        if (body.of_contact[c] < 0) continue;
        const int u = body.n_interior + body.of_contact[c], own = part.unknown[u];
        if (own >= 0) components.push_back({c, own, place[own], static_cast<double>(part.sign[u])});
    }
    return components;
}

// By direction, 1 on each free component in that direction.
ByDirection unit_forces(const std::vector<int>& unknown_of_component) {
    const std::size_t n = unknown_of_component.size();
    ByDirection forces;
    for (auto& force : forces) force.assign(n, 0);
    for (std::size_t c = 0; c < n; ++c)
        if (unknown_of_component[c] >= 0) forces[c / (n / 3)][c] = 1;
    return forces;
}

// The ground's reaction to a unit force on a component is minus the displacement there when all
// held components are moved by one (reciprocity): 1 in the direction moved, 0 in the others.
void subtract_motion(const ByDirection& held_rows, const Condensation& condensation,
                     const std::vector<PartComponent>& components, ByDirection& missing) {
    std::vector<double> forces;
    for (const auto& row : held_rows)
        for (const double k : row) forces.push_back(-k);
    const auto moved = condensation.solve(forces);
    const double* of_direction = moved.data();
    for (std::size_t direction = 0; direction < 3; ++direction) {
        if (held_rows[direction].empty()) continue;
        for (const PartComponent& c : components)
            missing[direction][c.component] -= c.sign * of_direction[c.unknown];
        of_direction += condensation.n();
    }
}

// A pressure on the base, and what it displaces.
struct EvenPress {
    std::span<const double> load;  // empty: there is none
    std::vector<double> moved;
};

// The compliance of the part's contact unknowns; its factor is gone afterwards.
std::vector<double> eliminate(BodyPart& part, const std::vector<PartComponent>& components,
                              ByDirection& missing, EvenPress& even) {
    part.condensation.factorise();
    subtract_motion(part.held_rows, part.condensation, components, missing);
    if (!even.load.empty()) part.add_displacement(even.load, even.moved);
    const Condensation condensation = std::move(part.condensation);
    return condensation.compliance();
}

// The forces f on the contact press against the load -b (e'f), b of the resultant one and e the
// displacement by one along z, so that the node that is held carries no more than its part of b.
// Displacements count from the mean b'u. With w = K^-1 b, then C - w e' - e w' + (b'w) e e'.
void press_evenly(const EvenPress& even, const Unknowns& unknowns,
                  std::vector<double>& compliance) {
    const std::size_t n = unknowns.of_contact.size();
    const double mean =
        std::inner_product(even.load.begin(), even.load.end(), even.moved.begin(), 0.);
    std::vector<double> moved(n, 0), rigid(n, 0);
    for (std::size_t c = 0; c < n; ++c) {
        if (unknowns.of_contact[c] < 0) continue;
        moved[c] = even.moved[unknowns.n_interior + unknowns.of_contact[c]];
        rigid[c] = c / (n / 3) == 2 ? 1 : 0;
    }
    for (std::size_t c = 0; c < n; ++c)
        for (std::size_t r = 0; r < n; ++r)
            compliance[c * n + r] +=
                mean * rigid[r] * rigid[c] - moved[r] * rigid[c] - rigid[r] * moved[c];
}

// To the compliance between all `n` components, that of a part's `n_contact` unknowns.
void add_compliance(const std::vector<double>& of_part, std::size_t n_contact, double share,
                    const std::vector<PartComponent>& components, std::size_t n,
                    std::vector<double>& to) {
    if (to.empty()) to = large_field(n * n);
    for (const PartComponent& c : components) {
        const double* const from = of_part.data() + c.place * n_contact;
        double* const column = to.data() + c.component * n;
        for (const PartComponent& r : components)
            column[r.component] += share * c.sign * r.sign * from[r.place];
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

// Memory is asked for before hours are spent: the symbolic factor says how large the numeric one
// and the dense compliance will be. At the peak there are one factor and what earlier parts have
// left.
// Peak of what `condense_parts` will take on top of now.
double peak_bytes(const std::vector<BodyPart>& parts, std::size_t n_components) {
    const double compliance = 8. * static_cast<double>(n_components * n_components);
    double most = 0, kept = 0;
    for (const BodyPart& part : parts) {
        const double of_part = 8. * std::pow(part.condensation.contact().size(), 2);
        most = std::max({most, kept + part.condensation.predicted_bytes(), compliance + of_part});
        kept = compliance;
    }
    return most;
}

// One after another, so that but one factor exists at a time. The layer's missing reaction is what
// the forces are that they have to carry.
void condense_parts(std::vector<BodyPart> parts, const Discretisation& body,
                    CondensedLayer& layer) {
    const Unknowns& unknowns = body.unknowns;
    const std::size_t n = unknowns.of_contact.size();
    EvenPress even{body.even_load, std::vector<double>(body.even_load.size(), 0.)};
    for (BodyPart& part : parts) {
        const auto components = components_of(part, unknowns);
        const std::size_t n_contact = part.condensation.contact().size();
        const auto compliance = eliminate(part, components, layer.missing_reaction, even);
        add_compliance(compliance, n_contact, part.share, components, n, layer.compliance);
    }
    if (!even.load.empty()) press_evenly(even, unknowns, layer.compliance);
}

CondensedLayer condense_discretised(std::vector<BodyPart> parts, const Discretisation& body,
                                    ByDirection forces) {
    CondensedLayer layer;
    layer.missing_reaction = std::move(forces);
    layer.points = body.surface.points;
    layer.contact_mass = body.surface.mass;
    condense_parts(std::move(parts), body, layer);
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
    const FreedMemoryStays stays;
    try {
        const Discretisation body(problem);
        std::vector<BodyPart> parts = parts_of(body, Elimination::contact_last);
        refuse_too_large(peak_bytes(parts, body.unknowns.of_contact.size()) + blas_buffer_bytes());
        return condense_discretised(std::move(parts), body, unit_forces(body.unknowns.of_contact));
    } catch (const std::bad_alloc&) {  // not even the matrix fitted, or others took the memory
        refuse("more memory", 0, available);
    }
}

struct HalfCondensation::Parts {
    Parts(const LayerProblem& problem, int which)
        : half(which), body(problem), parts(parts_of(body, Elimination::contact_last, half)) {}

    const FreedMemoryStays stays;
    int half;
    Discretisation body;
    std::vector<BodyPart> parts;
};

HalfCondensation::HalfCondensation(const LayerProblem& problem, int half)
    : parts_(std::make_unique<Parts>(problem, half)) {}
HalfCondensation::~HalfCondensation() = default;

bool HalfCondensation::exists() const {
    return !parts_->parts.empty();
}
double HalfCondensation::predicted_bytes() const {
    return peak_bytes(parts_->parts, parts_->body.unknowns.of_contact.size()) + blas_buffer_bytes();
}
CondensedLayer HalfCondensation::condense() {
    ByDirection forces = unit_forces(parts_->body.unknowns.of_contact);
    if (parts_->half == 1)  // they count once
        for (auto& force : forces) std::ranges::fill(force, 0.);
    return condense_discretised(std::move(parts_->parts), parts_->body, std::move(forces));
}

double predicted_bytes(const LayerProblem& problem) {
    const Discretisation discretisation(problem);
    const std::vector<BodyPart> parts = parts_of(discretisation, Elimination::contact_last);
    double bytes = peak_bytes(parts, discretisation.unknowns.of_contact.size());
    for (const BodyPart& part : parts) bytes += part.condensation.matrix_bytes();
    return bytes;
}

// Means over y of a slice in plane strain: a traction uniform along y gives each node its share of
// the row's area, and the displacement of the row is the mean with the same shares. Rows and
// columns are weighted alike, so that the compliance stays symmetric.
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
