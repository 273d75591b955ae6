#pragma once

#include <vector>

#include "contact/case.h"
#include "contact/load_path.h"
#include "fem/case/layer_condenser.h"
#include "fem/case/model.h"

namespace tricontact::fem {

/// A mesh of elements of `size` in a patch that a contact of this radius sweeps on the case's path
/// and `shift` [m] aside along x. Under a cylinder a slice in plane strain; under a roller the
/// patch is as long as it, and finer towards its ends.
meshes::LayerMeshSpec spec_for(const contact::Case& c, double size, double contact_radius,
                               double shift = 0);

/// Radius (along x of a cylinder or roller) of the case's contact under `control` on a layer of
/// coarse elements [m], rounded up by an element. Presses again on a larger patch when the contact
/// reaches the edge.
double probe_radius(const contact::Case& c, const contact::NormalControl& control,
                    LayerCondenser& condenser);

/// Pressure or tension on the points of surfaces that attract each other, on coarse elements: too
/// large for short ranges. Then there is none, and the tension acts where gaps are within them.
std::vector<double> attracted_by(const contact::Case& c, const contact::Compliance& compliance,
                                 const std::vector<double>& height,
                                 const contact::NormalControl& control);

/// Element size for the case's fem.accuracy [m]: the layer is pressed on two coarse meshes, and
/// their difference in indentation (or force), peak pressure and unit shift extrapolated with
/// order 1.5, less than is observed. `radius` [m]: of the contact.
double size_for_accuracy(const contact::Case& c, double radius, LayerCondenser& condenser);

/// What the contact sees on the mesh of `spec`, see LayerCondenser::make_contact(). When the memory
/// does not suffice, the error names the size that would.
std::unique_ptr<contact::Compliance> make_fitting(const contact::Case& c,
                                                  const meshes::LayerMeshSpec& spec,
                                                  LayerCondenser& condenser);
/// The same of a layer under a rigid indenter.
std::unique_ptr<CondensedCompliance> make_fitting_layer(const contact::Case& c,
                                                        const meshes::LayerMeshSpec& spec,
                                                        LayerCondenser& condenser);

}  // namespace tricontact::fem
