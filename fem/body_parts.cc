#include "fem/body_parts.h"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <stdexcept>

#include "fem/dissection_order.h"
#include "fem/memory.h"
#include "fem/mirror_symmetry.h"

// u = P a with a on the half x >= middle; -: the component changes its sign in the other half:
//
//               u_x    u_y    u_z       on the plane x = middle
//   even         -      +      +        u_x = 0
//   odd          +      -      -        u_y = u_z = 0
//
// Both parts are stiffnesses of the same half, K_half a = share P' f with share = 1/2, because f
// acts on both sides. Displacements of the body are the sum of both parts.

namespace tricontact::fem {

namespace {

// Interior unknowns are eliminated first; if the contact's are not to be the last, all are
// interior.
int n_interior(const Unknowns& unknowns, Elimination elimination) {
    return elimination == Elimination::contact_last ? unknowns.n_interior : unknowns.n;
}

BodyPart whole(const Discretisation& body, Elimination elimination) {
    auto [matrix, held_rows] = body.assemble();
    const Unknowns& unknowns = body.unknowns;
    std::vector<int> own(unknowns.n);
    std::iota(own.begin(), own.end(), 0);
    return {.unknown = std::move(own),
            .sign = std::vector<std::int8_t>(unknowns.n, 1),
            .held_rows = std::move(held_rows),
            .condensation = {matrix, unknowns.node_of_unknown, n_interior(unknowns, elimination)}};
}

// The unknowns of the half, those on the plane included, in the body's order.
Unknowns half_of(const Unknowns& body, const MirrorSymmetry& mirror) {
    Unknowns half;
    half.of_node.assign(body.of_node.size(), {-1, -1, -1});
    for (int u = 0; u < body.n; ++u) {
        const int node = body.node_of_unknown[u], direction = body.direction_of_unknown[u];
        if (mirror.side[node] < 0) continue;
        half.of_node[node][direction] = half.n++;
        half.node_of_unknown.push_back(node);
        half.direction_of_unknown.push_back(direction);
        if (u < body.n_interior) half.n_interior = half.n;
    }
    return half;
}

using Signs = std::array<bool, 3>;  // which displacements change it from one side to the other

// Both parts share one assembled stiffness of the half and one order of elimination; they differ in
// the unknowns held on the plane, which leave the order.
// A body of two halves: the stiffness of one serves both parts, which hold other displacements on
// the plane.
class Halves {
  public:
    Halves(const Discretisation& body, const MirrorSymmetry& mirror, Elimination elimination)
        : body_(body.unknowns),
          held_if_odd_(body.held_if_odd),
          mirror_(mirror),
          half_(half_of(body.unknowns, mirror)),
          n_interior_(n_interior(half_, elimination)),
          stiffness_(body.assemble(half_, mirror.half)),
          order_(dissection_order(stiffness_.matrix, half_.node_of_unknown, n_interior_)) {}

    BodyPart part(const Signs& changes) const {
        const auto is_held = [&](std::int64_t h) {
            const int node = half_.node_of_unknown[h], direction = half_.direction_of_unknown[h];
            const bool is_odd = !changes[0];
            if (is_odd && !held_if_odd_.empty() && held_if_odd_[node] >> direction & 1) return true;
            return mirror_.side[node] == 0 && changes[direction];
        };
        std::vector<std::int64_t> order;
        std::ranges::remove_copy_if(order_, std::back_inserter(order), is_held);
        const auto n_held = std::count_if(order_.begin(), order_.begin() + n_interior_, is_held);
        BodyPart part{.unknown = {},
                      .sign = {},
                      .share = .5,
                      .held_rows = {},
                      .condensation = {stiffness_.matrix, std::move(order),
                                       n_interior_ - static_cast<int>(n_held)}};
        // A motion of all that is held is even or odd itself: along x it is odd.
        for (int direction = 0; direction < 3; ++direction)
            if (!changes[direction]) part.held_rows[direction] = stiffness_.held_rows[direction];
        for (int u = 0; u < body_.n; ++u) {
            const int node = body_.node_of_unknown[u], direction = body_.direction_of_unknown[u];
            const bool is_image = mirror_.side[node] < 0;
            const int h = half_.of_node[is_image ? mirror_.image[node] : node][direction];
            part.unknown.push_back(is_held(h) ? -1 : h);
            part.sign.push_back(is_image && changes[direction] ? -1 : 1);
        }
        return part;
    }

  private:
    const Unknowns& body_;
    const std::vector<Directions>& held_if_odd_;
    const MirrorSymmetry& mirror_;
    Unknowns half_;
    int n_interior_;
    AssembledStiffness stiffness_;
    std::vector<std::int64_t> order_;
};

}  // namespace

void BodyPart::add_displacement(std::span<const double> forces, std::vector<double>& to) const {
    std::vector<double> own(condensation.n(), 0.);
    for (std::size_t u = 0; u < unknown.size(); ++u)
        if (unknown[u] >= 0) own[unknown[u]] += share * sign[u] * forces[u];
    const std::vector<double> displacement = condensation.solve(own);
    for (std::size_t u = 0; u < unknown.size(); ++u)
        if (unknown[u] >= 0) to[u] += sign[u] * displacement[unknown[u]];
}

std::vector<BodyPart> parts_of(const Discretisation& body, Elimination elimination,
                               std::optional<int> half) {
    std::vector<BodyPart> parts;
    if (const std::optional<MirrorSymmetry> mirror = mirror_symmetry(body.space)) {
        const Halves halves(body, *mirror, elimination);
        if (half != 1) parts.push_back(halves.part({true, false, false}));
        if (half != 0) parts.push_back(halves.part({false, true, true}));
    } else if (!half) {
        if (!body.held_if_odd.empty())
            throw std::logic_error("a body held by symmetry whose mesh no plane x = const mirrors");
        parts.push_back(whole(body, elimination));
    }
    trim_freed_memory();  // the analysis leaves many blocks too small to go by themselves
    return parts;
}

}  // namespace tricontact::fem
