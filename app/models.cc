#include "app/models.h"

#include "bem/model.h"
#include "mdr/layer_model.h"
#include "mdr/model.h"
#ifdef TRICONTACT_WITH_FEM
#include "app/fem_entries.h"
#endif

namespace tricontact::app {

const std::vector<ModelDescription>& known_models() {
    static const std::vector<ModelDescription> models = {
        {"mdr",
         "method of dimensionality reduction: a bed of independent springs, stepped exactly"},
        {"mdr-layer",
         "method of dimensionality reduction of the elastic layer: springs coupled by the layer"},
        {"bem", "boundary elements on the elastic half-space, FFT convolution"},
        {"bem-layer", "boundary elements on the elastic layer, FFT convolution"},
#ifdef TRICONTACT_WITH_FEM
        {"fem", "finite elements of the elastic layer, condensed to the contact patch"},
#endif
        {"atlas", "maps of earlier runs, in sweeps; tricontact predict reads them elsewhere"},
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
            "models: atlas runs nothing: it knows what runs came to; take tricontact predict, or "
            "name another model");
    throw contact::InputError("models: this program was built without the model " + name);
}

void load_model([[maybe_unused]] const std::string& name) {
#ifdef TRICONTACT_WITH_FEM
    if (name == "fem") fem_entries();
#endif
}

}  // namespace tricontact::app
