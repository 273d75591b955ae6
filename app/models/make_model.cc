#include "app/models/make_model.h"

#include <algorithm>
#include <iterator>

#include "bem/model.h"
#include "bem/settings.h"
#include "comparisons/resolution/fineness.h"
#include "contact/base/error.h"
#include "contact/model_on_rig.h"
#include "fem/settings.h"
#include "mdr/layer_model.h"
#include "mdr/model.h"
#include "mdr/settings.h"
#ifdef TRICONTACT_WITH_FEM
#include "app/models/fem_entries.h"
#endif

namespace tricontact::app {

namespace {

using contact::Case;
using contact::CoarserModel;
using contact::MeshBlock;
using contact::Say;

bool has_model([[maybe_unused]] std::string_view name) {
#ifndef TRICONTACT_WITH_FEM
    if (contact::model_kind(name).is_meshed()) return false;
#endif
    return contact::find_model_kind(name) != nullptr;
}

std::unique_ptr<contact::Model> make_bare_model(const std::string& name, const Case& c,
                                                int n_threads, [[maybe_unused]] const Say& say) {
    if (name == contact::models::mdr) return mdr::make_model(c);
    if (name == contact::models::mdr_layer) return mdr::make_layer_model(c);
    if (name == contact::models::bem) return bem::make_model(c, n_threads);
    if (name == contact::models::bem_layer) return bem::make_model(c, n_threads, bem::Body::layer);
#ifdef TRICONTACT_WITH_FEM
    if (name == contact::models::fem) return fem_entries().make_model(c, n_threads, say);
    if (const auto& kind = contact::model_kind(name); kind.is_section())
        return fem_entries().make_section_model(kind, c, say);
#endif
    if (name == contact::models::atlas)
        throw contact::InputError(
            "models: atlas runs nothing: it holds what runs came to; take tricontact predict, or "
            "name another model");
    throw contact::InputError("models: this program was built without the model " + name);
}

/// Behind the rig that drives it.
std::unique_ptr<contact::Model> make_model(const std::string& name, const Case& c, int n_threads,
                                           const Say& say) {
    auto model = make_bare_model(name, c, n_threads, say);
    const contact::RigStiffness& rig = c.of<contact::RigStiffness>();
    return rig.yields() ? std::make_unique<contact::ModelOnRig>(std::move(model), rig)
                        : std::move(model);
}

double solver_tolerance(const std::string& name, const Case& c) {
    const contact::ModelKind& kind = contact::model_kind(name);
    if (kind.is_on_cells()) return c.of<bem::Settings>().tolerance;
    return kind.is_meshed() ? c.of<fem::Settings>().tolerance : contact::layer_springs_accuracy;
}

MeshBlock block_of([[maybe_unused]] const Case& c, [[maybe_unused]] const Say& say) {
#ifdef TRICONTACT_WITH_FEM
    const meshes::LayerMeshSpec spec = fem_entries().mesh_spec(c, say);
    return {spec.size, 2 * spec.half_x, 2 * spec.half_y};
#else
    throw contact::InputError("models: this program was built without the model fem");
#endif
}

/// That the model chooses.
double element_size([[maybe_unused]] const contact::ModelKind& kind, const Case& c) {
#ifdef TRICONTACT_WITH_FEM
    if (kind.is_section()) return fem_entries().section_size(kind, c);
#endif
    return block_of(c, contact::silent).size;
}

CoarserModel make_coarser_model(const std::string& name, const Case& c, double factor,
                                int n_threads, const Say& say) {
    CoarserModel coarser{.c = c, .model = {}};
    const contact::ModelKind& kind = contact::model_kind(name);
    const auto& body = c.indenter.body;
    if (kind.is_meshed() && (c.of<fem::Settings>().mesh || (body && body->mesh)))
        throw contact::InputError("the mesh is a file's; run another one beside it");
    if (kind.is_meshed() && !c.of<fem::Settings>().size)
        coarser.c.of<fem::Settings>().size = element_size(kind, c);
    comparisons::change_resolution(coarser.c, kind, {.coarser = factor});
    coarser.model = make_model(name, coarser.c, n_threads, say);
    return coarser;
}

void load_model([[maybe_unused]] const std::string& name) {
#ifdef TRICONTACT_WITH_FEM
    if (contact::model_kind(name).is_meshed()) fem_entries();
#endif
}

}  // namespace

const contact::ModelMakers& model_makers() {
    static const contact::ModelMakers makers{has_model, make_model, make_coarser_model,
                                             block_of,  load_model, solver_tolerance};
    return makers;
}

std::vector<contact::ModelKind> known_models() {
    std::vector<contact::ModelKind> models;
    std::ranges::copy_if(contact::model_kinds(), std::back_inserter(models),
                         [](const contact::ModelKind& model) { return has_model(model.name); });
    return models;
}

}  // namespace tricontact::app
