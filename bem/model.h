#pragma once

#include <memory>

#include "bem/influence_file.h"
#include "contact/base/error.h"
#include "contact/case.h"
#include "contact/compliances/compliance.h"
#include "contact/model.h"
#include "contact/substrates/substrate.h"

namespace tricontact::bem {

/// What the boundary elements take the substrate for.
enum class Body { half_space, layer };

/// y = 0 is a plane of symmetry of body, loads and path: half of the grid tells all. Not of grids
/// that are a period of the surface.
bool is_mirrored(const contact::Case& c);

/// The compliance of a case: on a grid that covers the contact along its whole rolling path and is
/// enlarged until it does; of a periodic case with the images of its cells. `n_threads`: for the
/// transforms; results do not depend on it. Throws contact::InputError if the grid would be too
/// large, or a file of influence coefficients does not fit, or the contact does not fit into the
/// period. `aside`: how far beside the path of the body's lowest point friction may take the
/// contact, over its half length [-]. `mirrored`: on y >= 0 alone, if is_mirrored(c).
std::unique_ptr<contact::Compliance> case_compliance(const contact::Case& c, int n_threads,
                                                     Body body, double aside = 0,
                                                     bool mirrored = false);

/// The next larger `aside`, for a contact that reached the edge of the grid. Throws
/// contact::NotConverged after the largest one.
double more_room(double aside, const contact::ContactAtEdge& reached);

/// The influence coefficients that this compliance is made of, as far as it asks for them. Throws
/// contact::InputError, also for a periodic case, which has none.
InfluenceTable case_influence(const contact::Case& c, int n_threads, Body body);

/// Reads the case's file of influence coefficients, if it has one, to see whether it is whole and
/// of the case's cells. Throws contact::InputError.
void check_influence_file(const contact::Case& c);

/// The substrate of a case, elastic or relaxing, on the grid of its case_compliance, which says
/// what `aside` and `mirrored` are. Throws contact::InputError.
std::unique_ptr<contact::Substrate> make_substrate(const contact::Case& c, int n_threads, Body body,
                                                   double aside = 0, bool mirrored = false);

/// Boundary elements for a case, on the grid of its case_compliance, or, if that proves too small,
/// one with more_room beside the path; on half of it if is_mirrored. Throws contact::InputError.
std::unique_ptr<contact::Model> make_model(const contact::Case& c, int n_threads,
                                           Body body = Body::half_space);

}  // namespace tricontact::bem
