#include "contact/solvers/moving_frame.h"

#include <algorithm>

#include "contact/error.h"

namespace tricontact::contact {

void check_rolls_on(const std::string& model, const ContactPoints& points) {
    if (points.n_x == 0 || points.mirrored || points.periodic)
        throw InputError(model +
                         ": rolling on needs a regular grid on both sides of the path that is not "
                         "periodic; take a model of boundary elements");
}

void carry(const ContactPoints& grid, std::vector<double>& field) {
    for (int j = 0; j < grid.n_y; ++j) {
        const auto row = field.begin() + static_cast<std::ptrdiff_t>(j) * grid.n_x;
        std::copy(row + 1, row + grid.n_x, row);
    }
}

void carry(const ContactPoints& grid, SurfaceField& field) {
    for (auto* component : components(field)) carry(grid, *component);
}

}  // namespace tricontact::contact
