#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "contact/base/error.h"
#include "contact/case.h"
#include "contact/compliances/compliance.h"
#include "contact/substrates/material.h"
#include "fem/matrices.h"
#include "fem/memory.h"
#include "fem/settings.h"
#include "meshes/hex_mesh.h"

namespace tricontact::fem {

/// Bulk over shear modulus that stands for incompressible material: changes the contact's
/// compliance by 0.6 G/K.
constexpr double incompressible_bulk_ratio = 1e6;

/// Linear elasticity of a layer (or two) on a rigid base.
struct LayerProblem {
    meshes::HexMesh mesh;
    std::array<contact::Material, meshes::n_regions> materials{{{0, 0}, {0, 0}}};
    contact::Case::Base base = contact::Case::Base::bonded;
    Sides sides = Sides::free;
    double largest_bulk_ratio = incompressible_bulk_ratio;  ///< K/G is cut here
    double line_length = 0;  ///< see contact::ContactPoints [m]; the stiffness knows nothing of it
    /// Half of a body (y >= 0) whose other half is its mirror image in the plane of the base, which
    /// is frictionless: nothing keeps it from sliding along x. Displacements that are mirrored in x
    /// = 0 do not slide; for all others the base is held along x, so that they have an answer,
    /// which misses the reaction to a resultant along x.
    bool held_by_symmetry = false;
    /// Nothing but the contact holds the body: a pressure all over its base is the load, and
    /// displacements count from the mean of the base along z, the one that does the load's work.
    /// The body is mirrored in x = 0, half of it is meshed (y >= 0), and so are its displacements:
    /// for others the base is held.
    bool pressed_evenly = false;

    /// Displacements mirrored in x = 0 alone have an answer of their own.
    bool needs_symmetry() const { return held_by_symmetry || pressed_evenly; }
};

/// All that contact has to know about a discretised layer.
struct CondensedLayer {
    contact::ContactPoints points;
    /// Displacement [m] per force [N] on the modelled body (a mirrored one: on its half), 3n x 3n,
    /// x of all points, then y, then z out of the substrate; symmetric, by columns; rows and
    /// columns of held components are zero.
    std::vector<double> compliance;
    SparseMatrix contact_mass;  ///< see ContactSurface
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

/// Half of condense(), for one of two processes: of a body that a plane x = const mirrors the even
/// (0) or the odd displacements (1), analysed but not factorised.
class HalfCondensation {
  public:
    /// Throws std::bad_alloc.
    HalfCondensation(const LayerProblem& problem, int half);
    ~HalfCondensation();
    HalfCondensation(const HalfCondensation&) = delete;
    HalfCondensation& operator=(const HalfCondensation&) = delete;

    bool exists() const;             ///< there is such a plane
    double predicted_bytes() const;  ///< peak on top of now
    /// Both halves' compliances and missing reactions add up to those of condense(), of which they
    /// have the rest. Throws contact::NotConverged, std::bad_alloc. Once.
    CondensedLayer condense();

  private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

/// What `condense` will take at its peak [bytes], from a symbolic analysis.
double predicted_bytes(const LayerProblem& problem);

/// The contact of a slice in plane strain (meshes::LayerMeshSpec::plane_strain) under tractions
/// that are uniform along y: a grid of one row of points in y = 0, whose areas are those of all
/// rows, as long as both halves of the slice. Displacements are the means over y; along y there are
/// none, and those components are held. Row sums of the surface mass carry a uniform traction
/// exactly, so nothing is lost by the means. There is no contact mass: a line has no element
/// surface.
CondensedLayer contact_line(const CondensedLayer& slice);

}  // namespace tricontact::fem
