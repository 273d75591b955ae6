#include "bem/model.h"

#include "contact/surface_model.h"

namespace tricontact::bem {

std::unique_ptr<contact::Model> make_model(const contact::Case& c, int n_threads, Body body) {
    return std::make_unique<contact::SurfaceModel>(
        body == Body::layer ? "bem-layer" : "bem", case_compliance(c, n_threads, body),
        c.make_indenter(), c.friction_coefficient, c.bem.tolerance, c.contact, c.relaxation);
}

}  // namespace tricontact::bem
