#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace tricontact::report {

/// A contact at successive instants, as a page plays it: fields on the cells that are ever in
/// contact, a byte each.
struct Film {
    enum Field { pressure, traction_x, traction_y, gap, state, n_fields };
    struct Frame {
        std::string label;    ///< "n = 2.25": equal at equal instants of other films
        double x = 0, y = 0;  ///< of the indenter [mm]
        double shift = 0;     ///< [µm]
        double position = 0;  ///< on the axis of `steps`
        double way = 0;       ///< along the path [mm]
    };
    /// Of each step: position on the axis, way along the path [mm], shift [µm].
    struct Step {
        double position = 0, way = 0, shift = 0;
    };

    std::string name;                     ///< of the model, for people
    int style = 0;                        ///< its colour, as in figures
    int n_x = 0, n_y = 0;                 ///< cells, x fastest
    double first_x = 0, first_y = 0;      ///< centre of the first cell [mm]
    double spacing_x = 0, spacing_y = 0;  ///< [mm]
    std::vector<bool> mask;               ///< cells that are ever in contact
    /// The largest p, |tau| and gap, in words: what 255, or 127 to either side of 128, stands for.
    std::string largest_pressure, largest_traction, largest_gap;
    std::vector<Frame> frames;
    /// Frame after frame, field after field, the masked cells in their order. State: 0 open, 1
    /// stick, 2 slip.
    std::vector<std::uint8_t> bytes;
    std::vector<Step> steps;
};

/// Films of the models of one case, side by side.
struct Player {
    std::string caption;
    std::string axis;  ///< of the positions: "period n [-]"
    std::vector<Film> films;
};

}  // namespace tricontact::report
