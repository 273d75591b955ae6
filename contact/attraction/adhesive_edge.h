#pragma once

namespace tricontact::contact {

/// How the edge of a contact of cells that adheres without a range lets go. Kept with a case, see
/// Case::of().
struct AdhesiveEdge {
    enum class Kind {
        ring,  ///< a tension over a ring of cells stands for it
        cell   ///< cells one by one, see CellAdhesion
    };
    Kind kind = Kind::ring;

    bool is_by_cell() const { return kind == Kind::cell; }
};

}  // namespace tricontact::contact
