#include "bem/model.h"

#include "contact/relaxing_case.h"
#include "contact/surface_model.h"

namespace tricontact::bem {

std::unique_ptr<contact::Substrate> make_substrate(const contact::Case& c, int n_threads, Body body,
                                                   double rolled_aside) {
    auto relaxed = case_compliance(c, n_threads, body, rolled_aside);
    const contact::ContactPoints grid = relaxed->points();
    return contact::make_substrate(body == Body::layer ? c : contact::without_layer(c),
                                   std::move(relaxed), [&](const contact::Case& elastic) {
                                       return case_compliance_on(elastic, grid, n_threads, body);
                                   });
}

std::unique_ptr<contact::Model> make_model(const contact::Case& c, int n_threads, Body body) {
    return std::make_unique<contact::SurfaceModel>(
        body == Body::layer ? "bem-layer" : "bem", *make_substrate(c, n_threads, body),
        c.make_indenter(), c.friction_coefficient, c.bem.tolerance, c.contact);
}

}  // namespace tricontact::bem
