#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/options.h"
#include "contact/model.h"

namespace tricontact::app {

struct ModelDescription {
    std::string name;
    std::string text;
    std::string sources;  ///< publications, cited by authors and year
};
/// The models a case file may name.
const std::vector<ModelDescription>& known_models();

/// Case -> model, the only place that knows all of them. `name` is one of known_models().
std::unique_ptr<contact::Model> make_model(const std::string& name, const Case& c, int n_threads,
                                           const Say& say);

/// Loads the code of a model, if it is kept apart: processes that are forked afterwards share it.
/// Throws std::runtime_error if it is not where it was installed.
void load_model(const std::string& name);

}  // namespace tricontact::app
