#include "app/models.h"

#include "bem/model.h"
#include "contact/error.h"
#include "mdr/model.h"

namespace tricontact::app {

const std::vector<ModelDescription>& known_models() {
    static const std::vector<ModelDescription> models = {
        {"mdr",
         "method of dimensionality reduction: a bed of independent springs, stepped exactly"},
        {"bem", "boundary elements on the elastic half-space, FFT convolution"}};
    return models;
}

std::unique_ptr<contact::Model> make_model(const std::string& name, const contact::Case& c,
                                           int n_threads) {
    if (name == "mdr") return mdr::make_model(c);
    if (name == "bem") return bem::make_model(c, n_threads);
    throw contact::InputError("models: there is no model " + name);
}

}  // namespace tricontact::app
