#include "mdr/load_bound.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "contact/compliances/wide_vectors.h"

namespace tricontact::mdr {

namespace {

// Of tables. Those of loads that lean ask the law for each pair of a chord and a radius.
constexpr int even_pieces = 256, leaning_pieces = 64;  // even numbers
constexpr double nearly_nothing = 1e-12;  // of the largest pressure: pressed all the same

/// Loads between the points of a row, about the middle of the loaded ones.
class LoadAboutMiddle {
  public:
    LoadAboutMiddle(const PointRow& row, std::span<const double> load, double tip_slope)
        : row_(row), load_(load), span_(load_span(load)), tip_slope_(tip_slope) {
        middle_ = (row.position(span_.first) + row.position(span_.last)) / 2;
        for (int pass = 0; pass < 2; ++pass) {
            const auto [before, beyond] = load_ends(row, load, middle_);
            middle_ += (beyond - before) / 2;
            half_width_ = (before + beyond) / 2;
        }
    }
    double middle() const { return middle_; }
    double half_width() const { return half_width_; }
    const LoadSpan& span() const { return span_; }
    /// At the distance r from the middle the mean of both sides; what one side carries of it.
    double even(double r) const { return (at(middle_ - r) + at(middle_ + r)) / 2; }
    double share(double x) const {
        const double mean = even(std::abs(x));
        return mean > 0 ? std::max(at(middle_ + x) / mean, 0.) : 1;
    }

    /// Cubic between four points, linear in the squared distance from the middle beside the ends:
    /// what is left of q without its tip is even and smooth there.
    double at(double x) const {
        const int i = static_cast<int>(std::floor((x - row_.first) / row_.spacing));
        const double squared = square(x);
        if (i < span_.first) return to_end(squared, span_.first);
        if (i >= span_.last) return to_end(squared, span_.last);
        const double t = (x - row_.position(i)) / row_.spacing;
        if (i == span_.first || i + 1 == span_.last) {
            const double from = square(row_.position(i)), to = square(row_.position(i + 1));
            // Around the middle of a few points both may be as far from it.
            const double part = std::abs(to - from) > row_.spacing * row_.spacing
                                    ? (squared - from) / (to - from)
                                    : t;
            return load_[i] + part * (load_[i + 1] - load_[i]);
        }
        const double sum = -t * (t - 1) * (t - 2) / 6 * smooth(i - 1) +
                           (t + 1) * (t - 1) * (t - 2) / 2 * smooth(i) -
                           (t + 1) * t * (t - 2) / 2 * smooth(i + 1) +
                           (t + 1) * t * (t - 1) / 6 * smooth(i + 2);
        return sum - tip_slope_ * std::abs(x - middle_);
    }

  private:
    double square(double x) const { return (x - middle_) * (x - middle_); }
    double smooth(int i) const {
        return load_[i] + tip_slope_ * std::abs(row_.position(i) - middle_);
    }
    double to_end(double squared, int last) const {
        const double end = half_width_ * half_width_;
        return load_[last] *
               std::clamp((end - squared) / (end - square(row_.position(last))), 0., 1.);
    }

    PointRow row_;
    std::span<const double> load_;
    LoadSpan span_;
    double tip_slope_, middle_, half_width_ = 0;
};

/// The load at the mirror image about `middle` of each point of the span, linear between points.
std::vector<double> mirror_image(const PointRow& row, std::span<const double> load,
                                 const LoadSpan& span, double middle) {
    // The image of point i lies between the points whole - i and whole - i + 1.
    const double turned = (middle - row.first) / row.spacing * 2;
    const int whole = static_cast<int>(std::floor(turned));
    const double part = turned - whole;
    std::vector<double> image(span.last - span.first + 1, 0.);
    const double* const q = load.data();
    double* const out = image.data() - span.first;
    const int first = std::max(span.first, whole + 1 - span.last);
    const int last = std::min(span.last, whole - span.first);
#pragma omp simd
    for (int i = first; i <= last; ++i)
        out[i] = (1 - part) * q[whole - i] + part * q[whole - i + 1];
    if (first - 1 >= span.first && whole - first + 1 <= span.last)
        out[first - 1] = (1 - part) * q[whole - first + 1];
    if (last + 1 <= span.last && whole - last >= span.first) out[last + 1] = part * q[whole - last];
    return image;
}

/// Where the chords of equally spaced points lie, over the half width, and a table of them all.
struct Chords {
    double from, step;
    int pieces;
    const double* even;
};

TRICONTACT_WIDEST_VECTORS
void even_bounds(const Chords& at, double a, int count, const double* q, double* out) {
    const Chords c = at;
#pragma omp simd
    for (int i = 0; i < count; ++i) {
        const double x = c.from + i * c.step;
        const double y = std::sqrt(std::max(1 - x * x, 0.));
        out[i] = q[i] > 0 ? a * contact::at_depth_of_chord(c.even, c.pieces, y) : 0.;
    }
}

/// Each point leans by what its load q is over that of its image.
TRICONTACT_WIDEST_VECTORS
void leaning_bounds(const Chords& at, double a, const double* factor, int first, int end,
                    const double* q, const double* image, double* out) {
    const Chords c = at;
#pragma omp simd
    for (int i = first; i < end; ++i) {
        const double x = c.from + i * c.step;
        const double y = std::sqrt(std::max(1 - x * x, 0.));
        const double lean = (q[i] - image[i]) / (q[i] + image[i]);
        const double bound = a * contact::at_depth_of_chord(c.even, c.pieces, y) *
                             (1 + lean * contact::at_depth_of_chord(factor, c.pieces, y));
        out[i] = q[i] > 0 ? bound : 0.;
    }
}

}  // namespace

LoadBound::LoadBound(std::shared_ptr<const contact::FrictionLaw> law, bool may_lean,
                     double tip_slope)
    : law_(std::move(law)),
      may_lean_(may_lean),
      tip_slope_(tip_slope),
      radial_(contact::RadialBound::of(may_lean ? leaning_pieces : even_pieces)) {}

/// Over the half width [Pa].
std::vector<double> LoadBound::even_bound(std::span<const double> pressure) const {
    std::vector<double> bound(pressure.size());
    law_->bounds({pressure}, bound);
    return radial_->line(bound, 1);
}

/// How bounds of chords follow from the shares s that they carry, b = b_even (1 + m (s - 1)): m of
/// each. The law is asked at those shares of every other chord; where s is 1, beside it.
std::vector<double> LoadBound::lean_factors(std::span<const double> pressure,
                                            std::span<const double> even_bound,
                                            std::span<const double> share) const {
    constexpr double beside = 1e-3;
    std::vector<double> factor(pressure.size()), on_chord(pressure.size()), bound(pressure.size());
    const std::size_t n = pressure.size() - 1;
    for (std::size_t k = 2; k <= n; k += 2) {
        const double s = std::abs(share[k] - 1) > beside ? share[k] : 1 + beside;
        for (std::size_t j = 0; j <= k; ++j) on_chord[j] = s * pressure[j];
        law_->bounds({std::span<const double>(on_chord).first(k + 1)},
                     std::span(bound).first(k + 1));
        const double line = radial_->line_at(static_cast<int>(k), bound.data());
        factor[k] = (line / even_bound[k] - 1) / (s - 1);
    }
    factor[0] = factor[2];
    for (std::size_t k = 1; k < n; k += 2) factor[k] = (factor[k - 1] + factor[k + 1]) / 2;
    return factor;
}

void LoadBound::bounds(const PointRow& row, std::span<const double> load,
                       std::span<double> bound) const {
    std::fill(bound.begin(), bound.end(), 0);
    if (load_span(load).last < 0) return;
    const LoadAboutMiddle about(row, load, tip_slope_);
    const double a = about.half_width();
    const int n = radial_->pieces();
    std::vector<double> hollow(n + 1);
    std::array<std::vector<double>, 2> shares{std::vector<double>(n + 1, 1.),
                                              std::vector<double>(n + 1, 1.)};
    for (int k = 1; k <= n; ++k) {
        const double r = a * radial_->radius(k);
        hollow[k] = -about.even(r);
        for (int side : {0, 1}) shares[side][k] = about.share(side == 0 ? -r : r);
    }
    std::vector<double> pressure = radial_->pressure(std::move(hollow), a, tip_slope_);
    const double least = nearly_nothing * *std::ranges::max_element(pressure);
    for (double& p : pressure) p = std::max(p, least);

    const std::vector<double> line = even_bound(pressure);
    const LoadSpan& span = about.span();
    const double from = (row.position(span.first) - about.middle()) / a, step = row.spacing / a;
    const Chords chords{.from = from, .step = step, .pieces = n, .even = line.data()};
    if (!may_lean_) {
        const int count = span.last - span.first + 1;
        even_bounds(chords, a, count, load.data() + span.first, bound.data() + span.first);
        return;
    }
    const std::vector<double> mirrored = mirror_image(row, load, span, about.middle());
    const int n_before =
        std::clamp(static_cast<int>(std::ceil((about.middle() - row.first) / row.spacing)),
                   span.first, span.last + 1) -
        span.first;
    for (int side : {0, 1}) {
        const std::vector<double> factors = lean_factors(pressure, line, shares[side]);
        leaning_bounds(chords, a, factors.data(), side == 0 ? 0 : n_before,
                       side == 0 ? n_before : static_cast<int>(mirrored.size()),
                       load.data() + span.first, mirrored.data(), bound.data() + span.first);
    }
}

}  // namespace tricontact::mdr
