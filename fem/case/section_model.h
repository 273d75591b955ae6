#pragma once

#include <memory>

#include "contact/case.h"
#include "contact/model.h"
#include "contact/models/model_kind.h"
#include "fem/case/model.h"

namespace tricontact::fem {

/// The contact of a case by finite elements of its section, as the kind of the model cuts it: a
/// cylinder's in plane strain, or a body of revolution pressed along its axis; the indenter's body
/// and the layer deform where the case says so. Elements, if fem.size is not given, of such a size
/// that the force errs by fem.accuracy. Throws contact::InputError for what cannot be meshed,
/// contact::NotConverged.
std::unique_ptr<contact::Model> make_section_model(const contact::ModelKind& kind,
                                                   const contact::Case& c, const Say& say);

/// The size of elements that it takes [m].
double section_size(const contact::ModelKind& kind, const contact::Case& c);

}  // namespace tricontact::fem
