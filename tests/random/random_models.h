#pragma once

#include <memory>

#include "bem/model.h"
#include "contact/case.h"
#include "mdr/layer_model.h"
#include "mdr/model.h"

namespace tricontact::random_cases {

/// The only model of a case that was drawn.
inline std::unique_ptr<contact::Model> make_model(const contact::Case& c) {
    const std::string& name = c.models.front();
    if (name == "mdr") return mdr::make_model(c);
    if (name == "mdr-layer") return mdr::make_layer_model(c);
    return bem::make_model(c, 1, name == "bem" ? bem::Body::half_space : bem::Body::layer);
}

}  // namespace tricontact::random_cases
