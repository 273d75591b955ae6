// Another law of friction than Coulomb's, by which the models are asked for no coefficient: a shear
// strength tau_0 of the interface (Bowden and Tabor). On a sphere pressed on an equal body of nu =
// 0 (nothing couples) the shift U follows from the bound 2 tau_0 sqrt(a^2 - x^2) of MDR's springs:
//   F_T/(pi tau_0 a^2) = 2/pi [u sqrt(1 - u^2) + arcsin u],  u = U G*/(2 tau_0 a);
// with Masing's rule on the way back. The least bounds of a rolled contact carry the lens that both
// extreme contacts share: 2/pi [arccos w - w sqrt(1 - w^2)] of pi tau_0 a^2.

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>

#include "bem/model.h"
#include "contact/base/error.h"
#include "contact/cells.h"
#include "contact/load_path.h"
#include "contact/surface_model.h"
#include "tests/verification/bem/rig.h"

namespace tricontact::bem::shear_strength_test {
namespace {

using std::numbers::pi;

class ShearStrength final : public contact::FrictionLaw {
  public:
    explicit ShearStrength(double strength) : strength_(strength) {}
    void bounds(const Points& points, std::span<double> bound) const override {
        for (std::size_t i = 0; i < bound.size(); ++i)
            bound[i] = points.pressure[i] > 0 ? strength_ : 0;
    }

  private:
    double strength_;  // tau_0 [Pa]
};

constexpr double strength = 2e5;

contact::Case equal_bodies(double w) {
    contact::Case c = rig_case(w, .2, 1);
    c.substrate.poisson = 0;
    c.indenter.material = c.substrate;
    c.of<contact::Cells>().spacing.reset();
    c.of<contact::Cells>().per_radius = 30;
    return c;
}

struct Rig {
    explicit Rig(double w = .2)
        : c(equal_bodies(w)),
          hertz(contact::half_space_scales(c)),
          model("bem", *make_substrate(c, 1, Body::half_space), c.make_indenter(),
                std::make_shared<ShearStrength>(strength), 1e-7) {
        const auto pressed = model.advance(contact::press_step(c));
        limit = strength * pressed.contact_area;
    }
    contact::StepRecord load(double f) {
        contact::LoadStep step = contact::press_step(c);
        step.tangential[0] = {contact::TangentialControl::Kind::ratio, f};
        return model.advance(step);
    }
    /// u of a shift.
    double reduced(double shift) const {
        return shift * c.materials().effective_shear_modulus() /
               (2 * strength * hertz.contact_radius);
    }

    contact::Case c;
    contact::HalfSpaceScales hertz;
    contact::SurfaceModel model;
    double limit = 0;  // [N]
};

double force_at(double u) {
    return 2 / pi * (u * std::sqrt(1 - u * u) + std::asin(u));
}

// Cells cut the edge of the contact, where the traction of what sticks would be infinite: their
// shifts are off by a part h/a of the edge's, 1 % at a/30.
TEST(BemShearStrength, ShiftsAsSpringsThatCarryTheirChord) {
    Rig rig;
    for (const double f : {.2, .5, .8, .95}) {
        const auto record = rig.load(f);
        EXPECT_NEAR(record.tangential_force[0] / rig.limit, f, 1e-9);
        EXPECT_NEAR(force_at(rig.reduced(record.shift[0])), f, .01) << f;
    }
    const double before = rig.reduced(rig.load(.8).shift[0]),
                 after = rig.reduced(rig.load(.2).shift[0]);
    EXPECT_NEAR(2 * force_at((before - after) / 2), .6, .01);
    EXPECT_TRUE(rig.model.audit().passed());
    EXPECT_THROW(rig.load(1.01), contact::InputError);
}

TEST(BemShearStrength, RolledContactCarriesTheLensOfItsExtremes) {
    for (const auto& [w, limit] : {std::array{.2, .74706}, std::array{.4, .50463}}) {
        Rig rig(w);
        rig.model.start_limit();
        for (const double side : {1., -1.}) {
            contact::LoadStep step = contact::press_step(rig.c);
            step.offset[0] = side * w * rig.hertz.contact_radius;
            step.friction = false;
            rig.model.advance(step);
        }
        // Cells count whole or not: their edges are h/a of the area off at worst, .3 % seen.
        EXPECT_NEAR(rig.model.limit_tangential_ratio() / limit, 1, .01) << w;
    }
}

}  // namespace
}  // namespace tricontact::bem::shear_strength_test
