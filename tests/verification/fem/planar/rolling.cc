// Two cylinders of one material rolling, the lower one a block: Carter (1926), and numbers of an
// independent program for the same bodies (radius 10 mm, hub 3 mm, a = R/20).

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "contact/load_path.h"
#include "contact/surface.h"
#include "fem/case/section_model.h"
#include "fem/settings.h"
#include "io/case/case_reader.h"

namespace tricontact::fem_planar_rolling_test {
namespace {

using contact::Case;

constexpr double radius = 10e-3, half_width = .5e-3, friction = .5, length = .08;
constexpr double way = 7 * half_width;  // what is settled after 4 a, under a given force

Case case_of(double poisson, int elements) {
    const double young = 4e6, modulus = young / (1 - poisson * poisson) / 2;
    const double force =
        length * std::numbers::pi * modulus * half_width * half_width / (4 * radius);
    Case c = io::parse_case(R"(models = ["fem-plane"]
[indenter]
shape = "cylinder"
radius = "10 mm"
length = "80 mm"
young = "4 MPa"
poisson = 0.3
body = "cylinder"
support = "hub"
hub_radius = "3 mm"
[substrate]
young = "4 MPa"
poisson = 0.3
thickness = "60 mm"
[friction]
coefficient = 0.5
[load]
normal_force = "1 N"
tangential_ratio = 0
[rolling]
amplitude = "1.75 mm"
)",
                            "case.toml", {});
    c.load.normal_force = force;
    c.indenter.material->poisson = c.substrate.poisson = poisson;
    c.of<fem::Settings>().size = half_width / elements;
    return c;
}

/// A cylinder that has rolled under F_T over mu F_N from one end of its path to the other.
class Rolled {
  public:
    Rolled(double poisson, int elements)
        : case_(case_of(poisson, elements)),
          step_(half_width / elements / 2),
          model_(fem::make_section_model(contact::model_kind(contact::models::fem_plane), case_,
                                         nullptr)) {}

    /// Shift per way over the last half width [-].
    double creep(double ratio) {
        model_->release();
        contact::LoadStep step = contact::press_step(case_);
        step.friction = false;
        step.offset = {-way / 2, 0};
        model_->advance(step);
        step.friction = true;
        step.tangential[0].value = ratio * friction * *case_.load.normal_force;
        const int n = static_cast<int>(std::lround(way / step_));
        const int last = static_cast<int>(std::lround(half_width / step_));
        double before = 0, now = 0;
        for (int k = 0; k <= n; ++k) {
            step.offset[0] = -way / 2 + k * step_;
            now = model_->advance(step).shift[0];
            if (k == n - last) before = now;
        }
        EXPECT_TRUE(model_->audit().passed());
        return (now - before) / half_width;
    }

    /// Where points stick: from the trailing to the leading edge of what sticks, over a, from the
    /// middle of the contact.
    std::array<double, 2> stick() const {
        const contact::Surface s = model_->surface();
        std::array<double, 2> ends{2, -2};
        for (int i = 0; i < s.n_x; ++i) {
            if (s.contact_state[i] != contact::ContactState::stick) continue;
            const double x = (s.x(i) - way / 2) / half_width;
            ends = {std::min(ends[0], x), std::max(ends[1], x)};
        }
        return ends;
    }

  private:
    Case case_;
    double step_;
    std::unique_ptr<contact::Model> model_;
};

constexpr double creep_unit = friction * half_width / radius;
constexpr double square = half_width * half_width / (radius * radius);
constexpr std::array<double, 4> ratios{.25, .5, .75, .9};

// The cylinder's surface is compressed in the contact, the block's less: rolling without a force
// creeps by .89 (a/R)^2.
TEST(FemPlanarRolling, FreeRollingCreeps) {
    EXPECT_NEAR(Rolled(.495, 8).creep(0) / square, .89, .01);
    EXPECT_NEAR(Rolled(.3, 8).creep(0) / square, .89, .03);
}

// The other program's numbers, nu = .3: four digits, but for the length of the way.
TEST(FemPlanarRolling, CreepsAsByAnotherProgram) {
    const std::array<std::array<double, 4>, 2> creep{
        {{.1294, .2868, .4937, .6721}, {.1322, .2906, .4914, .6656}}};
    for (const int k : {0, 1}) {
        Rolled rolled(.3, k == 0 ? 8 : 16);
        const double free = rolled.creep(0);
        for (std::size_t i = 0; i < ratios.size(); ++i)
            EXPECT_NEAR((rolled.creep(ratios[i]) - free) / creep_unit, creep[k][i], 5e-4);
    }
}

// Half the difference of both directions knows no free creep. First order in the spacing of the
// nodes: 3 % at a/16, 1.5 % at a/32. The stick zone lies at the leading edge, 1 - sqrt(Q/(mu P))
// wide; two nodes for both its ends.
TEST(FemPlanarRolling, ComesToCarters) {
    std::array<Rolled, 2> rolled{Rolled(.495, 8), Rolled(.495, 16)};
    for (const double q : ratios) {
        const double carter = 1 - std::sqrt(1 - q);
        std::array<double, 2> error{};
        for (const int k : {0, 1}) {
            const double back = rolled[k].creep(-q), on = rolled[k].creep(q);
            error[k] = std::abs((on - back) / (2 * creep_unit * carter) - 1);
            const auto [trailing, leading] = rolled[k].stick();
            const double spacing = 1. / (k == 0 ? 16 : 32);
            EXPECT_NEAR(leading, 1, 2 * spacing) << q;
            EXPECT_NEAR(trailing, 1 - 2 * std::sqrt(1 - q), 2 * spacing) << q;
        }
        EXPECT_LT(error[0], .03) << q;
        EXPECT_LT(error[1], .015) << q;
        EXPECT_LT(error[1], error[0]) << q;
    }
}

}  // namespace
}  // namespace tricontact::fem_planar_rolling_test
