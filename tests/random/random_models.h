#pragma once

#include <memory>

#include "bem/model.h"
#include "contact/case.h"
#include "mdr/layer_model.h"
#include "mdr/model.h"
#ifdef TRICONTACT_WITH_FEM
#include "fem/case/model.h"
#endif

namespace tricontact::random_cases {

/// The only model of a case that was drawn.
inline std::unique_ptr<contact::Model> make_model(const contact::Case& c) {
    const std::string& name = c.models.front();
    if (name == "mdr") return mdr::make_model(c);
    if (name == "mdr-layer") return mdr::make_layer_model(c);
#ifdef TRICONTACT_WITH_FEM
    if (name == "fem") return fem::make_model(c, {});
#endif
    return bem::make_model(c, 1, name == "bem" ? bem::Body::half_space : bem::Body::layer);
}

}  // namespace tricontact::random_cases
