#pragma once

#include <memory>
#include <string>

#include "contact/case.h"
#include "contact/model.h"
#include "fem/case/model.h"
#include "fem/planar/element.h"

namespace tricontact::fem {

/// The contact of a case by finite elements of its section: a cylinder's in plane strain, or a body
/// of revolution pressed along its axis. Elements, if fem.size is not given, of such a size that
/// the force errs by fem.accuracy. `name`: of the model. Throws contact::InputError for what a
/// section cannot have, contact::NotConverged.
std::unique_ptr<contact::Model> make_section_model(const std::string& name, planar::Solid solid,
                                                   const contact::Case& c, const Say& say);

/// The size of elements that it takes [m].
double section_size(planar::Solid solid, const contact::Case& c);

}  // namespace tricontact::fem
