#include "contact/prescribed_path.h"

#include <algorithm>
#include <cmath>

namespace tricontact::contact {

namespace {

/// `from + share (to - from)`, exact at both ends.
double interpolated(double from, double to, double share) {
    return share == 1 ? to : from + share * (to - from);
}

template <class Control>
Control interpolated(const Control& from, const Control& to, double share) {
    return {to.kind, interpolated(from.value, to.value, share)};
}

}  // namespace

bool PrescribedPath::loads_first_row() const {
    const Row& row = rows.front();
    return row.rotation != 0 || row.bulk_stress != 0 || row.tangential[0].value != 0 ||
           row.tangential[1].value != 0;
}

NormalControl PrescribedPath::hardest_normal() const {
    return std::ranges::max_element(rows, {}, [](const Row& row) { return row.normal.value; })
        ->normal;
}

Vector2 PrescribedPath::reach() const {
    Vector2 farthest{};
    for (const Row& row : rows)
        for (int d = 0; d < 2; ++d) farthest[d] = std::max(farthest[d], std::abs(row.offset[d]));
    return farthest;
}

bool PrescribedPath::is_along_x() const {
    return !twists() && !loads_across() && reach()[1] == 0;
}

double PrescribedPath::direction() const {
    const auto farthest =
        std::ranges::max_element(rows, {}, [](const Row& row) { return norm(row.offset); });
    const Vector2& v = farthest->offset;
    return v[1] == 0 ? 0 : std::atan2(v[1], v[0]);
}

bool PrescribedPath::twists() const {
    return std::ranges::any_of(rows, [](const Row& row) { return row.rotation != 0; });
}

bool PrescribedPath::has_bulk_stress() const {
    return std::ranges::any_of(rows, [](const Row& row) { return row.bulk_stress != 0; });
}

bool PrescribedPath::loads_across() const {
    return std::ranges::any_of(rows, [](const Row& row) { return row.tangential[1].value != 0; });
}

int PrescribedPath::n_steps() const {
    int n = 0;
    for (std::size_t k = 1; k < rows.size(); ++k) n += std::max(1, rows[k].steps);  // 0: at once
    return n;
}

PrescribedPath::Row PrescribedPath::between(const Row& from, const Row& to, double share) {
    Row row = to;
    row.time = interpolated(from.time, to.time, share);
    row.rotation = interpolated(from.rotation, to.rotation, share);
    row.bulk_stress = interpolated(from.bulk_stress, to.bulk_stress, share);
    row.normal = interpolated(from.normal, to.normal, share);
    for (int d = 0; d < 2; ++d) {
        row.offset[d] = interpolated(from.offset[d], to.offset[d], share);
        row.tangential[d] = interpolated(from.tangential[d], to.tangential[d], share);
    }
    return row;
}

}  // namespace tricontact::contact
