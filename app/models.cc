#include "app/models.h"

#include "bem/model.h"
#include "contact/error.h"
#include "mdr/layer_model.h"
#include "mdr/model.h"
#ifdef TRICONTACT_WITH_FEM
#include "app/fem_entries.h"
#endif

namespace tricontact::app {

const std::vector<ModelDescription>& known_models() {
    static const std::string of_grids =
        "Boussinesq (1885), Cerruti (1882), Love (1929), Ju and Farris (1996), Liu, Wang and Liu "
        "(2000), Polonsky and Keer (1999), Frigo and Johnson (2005)";
    static const std::string of_coupling = "Panagiotopoulos (1975), Anderson (1965)";
    static const std::vector<ModelDescription> models = {
        {"mdr", "method of dimensionality reduction: a bed of independent springs, stepped exactly",
         "Popov and Hess (2015), Wetter and Popov (2014)"},
        {"mdr-layer",
         "method of dimensionality reduction of the elastic layer: springs coupled by the layer",
         "Popov and Hess (2015), Lebedev and Ufliand (1958)"},
        {"bem", "boundary elements on the elastic half-space, FFT convolution", of_grids},
        {"bem-layer", "boundary elements on the elastic layer, FFT convolution",
         of_grids + ", Sneddon (1951), " + of_coupling},
#ifdef TRICONTACT_WITH_FEM
        {"fem", "finite elements of the elastic layer, condensed to the contact patch",
         "Brezzi and Fortin (1991), " + of_coupling +
             ", Arndt et al. (2022), Chen, Davis, Hager and Rajamanickam (2008), Karypis and Kumar "
             "(1998), Geuzaine and Remacle (2009)"},
#endif
        {"atlas", "maps of earlier runs, in sweeps; tricontact predict reads them elsewhere",
         "Blatman and Sudret (2011)"},
    };
    return models;
}

std::unique_ptr<contact::Model> make_model(const std::string& name, const Case& c, int n_threads,
                                           [[maybe_unused]] const Say& say) {
    if (name == "mdr") return mdr::make_model(c);
    if (name == "mdr-layer") return mdr::make_layer_model(c);
    if (name == "bem") return bem::make_model(c, n_threads);
    if (name == "bem-layer") return bem::make_model(c, n_threads, bem::Body::layer);
#ifdef TRICONTACT_WITH_FEM
    if (name == "fem") return fem_entries().make_model(c, say);
#endif
    if (name == "atlas")
        throw contact::InputError(
            "models: atlas runs nothing: it holds what runs came to; take tricontact predict, or "
            "name another model");
    throw contact::InputError("models: this program was built without the model " + name);
}

MeshBlock block_of([[maybe_unused]] const Case& c, [[maybe_unused]] const Say& say) {
#ifdef TRICONTACT_WITH_FEM
    const meshes::LayerMeshSpec spec = fem_entries().mesh_spec(c, say);
    return {spec.size, 2 * spec.half_x, 2 * spec.half_y};
#else
    throw contact::InputError("models: this program was built without the model fem");
#endif
}

CoarserModel make_coarser_model(const std::string& name, const Case& c, double factor,
                                int n_threads, const Say& say) {
    CoarserModel coarser{.c = c, .model = {}};
    Case& to = coarser.c;
    if (name == "mdr-layer") {
        coarser.model = mdr::make_layer_model(c, mdr::usual_elements_per_radius, factor);
        return coarser;
    }
    if (name == "fem") {
        if (c.fem.mesh)
            throw contact::InputError("the mesh is a file's; run another one beside it");
        to.fem.size = factor * (c.fem.size ? *c.fem.size : block_of(c, silent).size);
        to.fem.accuracy.reset();
    }
    if (c.bem.spacing) *to.bem.spacing *= factor;
    if (c.bem.cells_per_radius) *to.bem.cells_per_radius /= factor;
    // Halves whose springs stand where the whole has some agree with it by accident.
    to.mdr.springs = std::max(static_cast<int>(c.mdr.springs / factor) - 1, 10);
    coarser.model = make_model(name, to, n_threads, say);
    return coarser;
}

std::optional<Case> with_wider_block(const Case& c, double factor, const Say& say) {
    const bool has_depth = !c.is_cylindrical();
    if (c.layer.width && (!has_depth || c.layer.depth)) return {};
    const MeshBlock block = block_of(c, say);
    Case wider = c;
    if (!c.layer.width) wider.layer.width = factor * block.width;
    if (has_depth && !c.layer.depth) wider.layer.depth = factor * block.depth;
    return wider;
}

void load_model([[maybe_unused]] const std::string& name) {
#ifdef TRICONTACT_WITH_FEM
    if (name == "fem") fem_entries();
#endif
}

}  // namespace tricontact::app
