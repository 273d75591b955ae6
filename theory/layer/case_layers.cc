#include "theory/layer/case_layers.h"

#include "contact/error.h"

namespace tricontact::theory {

using Base = contact::Case::Base;

LayerStack layers_of(const std::string& model, const contact::Case& c) {
    if (!c.layer.thickness)
        throw contact::InputError(
            model + ": substrate.thickness is missing; give the thickness of the layer");
    if (c.layer.base == Base::half_space && !c.layer.ground)
        throw contact::InputError(
            model +
            ": substrate.base = \"half-space\" without [ground]; give its young and poisson");
    LayerStack stack;
    stack.sheets.push_back({c.substrate, *c.layer.thickness});
    for (const auto& lower : c.layer.lower)
        stack.sheets.push_back({lower.material, lower.thickness});
    if (c.layer.base == Base::frictionless) stack.base = LayerBase::frictionless;
    if (c.layer.base == Base::half_space) stack.half_space = c.layer.ground;
    return stack;
}

}  // namespace tricontact::theory
