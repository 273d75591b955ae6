#include "fem/finite_strain/hyperelastic.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace tricontact::hyperelastic_test {
namespace {

using fem::Dual;
using fem::Matrix3;

template <class T>
Matrix3<T> random_gradient(std::mt19937& generator, double size) {
    std::uniform_real_distribution<double> uniform(-size, size);
    Matrix3<T> h;
    for (auto& row : h)
        for (auto& component : row) component = uniform(generator);
    return h;
}

// P : dF is the change of the energy, differentiated forwards; also where volume changes.
TEST(Hyperelastic, StressIsTheDerivativeOfTheEnergy) {
    std::mt19937 generator(5);
    for (int trial = 0; trial < 200; ++trial) {
        const auto h = random_gradient<double>(generator, trial % 2 == 0 ? .2 : 1e-6);
        const auto dh = random_gradient<double>(generator, 1);
        Matrix3<Dual<double>> moving;
        for (int a = 0; a < 3; ++a)
            for (int b = 0; b < 3; ++b) moving[a][b] = {h[a][b], dh[a][b]};
        const fem::Strain<Dual<double>> strained(moving);
        const double change =
            energy_density(fem::MooneyRivlin<Dual<double>>{1.7, .6}, strained).change;
        const fem::Strain<double> strain(h);
        const auto m = isochoric_stress(fem::MooneyRivlin<double>{1.7, .6}, strain);
        double power = 0, size = 0;
        for (int a = 0; a < 3; ++a)
            for (int b = 0; b < 3; ++b)
                for (int c = 0; c < 3; ++c) {
                    power += strain.cofactor[a][c] * m[c][b] * dh[a][b];
                    size += std::abs(strain.cofactor[a][c] * m[c][b] * dh[a][b]);
                }
        EXPECT_NEAR((change - power) / size, 0, 1e-13);  // rounding
    }
}

}  // namespace
}  // namespace tricontact::hyperelastic_test
