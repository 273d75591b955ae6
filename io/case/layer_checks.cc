#include "io/case/case_checks.h"
#include "io/keys/refusal.h"

namespace tricontact::io {

namespace {

using contact::Case;
using Base = Case::Base;

void check_length(const std::string& key, std::size_t n, std::size_t n_layers,
                  const Document& document) {
    if (n == n_layers) return;
    refuse(document, key,
           "has " + std::to_string(n) + " elements, but lower_layer.thickness has " +
               std::to_string(n_layers),
           "give one for each layer, from the top down");
}

// Of its contact radius: as a membrane it gives way (a/b) times as far along itself as across, and
// solvers compare both with the indentation.
constexpr double thinnest_gliding = .01;

void check_gliding(const Case& c, const Document& document) {
    if (c.layer.base != Base::frictionless) return;
    const double least = thinnest_gliding * contact::half_space_scales(c).contact_radius;
    if (c.layer.total_thickness() >= least) return;
    refuse(document, "substrate.thickness",
           "a layer that glides on its ground must be at least " + rounded(least) + " m thick, " +
               rounded(thinnest_gliding) +
               " of the contact radius on a half-space: thinner, it is a membrane",
           "take base = \"bonded\", a thicker layer or a smaller contact");
}

void check_fem_layers(const Case& c, const Document& document) {
    if (c.layer.base == Base::half_space)
        refuse(document, "substrate.base", "fem has its layers on a rigid ground",
               "leave out fem, or give a thick [lower_layer] of the ground's material instead");
    if (c.layer.lower.size() > 1)
        refuse(document, "lower_layer.thickness",
               "fem meshes at most two layers, but the case has " +
                   std::to_string(1 + c.layer.lower.size()),
               "leave out fem, or all lower layers but one");
}

}  // namespace

void resolve_lower_layers(Case& c, const Document& document) {
    if (!c.lower_layers_input) return;
    const auto& input = *c.lower_layers_input;
    const std::size_t n = input.thickness.size();
    check_length("lower_layer.young", input.young.size(), n, document);
    check_length("lower_layer.poisson", input.poisson.size(), n, document);
    for (std::size_t i = 0; i < n; ++i)
        c.layer.lower.push_back({input.thickness[i], {input.young[i], input.poisson[i]}});
    c.lower_layers_input.reset();
}

void state_lower_layers(Case& c) {
    if (c.layer.lower.empty()) return;
    Case::LowerLayersInput input;
    for (const auto& [thickness, material] : c.layer.lower) {
        input.thickness.push_back(thickness);
        input.young.push_back(material.young);
        input.poisson.push_back(material.poisson);
    }
    c.lower_layers_input = input;
}

void check_ground(const Case& c, const Document& document) {
    const bool elastic = c.layer.base == Base::half_space;
    if (elastic && !c.layer.ground)
        refuse(document, "substrate.base", "the half-space below the layers has no material",
               "add a section [ground] with young and poisson");
    if (!elastic && c.layer.ground)
        refuse(document, "ground.young",
               "the ground is rigid unless substrate.base = \"half-space\"",
               "write base = \"half-space\" in [substrate], or omit [ground]");
}

void check_layer(const std::string& model, const Case& c, const Document& document) {
    if (!c.layer.thickness)
        refuse(document, "models",
               model + " models a layer, but the case has no substrate.thickness",
               "add thickness = \"8 mm\" or the like to [substrate], or leave out " + model);
    if (model == "mdr-layer" && c.layer.base == Base::frictionless)
        refuse(document, "substrate.base",
               "mdr-layer: nothing holds a layer that glides on its ground against a tangential "
               "force",
               "take base = \"bonded\" or \"half-space\", or leave out mdr-layer");
    if (model == "bem-layer") check_gliding(c, document);
    if (model == "fem") check_fem_layers(c, document);
}

}  // namespace tricontact::io
