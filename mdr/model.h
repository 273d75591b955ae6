#pragma once

#include <memory>

#include "contact/case.h"
#include "contact/model.h"

namespace tricontact::mdr {

/// The spring bed of a case, as long as its contact and its rolling path need; on an elastic
/// interface that of make_model_on_interface().
/// Throws contact::InputError if a value of the case is out of range or the contact would reach
/// beyond the indenter's rim.
std::unique_ptr<contact::Model> make_model(const contact::Case& c);

}  // namespace tricontact::mdr
