#pragma once

#include <string>
#include <vector>

#include "benchmarks/comparison/comparison.h"

namespace tricontact::benchmarks {

/// A mesh in this project's conventions, with what its points stand for.
struct UnderstoodMesh {
    MeshResult result;
    /// Of profiles: the stretch that each point stands for [m]; empty on surfaces.
    std::vector<double> low, high;
    std::vector<double> height;  ///< of the points as in the file [m]; empty: the file has none
    std::optional<double> field_force;   ///< integral of its pressures, of the whole contact [N]
    std::optional<double> stress_force;  ///< the same of the stress at the surface
    double peak_pressure = 0;            ///< largest [Pa]
};

/// What was found out about a submission.
struct Understanding {
    std::vector<UnderstoodMesh> meshes;  ///< coarse to fine
    std::vector<Convention> conventions;
    std::vector<Diagnosis> diagnoses;  ///< of conventions that are not those of the deck
};

/// Finds out, over all meshes together, what the numbers of a submission are: their units where the
/// files have none, traction or nodal force, the part of the contact that was modelled, sign, body
/// and axes of tractions, deformed coordinates. Three numbers have to agree: the force given, the
/// integral of the field and the reference's force; and the reach of the field has to be the
/// reference's. Throws contact::InputError where nothing agrees (with the nearest readings), or two
/// readings do.
Understanding understand(const Submission& submission, const Reference& reference);

}  // namespace tricontact::benchmarks
