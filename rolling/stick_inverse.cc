#include "rolling/stick_inverse.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "contact/base/fftw.h"

namespace tricontact::rolling {

namespace {

using Complex = std::complex<double>;
using Matrix = RowFactors::Matrix;

Matrix times(const Matrix& a, const Matrix& b) {
    return {a[0] * b[0] + a[1] * b[2], a[0] * b[1] + a[1] * b[3], a[2] * b[0] + a[3] * b[2],
            a[2] * b[1] + a[3] * b[3]};
}
Matrix times(Complex factor, Matrix a) {
    for (Complex& one : a) one *= factor;
    return a;
}
Matrix adjoint(const Matrix& a) {
    return {std::conj(a[0]), std::conj(a[2]), std::conj(a[1]), std::conj(a[3])};
}
Complex determinant(const Matrix& a) {
    return a[0] * a[3] - a[1] * a[2];
}
Matrix inverse(const Matrix& a) {
    return times(1. / determinant(a), {a[3], -a[1], -a[2], a[0]});
}

/// Takes from a function of the wave number what its Fourier sum has at n > 0, and half of n = 0.
class Half {
  public:
    explicit Half(int n)
        : n_(n),
          values_(contact::fftw_memory<contact::FftwComplex>(n)),
          to_sum_(fftw_plan_dft_1d(n, values_.get(), values_.get(), FFTW_BACKWARD, FFTW_ESTIMATE)),
          from_sum_(
              fftw_plan_dft_1d(n, values_.get(), values_.get(), FFTW_FORWARD, FFTW_ESTIMATE)) {}
    void operator()(std::vector<Complex>& f) const {
        auto* values = reinterpret_cast<Complex*>(values_.get());
        std::ranges::copy(f, values);
        fftw_execute(to_sum_.get());
        for (int i = 0; i < n_; ++i) {
            const bool is_shared = i == 0 || 2 * i == n_;
            values[i] *= (is_shared ? .5 : 2 * i < n_ ? 1. : 0.) / n_;
        }
        fftw_execute(from_sum_.get());
        std::copy(values, values + n_, f.begin());
    }

  private:
    const int n_;
    contact::FftwComplex values_;
    contact::FftwPlan to_sum_, from_sum_;
};

/// G with R = G G^H, G a sum over n >= 0: Wilson's Newton steps G [G^-1 R G^-H + 1]_+.
std::vector<Matrix> spectral_factor(const std::vector<Matrix>& r, const Half& half) {
    // Of determinant 1 and conditions of 1/(1 - nu): the last changes nothing that counts here.
    constexpr int steps = 5;
    std::vector<Matrix> g(r.size(), {1, 0, 0, 1});
    std::array<std::vector<Complex>, 4> sum;
    for (auto& one : sum) one.resize(r.size());
    for (int step = 0; step < steps; ++step) {
        for (std::size_t m = 0; m < r.size(); ++m) {
            const Matrix back = inverse(g[m]);
            const Matrix x = times(times(back, r[m]), adjoint(back));
            for (int e = 0; e < 4; ++e) sum[e][m] = x[e] + (e == 0 || e == 3 ? 1. : 0.);
        }
        for (auto& one : sum) half(one);
        for (std::size_t m = 0; m < r.size(); ++m)
            g[m] = times(g[m], {sum[0][m], sum[1][m], sum[2][m], sum[3][m]});
    }
    return g;
}

/// Even, of the prime factors that FFTW is fast at.
int good_period(int n) {
    for (n += n % 2;; n += 2) {
        int rest = n;
        for (const int prime : {2, 3, 5, 7})
            while (rest % prime == 0) rest /= prime;
        if (rest == 1) return n;
    }
}

}  // namespace

RowFactors factorised(const std::vector<Matrix>& symbol) {
    const std::size_t n = symbol.size();
    const Half half(static_cast<int>(n));
    std::vector<Complex> root(n), behind(n), ahead(n);
    std::vector<Matrix> rest(n);
    for (std::size_t m = 0; m < n; ++m) {
        root[m] = std::sqrt(determinant(symbol[m]));
        const Matrix one = times(1. / root[m], symbol[m]);
        // Rounding, and kernels of relaxing layers, leave little that is not Hermitian.
        const Matrix other = adjoint(one);
        for (int e = 0; e < 4; ++e) rest[m][e] = .5 * (one[e] + other[e]);
        behind[m] = std::log(root[m]);
    }
    half(behind);
    for (std::size_t m = 0; m < n; ++m) {
        behind[m] = std::exp(behind[m]);
        ahead[m] = root[m] / behind[m];
    }
    RowFactors factors{spectral_factor(rest, half), {}};
    factors.ahead.resize(n);
    for (std::size_t m = 0; m < n; ++m) {
        factors.ahead[m] = times(ahead[m], adjoint(factors.behind[m]));
        factors.behind[m] = times(behind[m], factors.behind[m]);
    }
    return factors;
}

/// B^-1 and F^-1 of a grid, and the transforms that apply them: a period is the grid, since what
/// reads half of it ahead or behind decays.
struct StickInverse::Factors {
    explicit Factors(const contact::Compliance& compliance);
    void apply(const std::vector<std::uint8_t>& sticks, contact::TangentialField& f);

  private:
    void set_symbol(const contact::Compliance& compliance);
    void factorise();
    void multiply(const Symbol& symbol, contact::TangentialField& f);
    std::size_t at(int row, int wave) const {
        return static_cast<std::size_t>(row) * n_waves_ + wave;
    }

    const int n_x_, n_y_;
    const double spacing_;
    const int period_x_, period_y_, n_waves_;  // of x: 0 ... N/2
    Symbol before_, after_;                    // B^-1, F^-1
    std::array<contact::FftwReal, 2> field_;
    std::array<contact::FftwComplex, 2> spectrum_;
    contact::FftwPlan forward_, backward_;
};

StickInverse::Factors::Factors(const contact::Compliance& compliance)
    : n_x_(compliance.points().n_x),
      n_y_(compliance.points().n_y),
      spacing_(compliance.points().spacing[0]),
      period_x_(good_period(n_x_)),
      period_y_(n_y_ == 1 ? 1 : good_period(n_y_)),
      n_waves_(period_x_ / 2 + 1) {
    const auto n = static_cast<std::size_t>(period_y_);
    for (int c = 0; c < 2; ++c) {
        field_[c] = contact::fftw_zeros<contact::FftwReal>(n * period_x_);
        spectrum_[c] = contact::fftw_zeros<contact::FftwComplex>(n * n_waves_);
    }
    forward_.reset(fftw_plan_dft_r2c_2d(period_y_, period_x_, field_[0].get(), spectrum_[0].get(),
                                        FFTW_ESTIMATE));
    backward_.reset(fftw_plan_dft_c2r_2d(period_y_, period_x_, spectrum_[0].get(), field_[0].get(),
                                         FFTW_ESTIMATE));
    set_symbol(compliance);
    factorise();
}

/// The transform of the kernel at all relative positions up to half a period, into after_.
void StickInverse::Factors::set_symbol(const contact::Compliance& compliance) {
    const std::size_t n = compliance.points().size();
    // Ahead and behind: a relaxing body's kernel differs. xx, xy by tractions along x, yy.
    const std::size_t corners[] = {0, static_cast<std::size_t>(n_x_ - 1)};
    std::array<std::array<contact::TangentialField, 2>, 2> answer;
    for (int c = 0; c < 2; ++c)
        for (int side = 0; side < 2; ++side) {
            contact::TangentialField t(n);
            (c == 0 ? t.x : t.y)[corners[side]] = 1;
            answer[c][side] = contact::TangentialField(n);
            compliance.tangential(t, answer[c][side]);
        }
    after_.assign(static_cast<std::size_t>(period_y_) * n_waves_, {});
    for (const int e : {0, 1, 3}) {
        double* field = field_[0].get();
        std::fill_n(field, static_cast<std::size_t>(period_x_) * period_y_, 0.);
        for (int j = -n_y_ + 1; j < n_y_; ++j)
            for (int i = -n_x_ + 1; i < n_x_; ++i) {
                if (2 * std::abs(i) > period_x_ || 2 * std::abs(j) > period_y_) continue;
                const auto& u = answer[e == 3][i < 0];
                const std::size_t from =
                    static_cast<std::size_t>(std::abs(j)) * n_x_ + (i < 0 ? n_x_ - 1 + i : i);
                // Half a period away stands for both sides: what is odd there is none.
                const bool is_none =
                    e == 1 && (2 * std::abs(i) == period_x_ || 2 * std::abs(j) == period_y_);
                const double value = (e == 0 ? u.x : u.y)[from] * (e == 1 && j < 0 ? -1 : 1);
                field[static_cast<std::size_t>((j + period_y_) % period_y_) * period_x_ +
                      (i + period_x_) % period_x_] = is_none ? 0 : value;
            }
        fftw_execute(forward_.get());
        const auto* values = reinterpret_cast<const Complex*>(spectrum_[0].get());
        for (std::size_t k = 0; k < after_.size(); ++k) after_[k][e] = values[k];
    }
    // Kernels that end somewhere may be negative at short waves: the mean is that of the cell.
    const double least = .05 * std::abs(answer[0][0].x[0]);
    for (Matrix& one : after_) {
        one[2] = one[1];
        const double xx = one[0].real(), yy = one[3].real(), xy = std::abs(one[1]);
        if (xx < least || yy < least || xx * yy - xy * xy < least * std::max(xx, yy))
            one = {std::max(xx, least), 0, 0, std::max(yy, least)};
    }
}

void StickInverse::Factors::factorise() {
    before_.resize(after_.size());
    const double scale = 1. / (static_cast<double>(period_x_) * period_y_);
    std::vector<Matrix> row(period_x_);
    for (int j = 0; 2 * j <= period_y_; ++j) {
        const int mirror = (period_y_ - j) % period_y_;
        for (int i = 0; i < period_x_; ++i) {
            row[i] = after_[i < n_waves_ ? at(j, i) : at(mirror, period_x_ - i)];
            if (i >= n_waves_)
                for (Complex& one : row[i]) one = std::conj(one);
        }
        const RowFactors factors = factorised(row);
        for (int i = 0; i < n_waves_; ++i) {
            before_[at(j, i)] = times(scale, inverse(factors.behind[i]));
            after_[at(j, i)] = times(scale, inverse(factors.ahead[i]));
        }
        // y and the y components the other way round.
        for (auto* all : {&before_, &after_})
            for (int i = 0; i < n_waves_ && mirror != j; ++i) {
                const Matrix& one = (*all)[at(j, i)];
                (*all)[at(mirror, i)] = {one[0], -one[1], -one[2], one[3]};
            }
    }
}

void StickInverse::Factors::multiply(const Symbol& symbol, contact::TangentialField& f) {
    std::array<std::vector<double>*, 2> parts{&f.x, &f.y};
    for (int c = 0; c < 2; ++c) {
        double* field = field_[c].get();
        std::fill_n(field, static_cast<std::size_t>(period_x_) * period_y_, 0.);
        for (int j = 0; j < n_y_; ++j)
            std::copy_n(parts[c]->begin() + static_cast<std::ptrdiff_t>(j) * n_x_, n_x_,
                        field + static_cast<std::ptrdiff_t>(j) * period_x_);
        fftw_execute_dft_r2c(forward_.get(), field, spectrum_[c].get());
    }
    auto* x = reinterpret_cast<Complex*>(spectrum_[0].get());
    auto* y = reinterpret_cast<Complex*>(spectrum_[1].get());
    for (std::size_t k = 0; k < symbol.size(); ++k) {
        const Matrix& s = symbol[k];
        const Complex first = x[k], second = y[k];
        x[k] = s[0] * first + s[1] * second;
        y[k] = s[2] * first + s[3] * second;
    }
    for (int c = 0; c < 2; ++c) {
        fftw_execute_dft_c2r(backward_.get(), spectrum_[c].get(), field_[c].get());
        for (int j = 0; j < n_y_; ++j)
            std::copy_n(field_[c].get() + static_cast<std::ptrdiff_t>(j) * period_x_, n_x_,
                        parts[c]->begin() + static_cast<std::ptrdiff_t>(j) * n_x_);
    }
}

void StickInverse::Factors::apply(const std::vector<std::uint8_t>& sticks,
                                  contact::TangentialField& f) {
    const std::size_t n = sticks.size();
    multiply(before_, f);
    for (auto* part : {&f.x, &f.y}) {
        double ahead = 0;
        for (std::size_t i = n; i-- > 0;) {
            ahead = sticks[i] ? spacing_ * (*part)[i] + ahead : 0;
            (*part)[i] = ahead;
        }
    }
    multiply(after_, f);
    for (std::size_t i = 0; i < n; ++i)
        if (!sticks[i]) f.set(i, {0, 0});
}

void StickInverse::DeleteFactors::operator()(Factors* factors) const {
    delete factors;
}

void StickInverse::apply(const std::vector<std::uint8_t>& sticks,
                         contact::TangentialField& f) const {
    if (std::ranges::count(sticks, 1) == 0) return;
    if (!factors_) factors_.reset(new Factors(compliance_));
    factors_->apply(sticks, f);
}

}  // namespace tricontact::rolling
