#include "contact/case.h"
#include "contact/error.h"

namespace tricontact::contact {

std::unique_ptr<AxisymmetricIndenter> Case::make_axisymmetric_indenter() const {
    switch (indenter.shape) {
        case Shape::paraboloid:
            return std::make_unique<Paraboloid>(indenter.radius);
        case Shape::sphere:
            return std::make_unique<Sphere>(indenter.radius);
        default:
            throw InputError("indenter.shape: no body of revolution, which is what this needs");
    }
}

std::unique_ptr<Indenter> Case::make_indenter() const {
    return make_axisymmetric_indenter();
}

}  // namespace tricontact::contact
