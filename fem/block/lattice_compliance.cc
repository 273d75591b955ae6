#include "fem/block/lattice_compliance.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "fem/block/surface_symbol.h"

// The grid of points is a lattice of elements with four kinds of nodes each; a field over the
// points is four fields over the elements. Of a mirrored patch both halves are laid down: x and z
// components are even in y, y components odd.

namespace tricontact::fem {

namespace {

using contact::ContactPoints;
using contact::TangentialField;

// Distance [thicknesses] after which the patch comes again: images are felt by what a bonded layer
// carries that far, a per cent of what it does nearby.
constexpr double images_away = 2.5;

int good_size(double least) {
    for (int n = 2 * static_cast<int>(std::ceil(least / 2));; n += 2) {
        int rest = n;
        for (const int prime : {2, 3, 5})
            while (rest % prime == 0) rest /= prime;
        if (rest == 1) return n;
    }
}

double thickness(const BlockGrid& grid) {
    return grid.axes[2].planes.back() - grid.axes[2].planes.front();
}

int period_of(const BlockGrid& grid, double spacing, int n_nodes) {
    return good_size((n_nodes + 1) / 2 + images_away * thickness(grid) / (2 * spacing));
}

int rows_of(const ContactPoints& points) {
    return points.mirrored ? 2 * points.n_y - 1 : points.n_y;
}

const std::vector<int> normal_only{2}, along_only{0, 1};

}  // namespace

double LatticeCompliance::bytes(const BlockGrid& grid, const ContactPoints& points) {
    const double n_x = period_of(grid, points.spacing[0], points.n_x),
                 n_y = period_of(grid, points.spacing[1], rows_of(points));
    return n_x * n_y * (8 * n_fields + 16 * n_fields + 8 * (144. + 64));
}

LatticeCompliance::LatticeCompliance(const BlockGrid& grid, ContactPoints points, int n_threads)
    : points_(std::move(points)),
      n_threads_(n_threads),
      n_x_(period_of(grid, points_.spacing[0], points_.n_x)),
      n_y_(period_of(grid, points_.spacing[1], rows_of(points_))) {
    const std::size_t n = static_cast<std::size_t>(n_x_) * n_y_,
                      n_waves = static_cast<std::size_t>(n_x_ / 2 + 1) * n_y_;
    real_ = contact::fftw_zeros<contact::FftwReal>(n * n_fields);
    spectrum_ = contact::fftw_zeros<contact::FftwComplex>(n_waves * n_fields);
    product_ = contact::fftw_zeros<contact::FftwComplex>(n_waves * n_fields);
    forward_.reset(fftw_plan_dft_r2c_2d(n_y_, n_x_, real_.get(), spectrum_.get(),
                                        FFTW_ESTIMATE | FFTW_UNALIGNED));
    backward_.reset(fftw_plan_dft_c2r_2d(n_y_, n_x_, product_.get(), real_.get(),
                                         FFTW_ESTIMATE | FFTW_UNALIGNED));
    find_symbols(grid);
}

void LatticeCompliance::find_symbols(const BlockGrid& grid) {
    const double edge_x = 2 * points_.spacing[0], edge_y = 2 * points_.spacing[1];
    const SurfaceSymbol symbol(grid, edge_x, edge_y);
    const int n_half = n_x_ / 2 + 1;
    const std::size_t n_waves = static_cast<std::size_t>(n_half) * n_y_;
    compliance_.resize(n_waves * n_fields * n_fields);
    along_inverse_.resize(n_waves * 64);
    // What slides freely as a whole is held by a body as wide as the period.
    const double wave = 2 * std::numbers::pi / (n_x_ * edge_x);
    const double drift =
        grid.moduli.front().shear * thickness(grid) * wave * wave * edge_x * edge_y / n_kinds;
    std::vector<double> own(n_waves);
#pragma omp parallel for num_threads(n_threads_) schedule(dynamic, 64) if (n_threads_ > 1)
    for (std::size_t w = 0; w < n_waves; ++w) {
        const int m_x = static_cast<int>(w % n_half), m_y = static_cast<int>(w / n_half);
        const auto matrix =
            symbol.compliance(2 * std::numbers::pi * m_x / n_x_, 2 * std::numbers::pi * m_y / n_y_,
                              w == 0 ? drift : 0);
        std::ranges::copy(matrix, compliance_.begin() + w * matrix.size());
        Eigen::Matrix<Complex, 8, 8> along;
        for (int c = 0; c < 8; ++c)
            for (int r = 0; r < 8; ++r)
                along(r, c) = matrix[(c / 2 * 3 + c % 2) * n_fields + r / 2 * 3 + r % 2];
        const Eigen::Matrix<Complex, 8, 8> inverse =
            along.ldlt().solve(Eigen::Matrix<Complex, 8, 8>::Identity());
        std::copy_n(inverse.data(), 64, along_inverse_.begin() + w * 64);
        const bool twice = m_x > 0 && 2 * m_x != n_x_;
        for (int f = 0; f < n_fields; ++f)
            if (f % 3 < 2) own[w] += (twice ? 2 : 1) * matrix[f * n_fields + f].real();
    }
    double sum = 0;
    for (const double part : own) sum += part;
    const double mean_area = points_.spacing[0] * points_.spacing[1];
    local_tangential_ = mean_area * sum / (8. * n_x_ * n_y_);
}

/// Of the field of the kind of this point, in units of the period's elements.
std::size_t LatticeCompliance::place(int i, int j) const {
    const int kind = i % 2 + 2 * (j % 2);
    return (static_cast<std::size_t>(3 * kind) * n_y_ + j / 2) * n_x_ + i / 2;
}

void LatticeCompliance::spread(int direction, std::span<const double> values,
                               bool times_area) const {
    const std::size_t n = static_cast<std::size_t>(n_x_) * n_y_;
    for (int kind = 0; kind < n_kinds; ++kind)
        std::fill_n(real_.get() + (3 * kind + direction) * n, n, 0.);
    const int middle = points_.mirrored ? points_.n_y - 1 : 0;
    const double odd = direction == 1 ? -1 : 1;
    for (int j = 0; j < points_.n_y; ++j)
        for (int i = 0; i < points_.n_x; ++i) {
            const std::size_t k = static_cast<std::size_t>(j) * points_.n_x + i;
            const bool both = points_.mirrored && j > 0;
            const double value =
                times_area ? values[k] * points_.area[k] / (both ? 2 : 1) : values[k];
            if (points_.mirrored && j == 0 && direction == 1) continue;
            real_[place(i, middle + j) + direction * n] = value;
            if (both) real_[place(i, middle - j) + direction * n] = odd * value;
        }
}

void LatticeCompliance::gather(int direction, std::span<double> values, bool over_area) const {
    const std::size_t n = static_cast<std::size_t>(n_x_) * n_y_;
    const int middle = points_.mirrored ? points_.n_y - 1 : 0;
    for (int j = 0; j < points_.n_y; ++j)
        for (int i = 0; i < points_.n_x; ++i) {
            const std::size_t k = static_cast<std::size_t>(j) * points_.n_x + i;
            const bool both = points_.mirrored && j > 0;
            values[k] = real_[place(i, middle + j) + direction * n];
            if (over_area) values[k] /= points_.area[k] / (both ? 2 : 1);
            if (points_.mirrored && j == 0 && direction == 1) values[k] = 0;
        }
}

/// Fields in the directions `from` become those in `to`. The symbol has `per_kind` directions.
void LatticeCompliance::convolve(const std::vector<int>& from, const std::vector<int>& to,
                                 const std::vector<Complex>& symbol, int n_symbol,
                                 int per_kind) const {
    const std::size_t n = static_cast<std::size_t>(n_x_) * n_y_,
                      n_waves = static_cast<std::size_t>(n_x_ / 2 + 1) * n_y_;
    const double scale = 1. / static_cast<double>(n);
    std::vector<int> in;
    for (int kind = 0; kind < n_kinds; ++kind)
        for (const int direction : from) {
            const int field = 3 * kind + direction;
            fftw_execute_dft_r2c(forward_.get(), real_.get() + field * n,
                                 spectrum_.get() + field * n_waves);
            in.push_back(field);
        }
    std::vector<int> out;
    for (int kind = 0; kind < n_kinds; ++kind)
        for (const int direction : to) out.push_back(3 * kind + direction);
    const auto entry = [&](int field) { return per_kind * (field / 3) + field % 3; };
#pragma omp parallel for num_threads(n_threads_) schedule(static) if (n_threads_ > 1)
    for (std::size_t w = 0; w < n_waves; ++w) {
        const Complex* const matrix = symbol.data() + w * n_symbol * n_symbol;
        for (const int row : out) {
            double real = 0, imaginary = 0;
            for (const int column : in) {
                const Complex k = matrix[entry(column) * n_symbol + entry(row)];
                const auto& x = spectrum_[column * n_waves + w];
                real += k.real() * x[0] - k.imag() * x[1];
                imaginary += k.real() * x[1] + k.imag() * x[0];
            }
            product_[row * n_waves + w][0] = scale * real;
            product_[row * n_waves + w][1] = scale * imaginary;
        }
    }
    for (const int field : out)
        fftw_execute_dft_c2r(backward_.get(), product_.get() + field * n_waves,
                             real_.get() + field * n);
}

void LatticeCompliance::normal(std::span<const double> p, std::span<double> u_z) const {
    spread(2, p, true);
    convolve(normal_only, normal_only, compliance_, n_fields, 3);
    gather(2, u_z, false);
}

void LatticeCompliance::tangential(const TangentialField& t, TangentialField& u) const {
    spread(0, t.x, true);
    spread(1, t.y, true);
    convolve(along_only, along_only, compliance_, n_fields, 3);
    gather(0, u.x, false);
    gather(1, u.y, false);
}

// z of the elements points out of the substrate, that of contact into it.
void LatticeCompliance::tangential_from_normal(std::span<const double> p,
                                               TangentialField& u) const {
    spread(2, p, true);
    convolve(normal_only, along_only, compliance_, n_fields, 3);
    gather(0, u.x, false);
    gather(1, u.y, false);
    for (double& x : u.x) x = -x;
    for (double& y : u.y) y = -y;
}

void LatticeCompliance::normal_from_tangential(const TangentialField& t,
                                               std::span<double> u_z) const {
    spread(0, t.x, true);
    spread(1, t.y, true);
    convolve(along_only, normal_only, compliance_, n_fields, 3);
    gather(2, u_z, false);
    for (double& z : u_z) z = -z;
}

void LatticeCompliance::precondition_tangential(const TangentialField& r,
                                                TangentialField& z) const {
    spread(0, r.x, false);
    spread(1, r.y, false);
    convolve(along_only, along_only, along_inverse_, 8, 2);
    gather(0, z.x, true);
    gather(1, z.y, true);
}

}  // namespace tricontact::fem
