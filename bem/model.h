#pragma once

#include <memory>

#include "bem/case_compliance.h"
#include "contact/case.h"
#include "contact/model.h"
#include "contact/substrates/substrate.h"

namespace tricontact::bem {

/// The substrate of a case, elastic or relaxing, on the grid of its case_compliance, which says
/// what `aside` is. Throws contact::InputError.
std::unique_ptr<contact::Substrate> make_substrate(const contact::Case& c, int n_threads, Body body,
                                                   double aside = 0);

/// Boundary elements for a case, on the grid of its case_compliance, or, if that proves too small,
/// one with more_room beside the path. Throws contact::InputError.
std::unique_ptr<contact::Model> make_model(const contact::Case& c, int n_threads,
                                           Body body = Body::half_space);

}  // namespace tricontact::bem
