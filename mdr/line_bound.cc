#include "mdr/line_bound.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "contact/compliances/wide_vectors.h"

namespace tricontact::mdr {

namespace {

constexpr int pieces = 512;             // of a table
constexpr int depths_per_octave = 512;  // of tables, between which bounds are linear in ln d
constexpr std::size_t most_tables = 2048;

double depth_of(int depth_class) {
    return std::exp2(static_cast<double>(depth_class) / depths_per_octave);
}

TRICONTACT_WIDEST_VECTORS
void sample_chords(const double* table, double first, double spacing, int n, double* out) {
#pragma omp simd
    for (int i = 0; i < n; ++i) {
        const double x = first + i * spacing;
        out[i] = contact::at_depth_of_chord(table, pieces, std::sqrt(std::max(1 - x * x, 0.)));
    }
}

}  // namespace

LineBound::LineBound(std::shared_ptr<const contact::FrictionLaw> law, double effective_modulus,
                     double effective_shear_modulus)
    : law_(std::move(law)),
      effective_modulus_(effective_modulus),
      effective_shear_modulus_(effective_shear_modulus),
      radial_(contact::RadialBound::of(pieces)) {}

const LineBound::Table& LineBound::table(const PlaneProfile& profile, int depth_class) {
    if (tables_.size() > most_tables) tables_.clear();
    Table& one = tables_[depth_class];
    if (!one.empty()) return one;
    const double a = profile.half_width(depth_of(depth_class));
    std::vector<double> pressure = radial_->pressure_under(
        [&](double x) { return profile.value(x); }, a, profile.tip_slope(a), effective_modulus_);
    one = radial_->line(contact::bounds_inside(*law_, std::move(pressure)), 1);
    for (double& bound : one) bound /= effective_shear_modulus_;
    return one;
}

void LineBound::press(const PlaneProfile& profile, double depth) {
    if (depth == depth_) return;
    depth_ = depth;
    half_width_ = profile.half_width(depth);
    const double position = std::log2(depth) * depths_per_octave, below = std::floor(position);
    const int depth_class = static_cast<int>(below);
    // A profile that ends at its rim has no table beyond it.
    const bool has_next = depth_of(depth_class + 1) <= profile.value(profile.range());
    const double part = has_next ? position - below : 0;
    const Table lower = table(profile, depth_class);
    const Table& upper = has_next ? table(profile, depth_class + 1) : lower;
    now_.resize(lower.size());
    for (std::size_t k = 0; k < now_.size(); ++k)
        now_[k] = half_width_ * ((1 - part) * lower[k] + part * upper[k]);
    largest_ = *std::max_element(now_.begin(), now_.end());
}

void LineBound::sample(double first, double spacing, std::span<double> bound) const {
    sample_chords(now_.data(), first / half_width_, spacing / half_width_,
                  static_cast<int>(bound.size()), bound.data());
}

}  // namespace tricontact::mdr
