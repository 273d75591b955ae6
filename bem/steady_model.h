#pragma once

#include <memory>

#include "bem/model.h"
#include "contact/compliances/steady_compliance.h"

namespace tricontact::bem {

/// The relaxing substrate of a case once it rolls on steadily, on a grid that covers the contact:
/// see case_compliance. Null where its coefficients are not known far ahead of the contact, those
/// of a file (`bem.influence`) and of a period (`bem.period`): there only rolling on tells.
std::unique_ptr<contact::SteadyCompliance> steady_compliance(const contact::Case& c, int n_threads,
                                                             Body body, double aside = 0);

}  // namespace tricontact::bem
