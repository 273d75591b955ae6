#include "experiments/identification/adhesion/maugis_curve.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "contact/base/root.h"

namespace tricontact::experiments {

using std::numbers::pi;
using theory::MaugisContact;

namespace {

constexpr double least_radius = .02;  // A, where rigid bodies pull off as they meet at a point
constexpr double of_neighbours = 1.02;

}  // namespace

MaugisCurve::MaugisCurve(double radius, double modulus, double work, double range)
    : lambda_(theory::maugis_parameter(radius, work, modulus, work / range)) {
    const double k = 4. / 3 * modulus;
    unit_force_ = pi * work * radius;
    unit_radius_ = std::cbrt(pi * work * radius * radius / k);
    unit_depth_ = unit_radius_ * unit_radius_ / radius;
    MaugisContact first = theory::maugis_pull_off(lambda_);
    if (first.radius < least_radius) first = theory::maugis_contact(lambda_, least_radius);
    nodes_.push_back(first);
}

double MaugisCurve::range_of(double lambda, double radius, double modulus, double work) {
    return work / (lambda / theory::maugis_parameter(radius, work, modulus, 1));
}

MaugisContact MaugisCurve::at(double MaugisContact::*control, double value) {
    if (value <= nodes_.front().*control) return nodes_.front();
    while (nodes_.back().*control < value)
        nodes_.push_back(theory::maugis_contact(lambda_, of_neighbours * nodes_.back().radius));
    const auto above = std::ranges::lower_bound(nodes_, value, {}, control);
    const auto below = above - 1;
    const auto excess = [&](double a) {
        return theory::maugis_contact(lambda_, a).*control - value;
    };
    return theory::maugis_contact(
        lambda_, contact::bracketed_root(excess, below->radius, above->radius,
                                         (*below).*control - value, (*above).*control - value, 30));
}

double MaugisCurve::force_at(double indentation) {
    return at(&MaugisContact::indentation, indentation / unit_depth_).force * unit_force_;
}

double MaugisCurve::radius_under(double force) {
    return at(&MaugisContact::force, force / unit_force_).radius * unit_radius_;
}

}  // namespace tricontact::experiments
