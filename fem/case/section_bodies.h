#pragma once

#include <memory>

#include "contact/case.h"
#include "contact/models/model_kind.h"
#include "fem/planar/pair.h"

// The bodies of a case as sections, condensed to a patch of the surface where they touch.

namespace tricontact::fem {

struct SectionPatch {
    double half_width, size;     ///< of the patch, of its elements [m]
    bool is_whole_face = false;  ///< ends where the indenter does
};

/// Of this half width, or all of a sharp punch's face if that is no more than a little wider.
SectionPatch section_patch(const contact::Case& c, double half_width, double size);

/// Most that a patch may have of the bodies [m].
double widest_patch(const contact::Case& c);

/// Throws contact::InputError: the contact is more than this [m] to either side.
[[noreturn]] void refuse_too_large(const contact::Case& c, double half_width);

/// Throws contact::InputError unless something deforms.
void require_bodies(const contact::Case& c, const contact::ModelKind& kind);

planar::Solid solid_of(const contact::ModelKind& kind);

/// What tractions belong to: nodes, or linear functions where those of both bodies do not meet; or
/// whole elements, on which they are constant.
enum class SectionPoints { nodes, elements };

/// Of all bodies that deform. Throws contact::InputError for what cannot be meshed.
std::unique_ptr<planar::SectionCompliance> section_compliance(
    const contact::Case& c, planar::Solid solid, const SectionPatch& patch,
    SectionPoints points = SectionPoints::nodes);

/// Half width or radius of the contact under the case's hardest load [m], on coarse elements.
double probed_radius(const contact::Case& c, planar::Solid solid);

/// Of elements, if the case does not give it, for a contact of this radius [m].
double chosen_size(const contact::Case& c, double radius);

}  // namespace tricontact::fem
