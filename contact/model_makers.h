#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "contact/case.h"
#include "contact/history.h"
#include "contact/model.h"

namespace tricontact::contact {

/// Receives a line about what a model decided or reused.
using Say = std::function<void(const std::string&)>;
inline const Say silent = [](const std::string&) {};

/// A model on cells, elements and springs of a multiple of the size of its own, those that the case
/// leaves to the model included.
struct CoarserModel {
    Case c;  ///< what says so, as far as there are keys
    std::unique_ptr<Model> model;
};

/// Element in the contact patch and sides of the block of the mesh that fem makes of a case [m].
struct MeshBlock {
    double size, width, depth;
};

/// The models that a program was built with. Rooms that may not know any of them are handed this.
struct ModelMakers {
    /// Whether the program was built with a model.
    std::function<bool(std::string_view name)> has;
    /// Case -> model. Throws InputError where the program has no such model.
    std::function<std::unique_ptr<Model>(const std::string& name, const Case& c, int n_threads,
                                         const Say& say)>
        make;
    /// The same on a mesh coarser by `factor`. Throws InputError, also where there is no coarser
    /// mesh: of a file, of mdr-layer where its elements are as long as the layer's thickness
    /// allows.
    std::function<CoarserModel(const std::string& name, const Case& c, double factor, int n_threads,
                               const Say& say)>
        make_coarser;
    /// Throws InputError where the program was built without fem.
    std::function<MeshBlock(const Case& c, const Say& say)> block_of;
    /// Loads the code of a model, if it is kept apart: processes that are forked afterwards share
    /// it. Throws std::runtime_error if it is not where it was installed.
    std::function<void(const std::string& name)> load;
    /// What the model's solver leaves of a result at most [-], in error bars.
    std::function<double(const std::string& name, const Case& c)> solver_tolerance;

    /// Of fem without a mesh file: its block with sides `factor` times as far apart where the case
    /// leaves that to the model. Empty where no side is the model's choice.
    std::optional<Case> with_wider_block(const Case& c, double factor, const Say& say) const;
};

/// Throws NotConverged if a check of the audit of the model called `name` failed.
void require_sound(const Audit& audit, const std::string& name);

/// Those models at work, on so many threads, silently. The makers outlive it.
class ModelRunner {
  public:
    ModelRunner(const ModelMakers& makers, int n_threads)
        : makers_(&makers), n_threads_(n_threads) {}

    std::unique_ptr<Model> make(const std::string& name, const Case& c) const;
    /// The history of one model, sound by its audit, without any files. Throws InputError,
    /// NotConverged.
    History history_of(const std::string& name, const Case& c) const;
    /// The same on cells, elements and springs of twice the size.
    History history_of_coarser(const std::string& name, const Case& c) const;

  private:
    const ModelMakers* makers_;
    int n_threads_;
};

}  // namespace tricontact::contact
