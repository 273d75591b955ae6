#include "contact/model_makers.h"

#include <fmt/format.h>

#include "contact/base/error.h"
#include "contact/run.h"

namespace tricontact::contact {

std::optional<Case> ModelMakers::with_wider_block(const Case& c, double factor,
                                                  const Say& say) const {
    if (c.has_rigid_substrate) return {};  // a plane without sides
    const bool has_depth = !c.is_cylindrical();
    if (c.layer.width && (!has_depth || c.layer.depth)) return {};
    const MeshBlock block = block_of(c, say);
    Case wider = c;
    if (!c.layer.width) wider.layer.width = factor * block.width;
    if (has_depth && !c.layer.depth) wider.layer.depth = factor * block.depth;
    return wider;
}

void require_sound(const Audit& audit, const std::string& name) {
    for (const auto& check : audit.checks())
        if (!check.passed())
            throw NotConverged(fmt::format("{}: {} is {:.2e}, allowed {:.1e}", name, check.name,
                                           check.worst, check.allowed));
}

std::unique_ptr<Model> ModelRunner::make(const std::string& name, const Case& c) const {
    return makers_->make(name, c, n_threads_, silent);
}

History ModelRunner::history_of(const std::string& name, const Case& c) const {
    const auto model = make(name, c);
    History history = run(c, *model);
    require_sound(history.audit, name);
    return history;
}

History ModelRunner::history_of_coarser(const std::string& name, const Case& c) const {
    const CoarserModel coarser = makers_->make_coarser(name, c, 2, n_threads_, silent);
    History history = run(coarser.c, *coarser.model);
    require_sound(history.audit, name);
    return history;
}

}  // namespace tricontact::contact
