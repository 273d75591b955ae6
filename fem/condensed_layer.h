#pragma once

#include <array>
#include <string>
#include <vector>

#include "contact/error.h"
#include "contact/solvers/compliance.h"
#include "fem/layer_problem.h"
#include "fem/memory.h"
#include "fem/sparse_matrix.h"

namespace tricontact::fem {

/// All that contact has to know about a discretised layer.
struct CondensedLayer {
    contact::ContactPoints points;
    /// Displacement [m] per force [N] on the modelled body (a mirrored one: on its half), 3n x 3n,
    /// x of all points, then y, then z out of the substrate; symmetric, by columns; rows and
    /// columns of held components are zero.
    std::vector<double> compliance;
    SparseMatrix contact_mass;  ///< see Discretisation
    /// Ground's reaction + force under unit forces: by direction, components as above.
    std::array<std::vector<double>, 3> missing_reaction;

    /// The largest of them.
    double reaction_error() const;
};

/// A condensation does not fit into the memory that is there.
class MemoryShort : public contact::InputError {
  public:
    MemoryShort(const std::string& message, double needed, double available)
        : InputError(message), needed_bytes(needed), available_bytes(available) {}
    double needed_bytes;  ///< 0: more than could be found out
    double available_bytes;
};

/// Discretises and condenses. Throws MemoryShort when the memory that is there does not
/// suffice, naming what is missing; contact::NotConverged.
CondensedLayer condense(const LayerProblem& problem);

/// What `condense` will take at its peak [bytes], from a symbolic analysis.
double predicted_bytes(const LayerProblem& problem);

}  // namespace tricontact::fem
