#include "fem/pair_compliance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "contact/compliances/interior_parts.h"
#include "contact/substrates/material.h"

// A = C_substrate + C_indenter on the nodes that both have (contact_frame.h has the signs). Forces
// of nodes are the same on both, so that action is reaction exactly; a node of the indenter stands
// over its node of the substrate along the substrate's normal.

namespace tricontact::fem {

using contact::ContactPoints;
using contact::TangentialField;

namespace {

void require_same_nodes(const ContactPoints& a, const ContactPoints& b) {
    const double extent = *std::ranges::max_element(a.x) - *std::ranges::min_element(a.x);
    const auto equal = [&](double u, double v) { return std::abs(u - v) <= 1e-9 * extent; };
    if (a.mirrored != b.mirrored || !std::ranges::equal(a.x, b.x, equal) ||
        !std::ranges::equal(a.y, b.y, equal))
        throw std::logic_error("PairCompliance: the patches of both bodies do not match");
}

void add(const std::vector<double>& to_add, std::vector<double>& sum) {
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += to_add[i];
}

contact::Material material_of(const CondensedPart& part) {
    return part.problem->materials.front();
}

/// E*/G* of both bodies, `other` empty: rigid.
double elastic_ratio(const std::optional<contact::Material>& other, const CondensedPart& part) {
    if (part.problem->line_length > 0) return 1;
    const contact::MaterialPair pair(other, material_of(part));
    return pair.effective_modulus() / pair.effective_shear_modulus();
}

TangentialField reversed(const TangentialField& t) {
    TangentialField opposite = t;
    for (double& x : opposite.x) x = -x;
    for (double& y : opposite.y) y = -y;
    return opposite;
}

// Mirrored in the plane z = 0: vertical components change their sign, and the order of nodes with
// them.
void turn_over(contact::Interior& body) {
    // VTK's 27 nodes with bottom and top exchanged.
    constexpr std::array<int, 27> exchanged{4,  5,  6,  7,  0,  1,  2,  3,  12, 13, 14, 15, 8, 9,
                                            10, 11, 16, 17, 18, 19, 20, 21, 22, 23, 25, 24, 26};
    for (auto& x : body.points) x[2] = -x[2];
    for (auto& u : body.displacement) u[2] = -u[2];
    for (auto& s : body.stress) {  // XX YY ZZ XY YZ XZ
        s[4] = -s[4];
        s[5] = -s[5];
    }
    for (auto& hex : body.hexes) {
        const auto before = hex;
        for (std::size_t i = 0; i < hex.size(); ++i) hex[i] = before[exchanged[i]];
    }
    body.applied[2] = -body.applied[2];
    if (body.base_reaction) (*body.base_reaction)[2] *= -1;
}

}  // namespace

struct PairCompliance::Parts {
    ContactSide side;
    std::optional<CondensedBody> substrate;
    CondensedBody indenter;
    SparseMatrix mass;

    static Parts on_layer(CondensedPart substrate, CondensedPart indenter,
                          const contact::Interface& interface, bool by_element_means) {
        require_same_nodes(substrate.layer.points, indenter.layer.points);
        std::vector<double> sum = in_contact_frame(substrate.layer, Side::substrate);
        add(in_contact_frame(indenter.layer, Side::indenter), sum);
        const double ratio = elastic_ratio(material_of(substrate), indenter);
        return {joined(substrate.layer.points, std::move(sum), indenter.problem->line_length, ratio,
                       interface, by_element_means),
                CondensedBody(substrate.problem, std::move(substrate.layer.missing_reaction), 0,
                              std::move(substrate.transfer)),
                CondensedBody(indenter.problem, std::move(indenter.layer.missing_reaction),
                              indenter.round_radius, std::move(indenter.transfer)),
                std::move(substrate.layer.contact_mass)};
    }
    static Parts on_plane(ContactSurface plane, CondensedPart indenter,
                          const contact::Interface& interface, bool by_element_means) {
        require_same_nodes(plane.points, indenter.layer.points);
        return {joined(std::move(plane.points), in_contact_frame(indenter.layer, Side::indenter),
                       indenter.problem->line_length, elastic_ratio({}, indenter), interface,
                       by_element_means),
                {},
                CondensedBody(indenter.problem, std::move(indenter.layer.missing_reaction),
                              indenter.round_radius, std::move(indenter.transfer)),
                std::move(plane.mass)};
    }
};

ContactSurface plane_patch(const meshes::LayerMeshSpec& spec) {
    meshes::LayerMeshSpec slab = spec;
    slab.half_x = spec.patch_x;
    slab.half_y = spec.patch_y;
    slab.thickness = spec.size;
    slab.lower_thickness = 0;
    return contact_surface(Q2Space(make_layer_mesh(slab)));
}

PairCompliance::PairCompliance(CondensedPart substrate, CondensedPart indenter,
                               const contact::Interface& interface, bool by_element_means)
    : PairCompliance(Parts::on_layer(std::move(substrate), std::move(indenter), interface,
                                     by_element_means)) {}

PairCompliance::PairCompliance(ContactSurface plane, CondensedPart indenter,
                               const contact::Interface& interface, bool by_element_means)
    : PairCompliance(
          Parts::on_plane(std::move(plane), std::move(indenter), interface, by_element_means)) {}

PairCompliance::PairCompliance(Parts parts)
    : DenseCompliance(std::move(parts.side.points), std::move(parts.side.compliance)),
      substrate_(std::move(parts.substrate)),
      indenter_(std::move(parts.indenter)),
      mass_(std::move(parts.mass)) {}

PairCompliance::~PairCompliance() = default;

// The z of each body points out of it, the indenter's into the substrate.
std::optional<std::array<double, 3>> PairCompliance::missing_reaction(
    std::span<const double> p, const TangentialField& t) const {
    std::array<double, 3> worst = indenter_.missing_reaction(points(), p, reversed(t));
    worst[2] = -worst[2];
    if (!substrate_) return worst;
    const auto other = substrate_->missing_reaction(points(), p, t);
    for (std::size_t d = 0; d < 3; ++d)
        if (std::abs(other[d]) > std::abs(worst[d])) worst[d] = other[d];
    return worst;
}

double PairCompliance::allowed_missing_reaction() const {
    const double allowed = indenter_.allowed_missing_reaction(points());
    return substrate_ ? std::max(allowed, substrate_->allowed_missing_reaction(points())) : allowed;
}

std::unique_ptr<const contact::Interior> PairCompliance::interior(std::span<const double> p,
                                                                  const TangentialField& t) const {
    contact::Interior above = contact::as_indenter(indenter_interior(p, t));
    if (!substrate_) return std::make_unique<contact::Interior>(std::move(above));
    return std::make_unique<contact::Interior>(
        contact::joined_bodies(substrate_->interior(points(), p, t), above));
}

contact::Interior PairCompliance::indenter_interior(std::span<const double> p,
                                                    const TangentialField& t) const {
    contact::Interior body = indenter_.interior(points(), p, reversed(t));
    turn_over(body);
    return body;
}

}  // namespace tricontact::fem
