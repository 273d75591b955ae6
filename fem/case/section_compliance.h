#pragma once

#include <memory>

#include "contact/case.h"
#include "contact/models/model_kind.h"
#include "fem/case/section_bodies.h"
#include "fem/planar/pair.h"

// The bodies of a case as sections, pressed on each other.

namespace tricontact::fem {

/// Throws contact::InputError: the contact is more than this [m] to either side.
[[noreturn]] void refuse_too_large(const contact::Case& c, double half_width);

/// Throws contact::InputError unless something deforms.
void require_bodies(const contact::Case& c, const contact::ModelKind& kind);

planar::Solid solid_of(const contact::ModelKind& kind);

/// Sizes of sections that have room for the patch. Throws contact::InputError.
planar::Sizes fitting_sizes(const contact::Case& c, const SectionPatch& patch);

planar::PairOptions pair_options(const contact::Case& c, planar::Solid solid, bool is_whole_face);

/// What tractions belong to: nodes, or linear functions where those of both bodies do not meet; or
/// whole elements, on which they are constant.
enum class SectionPoints { nodes, elements };

/// Of all bodies that deform. Throws contact::InputError for what cannot be meshed.
std::unique_ptr<planar::SectionCompliance> section_compliance(
    const contact::Case& c, planar::Solid solid, const SectionPatch& patch,
    SectionPoints points = SectionPoints::nodes);

/// Half width or radius of a contact [m], and its force [N].
struct SectionProbe {
    double radius = 0, force = 0;
};
/// The contact under the case's hardest load, on coarse elements.
SectionProbe probed_section(const contact::Case& c, planar::Solid solid);

/// Of elements, if the case does not give it, for a contact of this radius [m].
double chosen_size(const contact::Case& c, double radius);

}  // namespace tricontact::fem
