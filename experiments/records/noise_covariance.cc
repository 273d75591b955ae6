#include "experiments/records/noise_covariance.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "contact/base/root.h"
#include "statistics/estimate.h"

namespace tricontact::experiments {

namespace {

constexpr std::size_t most_values = 20'000;  // of a longer stretch the last ones
constexpr int n_memories = 24;
constexpr std::array shares{.02, .05, .1, .2, .35, .5, .65, .8, .9, .95, .98, 1.};
constexpr int n_shares = static_cast<int>(shares.size());
constexpr double least_white = 1e-9;  // keeps the filter regular where the share is 1
constexpr double forgotten = 1e-3;    // of the variance: what lags are followed to

/// A share of the variance, and what of it is left after one sample.
struct NoiseKind {
    double share = 0, kept = 0;
};

/// How well the values fit a kind, and the variance that they then have.
struct Fitted {
    NoiseKind kind;
    double log_likelihood = 0, variance = 0;
    double variance_of_mean = 0;
};

/// Values, ones and times made independent by the filter: their inner products.
struct Products {
    double yy = 0, y1 = 0, yt = 0, one_one = 0, one_t = 0, tt = 0, log_determinant = 0;
};

Products filtered(const std::vector<double>& y, const NoiseKind& kind) {
    constexpr double rounding = 1e-15;
    Products p;
    const double white = std::max(1 - kind.share, least_white);
    double variance = kind.share;  // of the state before the sample is seen
    double weight = 0, log_innovation = 0, taken = 0, left = 0;
    bool at_rest = false;  // from where on the variance stays
    std::array<double, 3> state{};
    const double scale = 1 / static_cast<double>(y.size());
    for (std::size_t i = 0; i < y.size(); ++i) {
        if (!at_rest) {
            const double innovation = variance + white, gain = variance / innovation;
            weight = 1 / innovation;
            log_innovation = std::log(innovation);
            taken = kind.kept * gain;
            left = kind.kept * (1 - gain);
            const double next =
                kind.kept * left * variance + kind.share * (1 - kind.kept * kind.kept);
            at_rest = std::abs(next - variance) <= rounding * variance;
            variance = next;
        }
        const std::array<double, 3> seen{y[i], 1., static_cast<double>(i) * scale};
        std::array<double, 3> e{};
        for (std::size_t c = 0; c < 3; ++c) {
            e[c] = seen[c] - state[c];
            state[c] = left * state[c] + taken * seen[c];
        }
        p.log_determinant += log_innovation;
        const double y_weighted = weight * e[0], one_weighted = weight * e[1];
        p.yy += y_weighted * e[0];
        p.y1 += y_weighted * e[1];
        p.yt += y_weighted * e[2];
        p.one_one += one_weighted * e[1];
        p.one_t += one_weighted * e[2];
        p.tt += weight * e[2] * e[2];
    }
    return p;
}

/// Of the mean of n values of variance 1.
double variance_of_mean(const NoiseKind& kind, double n) {
    const double k = kind.kept;
    if (k == 0) return 1 / n;
    const double sum = n * (1 + k) / (1 - k) - 2 * k * (1 - std::pow(k, n)) / std::pow(1 - k, 2);
    return ((1 - kind.share) * n + kind.share * sum) / (n * n);
}

Fitted fitted(const std::vector<double>& y, const NoiseKind& kind) {
    const Products p = filtered(y, kind);
    const double determinant = p.one_one * p.tt - p.one_t * p.one_t;
    const double explained =
        (p.y1 * p.y1 * p.tt - 2 * p.y1 * p.yt * p.one_t + p.yt * p.yt * p.one_one) / determinant;
    const double left = std::max(p.yy - explained, 1e-12 * p.yy);
    const double freedom = static_cast<double>(y.size()) - 2;
    Fitted f{kind};
    f.log_likelihood = -(p.log_determinant + std::log(determinant) + freedom * std::log(left)) / 2;
    f.variance = left / (freedom - 2);  // mean of its distribution, scaled inverse chi squared
    f.variance_of_mean = f.variance * variance_of_mean(kind, static_cast<double>(y.size()));
    return f;
}

/// Places on the scales of memory and share, between which a kind may lie.
struct Range {
    double low = 0, high = 0;

    double at(int k, int n) const { return low + (high - low) * k / (n - 1); }
    double step(int n) const { return (high - low) / (n - 1); }
};
struct Box {
    Range memory{0, n_memories - 1}, share{0, n_shares - 1};

    double area() const { return (memory.high - memory.low) * (share.high - share.low); }
};

/// A kind of an even grid in a box.
struct Place {
    double memory = 0, share = 0;
};

NoiseKind kind_at(const Place& place, double n) {
    constexpr double shortest = .5;  // samples
    const double memory = shortest * std::pow(n / shortest, place.memory / (n_memories - 1.));
    const auto k = std::min(static_cast<std::size_t>(place.share), shares.size() - 2);
    const double part = place.share - static_cast<double>(k);
    return {shares[k] + part * (shares[k + 1] - shares[k]), std::exp(-1 / memory)};
}

/// Logarithms of the probabilities, but for a constant, in place of the likelihoods.
std::vector<Fitted> grid_in(const Box& box, const std::vector<double>& y,
                            std::vector<Place>& places) {
    const double each =
        std::log(box.memory.step(n_memories) * box.share.step(n_shares) / (n_memories * n_shares));
    std::vector<Fitted> all;
    places.clear();
    for (int m = 0; m < n_memories; ++m)
        for (int s = 0; s < n_shares; ++s) {
            places.push_back({box.memory.at(m, n_memories), box.share.at(s, n_shares)});
            all.push_back(fitted(y, kind_at(places.back(), static_cast<double>(y.size()))));
            all.back().log_likelihood += each;
        }
    return all;
}

double largest_likelihood(const std::vector<Fitted>& all) {
    return std::ranges::max_element(all, {}, &Fitted::log_likelihood)->log_likelihood;
}

/// The part of a box, and one step around it, where the kinds are not improbable.
Box probable_part(const Box& box, const std::vector<Fitted>& all,
                  const std::vector<Place>& places) {
    constexpr double improbable = 12;  // logarithm
    const double least = largest_likelihood(all) - improbable;
    Box part{{box.memory.high, box.memory.low}, {box.share.high, box.share.low}};
    const auto include = [](Range& range, double place, double step, const Range& whole) {
        range.low = std::min(range.low, std::max(place - step, whole.low));
        range.high = std::max(range.high, std::min(place + step, whole.high));
    };
    for (std::size_t k = 0; k < all.size(); ++k) {
        if (all[k].log_likelihood < least) continue;
        include(part.memory, places[k].memory, box.memory.step(n_memories), box.memory);
        include(part.share, places[k].share, box.share.step(n_shares), box.share);
    }
    return part;
}

/// All kinds with their probabilities in place of the logarithms. What a long stretch leaves
/// probable lies between the places of the first grid: they are set more densely there.
std::vector<Fitted> probabilities(const std::vector<double>& y) {
    constexpr int refinements = 3;
    constexpr double not_smaller = .6;
    Box box;
    std::vector<Place> places;
    std::vector<Fitted> all = grid_in(box, y, places);
    for (int k = 0; k < refinements; ++k) {
        const Box part = probable_part(box, all, places);
        if (part.area() > not_smaller * box.area()) break;
        box = part;
        all = grid_in(box, y, places);
    }
    all.push_back(fitted(y, {}));
    const double most = largest_likelihood(all);
    double sum = 0;
    for (Fitted& f : all) sum += f.log_likelihood = std::exp(f.log_likelihood - most);
    for (Fitted& f : all) f.log_likelihood /= sum;
    return all;
}

}  // namespace

double coverage_factor(const std::vector<PossibleError>& possible, double confidence) {
    constexpr double far = 10, impossible = 1e-18;
    constexpr int bits = 40;
    double high = 0;
    for (const PossibleError& error : possible) high = std::max(high, far * error.ratio);
    if (high == 0) return 0;
    const auto too_often = [&](double factor) {
        double beyond = 0;
        for (const auto& [ratio, probability] : possible)
            if (probability > impossible)
                beyond += probability * std::erfc(factor / (std::sqrt(2.) * ratio));
        return beyond - (1 - confidence);
    };
    return contact::bracketed_root(too_often, 0., high, bits);
}

NoiseCovariance noise_covariance(const std::vector<double>& values) {
    const auto n_used = static_cast<std::ptrdiff_t>(std::min(values.size(), most_values));
    const std::vector<double> y(values.end() - n_used, values.end());
    const double n = static_cast<double>(y.size());
    std::vector<Fitted> all = probabilities(y);
    std::ranges::sort(all, {}, &Fitted::variance_of_mean);
    auto middle = all.begin();
    for (double sum = middle->log_likelihood; sum < .5; sum += middle->log_likelihood) ++middle;
    NoiseCovariance result;
    result.by_lag = {middle->variance};
    double part = middle->variance * middle->kind.share;
    for (std::size_t lag = 1; lag < 2 * y.size() && part > forgotten * middle->variance; ++lag)
        result.by_lag.push_back(part *= middle->kind.kept);
    result.correlated_samples = std::max(1., middle->variance_of_mean * n / middle->variance);
    for (const Fitted& f : all)
        result.possible.push_back(
            {std::sqrt(f.variance_of_mean / middle->variance_of_mean), f.log_likelihood});
    const double factor = coverage_factor(result.possible, .95);
    int low = 1, high = std::max(1, static_cast<int>(n) - 2);
    while (low < high) {
        const int between = (low + high + 1) / 2;
        if (statistics::student_t(.95, between) >= factor)
            low = between;
        else
            high = between - 1;
    }
    result.degrees_of_freedom = low;
    return result;
}

}  // namespace tricontact::experiments
