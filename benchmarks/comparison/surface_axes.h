#pragma once

#include "benchmarks/comparison/conventions.h"

namespace tricontact::benchmarks {

struct ContactReach;

/// Turns understood meshes to the axes of the reference: moves them so that the centre of pressure
/// is the reference's, back to undeformed positions where the heights follow the indenter,
/// tangential tractions to those on the elastic body along its axes, displacements into the body.
/// Notes what it did.
void turn_to_reference(Understanding& all, const Reference& reference, const ContactReach& reach);

}  // namespace tricontact::benchmarks
