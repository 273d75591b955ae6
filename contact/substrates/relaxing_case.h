#pragma once

#include <functional>
#include <memory>
#include <string>

#include "contact/case.h"
#include "contact/substrates/substrate.h"

namespace tricontact::contact {

/// What stays elastic in a case whose substrate relaxes, the top layer: its finite bulk modulus
/// below nu = 1/2; layers or a half-space below whose plane-strain compliance (1 - nu^2)/E is more
/// than 1e-3 of its own; an indenter with more than 1e-3 of the compliance.
enum class Unrelaxed { nothing, bulk, below, indenter };
Unrelaxed what_stays(const Case& c);

/// The relaxation multiplies all the stiffness, or nothing relaxes.
inline bool relaxes_as_one(const Case& c) {
    return what_stays(c) == Unrelaxed::nothing;
}

/// The case as models of the half-space see it.
Case without_layer(const Case& c);

/// For models that know no other. Throws InputError unless relaxes_as_one().
std::optional<Relaxation> common_relaxation(const std::string& model, const Case& c);

/// The case with what relaxes `ratio` times as stiff as relaxed, and elastic.
Case with_relaxing_ratio(const Case& c, double ratio);

/// The substrate of a case. `compliance_of`: an elastic case's, on the same points always;
/// `relaxed`: that of the relaxed case; not needed unless relaxes_as_one().
using ComplianceOf = std::function<std::shared_ptr<const Compliance>(const Case&)>;
std::unique_ptr<Substrate> make_substrate(const Case& c, std::shared_ptr<const Compliance> relaxed,
                                          const ComplianceOf& compliance_of);

}  // namespace tricontact::contact
