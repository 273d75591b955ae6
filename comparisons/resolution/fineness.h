#pragma once

#include <string>
#include <vector>

#include "contact/case.h"
#include "contact/models/model_kind.h"

namespace tricontact::comparisons {

/// What lengths of cells and elements become: length times coarser / finer; numbers of springs the
/// inverse. Two numbers, so that a root of two in either is rounded once.
struct Fineness {
    double coarser = 1, finer = 1;
};

/// Side of cells, edge of elements, how far apart springs are [m], on a line by the contact radius
/// and the path of the half-space. A case for fem has to give the size of elements.
double cell_size(const contact::Case& c, const contact::ModelKind& kind);

/// Changes the resolution of a model in a case: its key, or the one that the case has in its place.
/// A case for fem has to give the size of elements. Models that choose by themselves stay as they
/// are.
void change_resolution(contact::Case& c, const contact::ModelKind& kind, const Fineness& by);

/// The same for a level of a study or a refinement, as keys that override those of the case; there
/// elements also grow outwards by a root of the case's growth, so that the whole mesh is refined.
/// Throws contact::InputError where the model has no finer levels.
std::vector<std::string> level_keys(const contact::Case& c, const contact::ModelKind& kind,
                                    const Fineness& by);

/// Overrides a key that is a length: key="0.001 m".
std::string length_key(const std::string& key, double metres);

}  // namespace tricontact::comparisons
