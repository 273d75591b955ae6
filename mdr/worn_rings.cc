#include "mdr/worn_rings.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "contact/base/between_rows.h"
#include "contact/base/error.h"

namespace tricontact::mdr {

WornRings::WornRings(const std::string& model, contact::WearProblem problem, double friction)
    : problem_(std::move(problem)), friction_(friction) {
    if (problem_.presses())
        throw contact::InputError(
            "[wear]: " + model +
            " wears under a normal force or indentation that stays the same throughout the cycle; "
            "let it, or take bem");
    if (problem_.rolls())
        throw contact::InputError("[wear]: " + model +
                                  " wears along rings, and a body that rolls has none; omit the "
                                  "offsets, or take bem");
}

std::vector<double> WornRings::areas_of_hats(std::size_t n, double h) {
    using std::numbers::pi;
    std::vector<double> area;
    for (std::size_t j = 0; j < n; ++j) {
        const double rho = h * static_cast<double>(j);
        area.push_back(j == 0       ? pi * h * h / 3
                       : j + 1 == n ? pi * h * (rho - h / 3)
                                    : 2 * pi * h * rho);
    }
    return area;
}

contact::Surface WornRings::surface() const {
    const int n = static_cast<int>(radius_.size());
    contact::Surface s;
    s.layout = contact::Surface::Layout::line;
    s.n_x = 2 * n + 1;
    s.n_y = 1;
    s.spacing = {radius_.back() / n, 0};
    s.first = {-radius_.back(), 0};
    return s;
}

std::vector<double> WornRings::on_surface(const std::vector<double>& field) const {
    const contact::Surface s = surface();
    std::vector<double> shown;
    for (int i = 0; i < s.n_x; ++i) {
        const double r = std::min(std::abs(s.x(i)), radius_.back());
        shown.push_back(contact::between_rows(radius_, field, r));
    }
    return shown;
}

std::vector<std::size_t> WornRings::line() const {
    std::vector<std::size_t> all(radius_.size());
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
    return all;
}

}  // namespace tricontact::mdr
