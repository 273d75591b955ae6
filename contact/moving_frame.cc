#include "contact/moving_frame.h"

#include <algorithm>

namespace tricontact::contact {

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
