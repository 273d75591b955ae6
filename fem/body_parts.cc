#include "fem/body_parts.h"

#include <numeric>
#include <optional>

#include "fem/dissection_order.h"
#include "fem/memory.h"
#include "fem/mirror_symmetry.h"

namespace tricontact::fem {

namespace {

BodyPart whole(const Discretisation& body) {
    auto [matrix, held_rows] = body.assemble();
    const Unknowns& unknowns = body.unknowns;
    std::vector<int> own(unknowns.n);
    std::iota(own.begin(), own.end(), 0);
    return {.unknown = std::move(own),
            .sign = std::vector<std::int8_t>(unknowns.n, 1),
            .held_rows = std::move(held_rows),
            .condensation = {std::move(matrix), unknowns.node_of_unknown, unknowns.n_interior}};
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

// Rows and columns that have a place, in that order.
SparseMatrix restricted(const SparseMatrix& matrix, const std::vector<int>& place, int n) {
    SparseMatrix part;
    part.n = n;
    part.column_start.push_back(0);
    reserve_large(part.row, matrix.row.size());
    reserve_large(part.value, matrix.row.size());
    for (int c = 0; c < matrix.n; ++c) {
        if (place[c] < 0) continue;
        for (auto k = matrix.column_start[c]; k < matrix.column_start[c + 1]; ++k) {
            const int row = place[matrix.row[k]];
            if (row < 0) continue;
            part.row.push_back(row);
            part.value.push_back(matrix.value[k]);
        }
        part.column_start.push_back(static_cast<std::int64_t>(part.row.size()));
    }
    return part;
}

// A body of two halves: the stiffness of one serves both parts, which hold other displacements on
// the plane.
class Halves {
  public:
    Halves(const Discretisation& body, const MirrorSymmetry& mirror)
        : body_(body.unknowns),
          mirror_(mirror),
          half_(half_of(body.unknowns, mirror)),
          stiffness_(body.assemble(half_, mirror.half)),
          order_(dissection_order(stiffness_.matrix, half_.node_of_unknown, half_.n_interior)) {}

    // `changes_sign`: which displacements do so from one side to the other.
    BodyPart part(std::array<bool, 3> changes_sign) const {
        std::vector<int> place(half_.n, -1);
        int n = 0, n_interior = 0;
        for (int h = 0; h < half_.n; ++h) {
            const bool on_plane = mirror_.side[half_.node_of_unknown[h]] == 0;
            if (on_plane && changes_sign[half_.direction_of_unknown[h]]) continue;
            place[h] = n++;
            if (h < half_.n_interior) n_interior = n;
        }
        std::vector<std::int64_t> order;
        for (const std::int64_t h : order_)
            if (place[h] >= 0) order.push_back(place[h]);
        BodyPart part{.unknown = {},
                      .sign = {},
                      .share = .5,
                      .held_rows = held_rows(place, changes_sign),
                      .condensation = {restricted(stiffness_.matrix, place, n), std::move(order),
                                       n_interior}};
        extend(place, changes_sign, part);
        return part;
    }

  private:
    // A motion of all that is held is even or odd itself: along x it is odd.
    std::array<std::vector<double>, 3> held_rows(const std::vector<int>& place,
                                                 std::array<bool, 3> changes_sign) const {
        std::array<std::vector<double>, 3> rows;
        for (int direction = 0; direction < 3; ++direction)
            for (int h = 0; h < half_.n && !changes_sign[direction]; ++h)
                if (place[h] >= 0) rows[direction].push_back(stiffness_.held_rows[direction][h]);
        return rows;
    }

    void extend(const std::vector<int>& place, std::array<bool, 3> changes_sign,
                BodyPart& part) const {
        for (int u = 0; u < body_.n; ++u) {
            const int node = body_.node_of_unknown[u], direction = body_.direction_of_unknown[u];
            const bool is_image = mirror_.side[node] < 0;
            const int origin = is_image ? mirror_.image[node] : node;
            part.unknown.push_back(place[half_.of_node[origin][direction]]);
            part.sign.push_back(is_image && changes_sign[direction] ? -1 : 1);
        }
    }

    const Unknowns& body_;
    const MirrorSymmetry& mirror_;
    Unknowns half_;
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

std::vector<BodyPart> parts_of(const Discretisation& body) {
    std::vector<BodyPart> parts;
    if (const std::optional<MirrorSymmetry> mirror = mirror_symmetry(body.space)) {
        const Halves halves(body, *mirror);
        parts.push_back(halves.part({true, false, false}));
        parts.push_back(halves.part({false, true, true}));
    } else {
        parts.push_back(whole(body));
    }
    return parts;
}

}  // namespace tricontact::fem
