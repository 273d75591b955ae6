#pragma once

#include <vector>

#include "contact/case.h"
#include "fem/planar/body.h"
#include "fem/planar/sections.h"

namespace tricontact::fem {

/// Where sections have small elements: to either side of their lowest point, or around it [m].
struct SectionPatch {
    double half_width, size;
    bool is_whole_face = false;  ///< ends where the indenter does
};

/// Of this half width, or all of a sharp punch's face if that is no more than a little wider.
SectionPatch section_patch(const contact::Case& c, double half_width, double size);
/// Most that a patch may have of the bodies [m].
double widest_patch(const contact::Case& c);
planar::Sizes sizes_of(const contact::Case& c, const SectionPatch& patch);

/// The bodies of a case that deform, the one that presses first.
std::vector<planar::CondensedSection> bodies_of(const contact::Case& c, planar::Solid solid,
                                                const planar::Sizes& sizes);

/// A body between two plates (contact::UpperPlate), whose pressures below and above displace both
/// of its sides; displacements count from the mean of its middle plane. The bodies whose
/// compliances add up: at either contact under its own pressures, and of the body alone at one side
/// under those of the other.
struct OpposedSections {
    std::vector<planar::CondensedSection> lower, upper, across;
};
/// `upper`: see seen_from_above().
OpposedSections opposed_sections(const contact::Case& c, const contact::Case& upper,
                                 planar::Solid solid, const planar::Sizes& sizes);

/// The case with its upper plate as the substrate, pressed by this force [N].
contact::Case seen_from_above(const contact::Case& c, double force);

}  // namespace tricontact::fem
