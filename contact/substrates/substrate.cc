#include "contact/substrates/substrate.h"

#include <algorithm>
#include <cmath>

#include "contact/base/compensated_sum.h"
#include "contact/base/error.h"
#include "contact/compliances/blocks.h"

namespace tricontact::contact {

void Substrate::advect() {
    for (SurfaceField* field : memory()) contact::advect(compliance().points(), *field);
}

ElasticSubstrate::ElasticSubstrate(std::shared_ptr<const Compliance> compliance)
    : compliance_(std::move(compliance)) {}

bool ElasticSubstrate::begin(double, const SurfaceField& t, const SurfaceField& u) {
    traction_ = &t;
    displacement_ = &u;
    return false;
}

Substrate::Energies ElasticSubstrate::end(const SurfaceField& t, const SurfaceField& u) {
    const auto& area = compliance_->points().area;
    const Blocks points(area.size(), compliance_->n_threads());
    std::vector<Energies> parts((area.size() + summed_block - 1) / summed_block);
    CompensatedSum all_stored, all_work, all_magnitude;
    for (int d = 0; d < 3; ++d) {
        const double *const t0 = components(*traction_)[d]->data(),
                            *const u0 = components(*displacement_)[d]->data(),
                            *const t1 = components(t)[d]->data(),
                            *const u1 = components(u)[d]->data();
        points.for_each([&](std::size_t, std::size_t first, std::size_t last) {
            for_each_block(static_cast<int>(first), static_cast<int>(last),
                           [&](int begin, int end) {
                               double stored = 0, work = 0, magnitude = 0;
                               for (int i = begin; i < end; ++i) {
                                   stored += area[i] / 2 * t1[i] * u1[i];
                                   work += area[i] / 2 * (t0[i] + t1[i]) * (u1[i] - u0[i]);
                                   magnitude += area[i] / 2 * (std::abs(t0[i]) + std::abs(t1[i])) *
                                                (std::abs(u0[i]) + std::abs(u1[i]));
                               }
                               parts[begin / summed_block] = {
                                   .stored = stored, .work = work, .magnitude = magnitude};
                           });
        });
        for (const Energies& part : parts) {
            all_stored.add(part.stored);
            all_work.add(part.work);
            all_magnitude.add(part.magnitude);
        }
    }
    return {.stored = all_stored.value(),
            .dissipated = 0,
            .work = all_work.value(),
            .magnitude = all_magnitude.value()};
}

void check_rolls_on(const std::string& model, const ContactPoints& points) {
    if (points.n_x == 0 || points.mirrored || points.periodic)
        throw InputError(model +
                         ": rolling on needs a regular grid on both sides of the path that is not "
                         "periodic; take a model of boundary elements");
}

void advect(const ContactPoints& grid, std::vector<double>& field) {
    for (int j = 0; j < grid.n_y; ++j) {
        const auto row = field.begin() + static_cast<std::ptrdiff_t>(j) * grid.n_x;
        std::copy(row + 1, row + grid.n_x, row);
    }
}

void advect(const ContactPoints& grid, SurfaceField& field) {
    for (auto* component : components(field)) advect(grid, *component);
}

}  // namespace tricontact::contact
