#include "bem/model.h"

#include "contact/substrates/relaxing_case.h"
#include "contact/surface_model.h"

namespace tricontact::bem {

std::unique_ptr<contact::Substrate> make_substrate(const contact::Case& c, int n_threads, Body body,
                                                   double aside) {
    auto relaxed = case_compliance(c, n_threads, body, aside);
    const contact::ContactPoints grid = relaxed->points();
    return contact::make_substrate(body == Body::layer ? c : contact::without_layer(c),
                                   std::move(relaxed), [&](const contact::Case& elastic) {
                                       return case_compliance_on(elastic, grid, n_threads, body);
                                   });
}

std::unique_ptr<contact::Model> make_model(const contact::Case& c, int n_threads, Body body) {
    auto model = std::make_unique<contact::SurfaceModel>(
        body == Body::layer ? "bem-layer" : "bem", *make_substrate(c, n_threads, body),
        c.make_indenter(), c.friction_coefficient, c.bem.tolerance, c.contact);
    model->set_larger_grid([=, aside = 0.](const contact::ContactAtEdge& reached) mutable {
        aside = more_room(aside, reached);
        return make_substrate(c, n_threads, body, aside);
    });
    return model;
}

}  // namespace tricontact::bem
