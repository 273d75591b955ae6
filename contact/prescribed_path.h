#pragma once

#include <array>
#include <vector>

#include "contact/base/vector2.h"
#include "contact/solvers/centre_of_rotation.h"
#include "contact/solvers/control.h"

namespace tricontact::contact {

/// Loads and motions of the indenter, row by row; from one row to the next all change linearly, in
/// equal steps. The kinds of control are the same in all rows. The contact starts unloaded: the
/// first row is reached from no load at its own offset, all else in proportion, or is itself
/// without load: a force or depth of 0, or a depth before the bodies touch.
struct PrescribedPath {
    struct Row {
        double time = 0;      ///< [s]; 0 throughout where no time is prescribed
        Vector2 offset{};     ///< of the indenter's lowest point over the substrate, by rolling [m]
        double rotation = 0;  ///< twist of the indenter about `centre`, from x towards y [rad]
        NormalControl normal;  ///< positive but for the first row's, and under adhesion
        std::array<TangentialControl, 2> tangential;  ///< x, y: forces or shifts
        double bulk_stress = 0;  ///< XX in all of the substrate, tension positive [Pa]
        int steps = 1;           ///< from the row before
    };
    std::vector<Row> rows;  ///< two or more
    CentreOfRotation centre = {};

    bool starts_unloaded() const { return rows.front().normal.value <= 0; }
    /// Whether anything but pressing happens on the way to the first row.
    bool loads_first_row() const;
    /// The hardest normal control of all rows: what grids and scales are made for.
    NormalControl hardest_normal() const;
    /// Largest |offset| along x and along y [m].
    Vector2 reach() const;
    /// Whether all loads and motions keep y = 0 a plane of symmetry.
    bool is_along_x() const;
    /// Direction of the line through 0 on which all offsets lie [rad]; 0 where they lie on none.
    double direction() const;
    bool twists() const;
    bool has_bulk_stress() const;
    bool loads_across() const;  ///< whether a force or shift acts along y
    bool is_timed() const { return rows.back().time > rows.front().time; }
    int n_steps() const;  ///< after the first row

    /// `share` of the way from one row to the next, 0 to 1.
    static Row between(const Row& from, const Row& to, double share);
};

}  // namespace tricontact::contact
