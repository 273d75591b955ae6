#pragma once

#include "contact/base/error.h"
#include "contact/model.h"

namespace tricontact::contact {

/// What `work` with the model comes to; begun again, from rest, on a larger grid as often as the
/// contact reaches the edge of the one that the model has. Throws what `work` and Model::enlarge()
/// throw.
template <typename Work>
auto on_large_enough_grid(Model& model, const Work& work) {
    for (;;) {
        try {
            return work();
        } catch (const ContactAtEdge& reached) {
            model.enlarge(reached);
        }
    }
}

}  // namespace tricontact::contact
