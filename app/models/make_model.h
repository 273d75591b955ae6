#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "contact/model.h"
#include "contact/models/model_kind.h"
#include "runs/options.h"

namespace tricontact::app {

/// Of the models that a case file may name, those that this program was built with.
std::vector<contact::ModelKind> known_models();
bool has_model(std::string_view name);

/// Case -> model, the only place that knows all of them. `name` is one of known_models().
std::unique_ptr<contact::Model> make_model(const std::string& name, const Case& c, int n_threads,
                                           const Say& say);

/// What the model's solver leaves of a result at most [-], in error bars.
double solver_tolerance(const std::string& name, const Case& c);

/// The same on cells, elements and springs of `factor` > 1 times the size of the model's own, those
/// that the case leaves to the model included.
struct CoarserModel {
    Case c;  ///< what says so, as far as there are keys
    std::unique_ptr<contact::Model> model;
};
/// Throws InputError, also where there is no coarser mesh: of a file, of mdr-layer where its
/// elements are as long as the layer's thickness allows.
CoarserModel make_coarser_model(const std::string& name, const Case& c, double factor,
                                int n_threads, const Say& say);

/// Element in the contact patch and sides of the block of the mesh that fem makes of a case [m].
struct MeshBlock {
    double size, width, depth;
};
/// Throws InputError where this program was built without fem.
MeshBlock block_of(const Case& c, const Say& say);

/// Of fem without a mesh file: its block with sides `factor` times as far apart where the case
/// leaves that to the model. Empty where no side is the model's choice.
std::optional<Case> with_wider_block(const Case& c, double factor, const Say& say);

/// Loads the code of a model, if it is kept apart: processes that are forked afterwards share it.
/// Throws std::runtime_error if it is not where it was installed.
void load_model(const std::string& name);

}  // namespace tricontact::app
