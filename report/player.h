#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace tricontact::report {

/// Cells of a picture, x fastest; a row of them is a line along x.
struct FilmGrid {
    int n_x = 0, n_y = 0;
    double first_x = 0, first_y = 0;      ///< centre of the first cell [mm]
    double spacing_x = 0, spacing_y = 0;  ///< [mm]

    std::size_t size() const { return static_cast<std::size_t>(n_x) * n_y; }
    double x(int i) const { return first_x + i * spacing_x; }
    double y(int j) const { return first_y + j * spacing_y; }
};

/// A contact at successive instants, as a page plays it: fields on the cells that are ever in
/// contact, a byte each; beside them the surface around the contact and sections below it.
struct Film {
    enum Field { pressure, traction_x, traction_y, gap, state, n_fields };
    /// What of a run is played: before the first period, that period and the last one; or the rows
    /// of a prescribed path.
    enum class Part { pressed, loaded, first_period, last_period, path };
    struct Frame {
        std::string label;  ///< "n = 2.25", "row 3"
        Part part = Part::path;
        double phase = 0;     ///< of its period, up to 1; of a path the row
        double x = 0, y = 0;  ///< of the indenter [mm]
        double shift = 0;     ///< [µm]
        double position = 0;  ///< on the axis of `steps`
        double way = 0;       ///< along the path [mm]
        double force = 0;     ///< F_T along x [N]
        double depth = 0;     ///< of the indenter's lowest point, d [µm]
        double rotation = 0;  ///< of the indenter about the normal, from x towards y [rad]
        int section = -1;     ///< its place in `von_mises`; none: -1
    };
    /// Of each step: position on the axis, way along the path [mm], shift [µm], F_T [N].
    struct Step {
        double position = 0, way = 0, shift = 0, force = 0;
    };

    std::string name;        ///< of the model, for people
    int style = 0;           ///< its colour, as in figures
    std::string line;        ///< what a line of cells is made of, "springs"; empty: a surface
    FilmGrid cells;          ///< of the fields
    std::vector<bool> mask;  ///< cells that are ever in contact
    /// The largest p, |tau|, gap and von Mises' stress, in words: what 255, or 127 to either side
    /// of 128, stands for.
    std::string largest_pressure, largest_traction, largest_gap, largest_von_mises;
    std::array<double, 4> largest{};  ///< the same [Pa], [Pa], [m], [Pa]
    std::vector<Frame> frames;
    /// Frame after frame, field after field, the masked cells in their order. State: 0 open, 1
    /// stick, 2 slip.
    std::vector<std::uint8_t> bytes;
    std::vector<Step> steps;

    /// Height of the surface over the undeformed one, frame after frame: from `lowest` to `highest`
    /// [µm] in 65535 steps. Empty without a surface.
    FilmGrid relief;
    double lowest = 0, highest = 0;
    std::vector<std::uint16_t> heights;

    /// Von Mises' stress in the plane of the indenter's y, rows from the surface (y = 0) downwards,
    /// in 254 steps from 1; 0: not computed there.
    FilmGrid section;
    std::vector<std::uint8_t> von_mises;
};

/// Films of the models of one case, side by side.
struct Player {
    /// An instant that all models have: the same row of the path, or the same share of the first or
    /// of the last period, whichever number that period has.
    struct Instant {
        std::string label;
        std::vector<int> frames;  ///< of each film; -1: it has none, as it is never loaded
    };
    std::string caption;
    std::string axis;  ///< of the positions: "period n [-]"
    std::vector<Film> films;
    std::vector<Instant> instants;       ///< in their order; the page opens on the last one
    std::array<std::string, 4> largest;  ///< of all films, in words: the end of a common scale
    /// Height of the indenter over its lowest point, at positions from there: up to `highest_body`
    /// [µm] in 65534 steps; 65535: beyond its rim. Empty where no film has a relief.
    FilmGrid body;
    double highest_body = 0;
    std::vector<std::uint16_t> body_heights;
};

}  // namespace tricontact::report
