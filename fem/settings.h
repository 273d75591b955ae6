#pragma once

#include <optional>
#include <string>

namespace tricontact::fem {

/// How the sides of the layer's block are held.
enum class Sides { free, fixed };

/// Of the finite element layer. Kept with a case, see contact::Case::of().
struct Settings {
    std::optional<double> size;      ///< edge of an element in the contact patch [m]
    std::optional<double> accuracy;  ///< of the normal contact [-]: size is chosen for it
    double growth = 1.8;             ///< of neighbouring elements, outwards from the patch
    Sides sides = Sides::free;
    double tolerance = 1e-6;          ///< of the contact solvers [-]
    std::optional<std::string> mesh;  ///< a mesh file instead of a mesh of our own
    double mesh_unit = 1;             ///< length of 1 in that file [m]
    std::string cache;  ///< folder for condensed layers; empty: the user's; "none": not kept
};

}  // namespace tricontact::fem
