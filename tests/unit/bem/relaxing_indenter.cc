// An indenter that relaxes, as a half-space on another: who of both relaxes does not matter for
// frictionless contact, and two that relax alike relax as one.

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "bem/model.h"
#include "contact/base/error.h"
#include "contact/load_path.h"
#include "contact/relaxing_case.h"
#include "io/case/case_reader.h"

namespace tricontact::relaxing_indenter_test {
namespace {

using contact::Case;

constexpr double g = .4, tau = .5;  // G_1/G_0 [-], relaxation time [s]

Case spheres(const std::vector<std::string>& changes) {
    return io::parse_case(R"(models = ["bem"]
[indenter]
radius = "40 mm"
young = "3 MPa"
poisson = 0.3
[substrate]
young = "5 MPa"
poisson = 0.45
[substrate.relaxation]
relative_moduli = [0.4]
times = ["0.5 s"]
[friction]
coefficient = 0.5
[contact]
coupling = false
[load]
normal_force = "5 N"
tangential_ratio = 0.0
press_time = "0.1 s"
[bem]
cells_per_radius = 8
)",
                          "case.toml", changes);
}

const std::vector<std::string> swapped{"indenter.young=\"5 MPa\"", "indenter.poisson=0.45",
                                       "substrate.young=\"3 MPa\"", "substrate.poisson=0.3",
                                       "substrate.relaxation.body=\"indenter\""};

/// Depths of pressing at once and holding for so many seconds, half a second a step.
std::vector<double> depths(const Case& c, int steps, double duration = .5) {
    const auto model = bem::make_model(c, 1);
    contact::LoadStep step = contact::press_step(c);
    step.friction = false;
    step.duration = 0;
    std::vector<double> found{model->advance(step).indentation};
    step.duration = duration;
    for (int k = 0; k < steps; ++k) found.push_back(model->advance(step).indentation);
    return found;
}

TEST(BemRelaxingIndenter, MayBeEitherBody) {
    for (const std::string bulk : {"proportional", "elastic"}) {
        const std::string key = "substrate.relaxation.bulk=\"" + bulk + '"';
        std::vector<std::string> other = swapped;
        other.push_back(key);
        const auto below = depths(spheres({key}), 4), above = depths(spheres(other), 4);
        for (std::size_t k = 0; k < below.size(); ++k)
            EXPECT_NEAR(above[k] / below[k], 1, 1e-9) << bulk << ' ' << k;
        EXPECT_GT(below.back(), 1.05 * below.front());
    }
}

// Under a force that is applied at once d^(3/2) creeps as J(t), of the Maxwell element beside a
// spring; both bodies in proportion. Cells, 8 in a: .2 %.
TEST(BemRelaxingIndenter, BothRelaxAsOne) {
    const Case c = spheres({"substrate.relaxation.body=\"both\""});
    ASSERT_TRUE(contact::relaxes_as_one(c));
    const auto found = depths(c, 40, .05);
    const auto creep = [](double t) { return 1 - g * std::exp(-t * (1 - g) / tau); };
    for (std::size_t k = 1; k < found.size(); ++k)
        EXPECT_NEAR(std::pow(found[k] / found[0], 1.5), creep(k * .05) / creep(0), 4e-3) << k;
}

TEST(BemRelaxingIndenter, OnAnElasticSubstrateNotAllRelaxes) {
    const Case c = spheres(swapped);
    EXPECT_EQ(contact::what_stays(c), contact::Unrelaxed::substrate);
    EXPECT_EQ(&contact::relaxing_material(c), &*c.indenter.material);
    EXPECT_THROW(contact::common_relaxation("mdr", c), contact::InputError);
    EXPECT_THROW(c.refuse_extras("designs"), contact::InputError);
}

// What is given at once belongs to the body that relaxes.
TEST(BemRelaxingIndenter, UnrelaxedModulusIsThatOfTheIndenter) {
    std::vector<std::string> changes = swapped;
    changes.push_back("substrate.relaxation.modulus=\"unrelaxed\"");
    const Case c = spheres(changes);
    EXPECT_NEAR(c.indenter.material->young, (1 - g) * 5e6, 1);
    EXPECT_NEAR(c.substrate.young, 3e6, 1e-3);
    EXPECT_NEAR(c.relaxation->branches[0].ratio, g / (1 - g), 1e-12);
}

TEST(BemRelaxingIndenter, IsRefusedWhereItRollsOrIsRigid) {
    std::vector<std::string> rolls = swapped;
    rolls.insert(rolls.end(), {"rolling.amplitude_ratio=0.2", "rolling.periods=1",
                               "rolling.steps_per_quarter=2", "rolling.speed=\"1 mm/s\""});
    EXPECT_THROW(spheres(rolls), contact::InputError);
    EXPECT_THROW(io::parse_case(R"(models = ["bem"]
[indenter]
radius = "40 mm"
[substrate]
young = "5 MPa"
poisson = 0.45
[substrate.relaxation]
relative_moduli = [0.4]
times = ["0.5 s"]
body = "indenter"
[friction]
coefficient = 0.5
[load]
normal_force = "5 N"
tangential_ratio = 0.0
)",
                                "case.toml"),
                 contact::InputError);
}

}  // namespace
}  // namespace tricontact::relaxing_indenter_test
