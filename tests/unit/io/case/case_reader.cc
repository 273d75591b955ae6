#include "io/case/case_reader.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <locale>
#include <numbers>
#include <thread>

#include "bem/settings.h"
#include "contact/base/error.h"
#include "contact/cells.h"
#include "fem/settings.h"
#include "io/case/case_input.h"
#include "io/results/output.h"
#include "mdr/settings.h"
#include "tests/paths.h"
#include "tests/unit/io/sphere_case.h"
#include "walking/input/walk_reader.h"

namespace tricontact::io::case_reader_test {
namespace {

using contact::Case;

Case parsed(const std::vector<std::string>& overrides = {}, const std::string& more = {}) {
    return parse_case(loaded_sphere + more, "minimal.toml", overrides);
}

const std::string rolling = "[rolling]\namplitude_ratio = 0.24\namplitude_reference = \"model\"\n";

TEST(CaseReader, ReadsTheRigOfTheThesisInSiUnits) {
    const Case c = read_case(paths::source("examples/cases/rig_sphere_parallel.toml"));
    EXPECT_EQ(c.title, "Sphere on rubber, load parallel to rolling (thesis table 5.1.1)");
    EXPECT_EQ(c.models, (std::vector<std::string>{"mdr", "bem"}));
    EXPECT_EQ(c.indenter.shape, Case::Shape::paraboloid);
    // Powers of ten are divided out, so decimal texts give the nearest double: exact comparisons.
    EXPECT_EQ(c.indenter.radius, 0.04);
    ASSERT_TRUE(c.indenter.material);
    EXPECT_EQ(c.indenter.material->young, 206e9);
    EXPECT_EQ(c.indenter.material->poisson, 0.3);
    EXPECT_EQ(c.substrate.young, 5.2e6);
    EXPECT_EQ(c.substrate.poisson, 0.5);
    EXPECT_EQ(c.friction_coefficient(), 0.57);
    EXPECT_EQ(c.load.normal_force, 21.1);
    EXPECT_FALSE(c.load.indentation);
    EXPECT_EQ(c.load.tangential_ratio, 0.56);
    EXPECT_FALSE(c.load.tangential_force);
    ASSERT_TRUE(c.rolling);
    EXPECT_EQ(c.rolling->amplitude_ratio, 0.24);
    EXPECT_FALSE(c.rolling->amplitude);
    EXPECT_EQ(c.rolling->angle, 0);
    EXPECT_EQ(c.rolling->periods, 12);
    EXPECT_EQ(c.rolling->steps, Case::Steps::increment);
    EXPECT_EQ(c.rolling->increment, 0.0002);
    EXPECT_EQ(c.of<contact::Cells>().spacing, 0.0002);
    EXPECT_FALSE(c.of<contact::Cells>().per_radius);
    EXPECT_EQ(c.of<bem::Settings>().tolerance, 1e-7);
    EXPECT_EQ(c.of<mdr::Settings>().springs, 10000);
}

TEST(CaseReader, EveryCaseOfTheFolderIsAccepted) {
    int n = 0;
    for (const auto& file : std::filesystem::directory_iterator(paths::source("examples/cases"))) {
        if (file.path().extension() != ".toml") continue;
        ++n;
        EXPECT_NO_THROW(walking::read_any_case(file.path().string())) << file.path();
    }
    EXPECT_GE(n, 6);
}

TEST(CaseReader, PerpendicularRigIsTable512) {
    const Case c = read_case(paths::source("examples/cases/rig_sphere_perpendicular.toml"));
    EXPECT_EQ(c.substrate.young, 4.35e6);
    EXPECT_EQ(c.friction_coefficient(), 0.93);
    EXPECT_EQ(c.load.normal_force, 21.19);
    EXPECT_DOUBLE_EQ(c.rolling->angle, std::numbers::pi / 2);
    // rigs.md: a = 4.786 mm, d = 0.573 mm with the printed modulus; four and three digits given.
    EXPECT_NEAR(contact::half_space_scales(c).contact_radius, 4.786e-3, 0.5e-6);
    EXPECT_NEAR(contact::half_space_scales(c).indentation, 0.573e-3, 0.5e-6);
}

TEST(CaseReader, ReadsALayerInSiUnits) {
    const Case c = parse_case(R"(models = ["fem"]
[indenter]
radius = "40 mm"
[substrate]
young = "5.2 MPa"
poisson = 0.49
thickness = "8 mm"
base = "frictionless"
width = "6 cm"
depth = "70 mm"
[lower_layer]
thickness = "2 mm"
young = "70 GPa"
poisson = 0.33
[friction]
coefficient = 0.57
[contact]
coupling = false
[load]
normal_force = "21.1 N"
tangential_ratio = 0.56
press_steps = 7
[fem]
size = "0.5 mm"
growth = 1.5
tolerance = 1e-5
cache = "none"
)",
                              "layer.toml");
    EXPECT_EQ(c.models, std::vector<std::string>{"fem"});
    EXPECT_EQ(c.layer.thickness, 0.008);
    EXPECT_EQ(c.layer.base, Case::Base::frictionless);
    EXPECT_EQ(c.layer.width, 0.06);
    EXPECT_EQ(c.layer.depth, 0.07);
    ASSERT_EQ(c.layer.lower.size(), 1U);
    EXPECT_EQ(c.layer.lower.front().thickness, 0.002);
    EXPECT_EQ(c.layer.lower.front().material.young, 70e9);
    EXPECT_EQ(c.layer.lower.front().material.poisson, 0.33);
    EXPECT_EQ(c.layer.total_thickness(), 0.01);
    EXPECT_FALSE(c.contact.coupling);
    EXPECT_EQ(c.load.press_steps, 7);
    EXPECT_EQ(c.of<fem::Settings>().size, 0.0005);
    EXPECT_FALSE(c.of<fem::Settings>().accuracy);
    EXPECT_EQ(c.of<fem::Settings>().growth, 1.5);
    EXPECT_EQ(c.of<fem::Settings>().tolerance, 1e-5);
    EXPECT_EQ(c.of<fem::Settings>().cache, "none");
    EXPECT_FALSE(c.of<fem::Settings>().mesh);
}

TEST(CaseReader, AnyLawOfFrictionIsReadAndWritten) {
    for (const std::vector<std::string>& law :
         {std::vector<std::string>{"friction.shear_strength=0.35 MPa"},
          {"friction.pressure_exponent=0.8", "friction.reference_pressure=1 MPa"},
          {"friction.shear_strength=1 kPa", "friction.strength_limit=2 MPa"}}) {
        const Case c = parsed(law), back = parse_case(write_case(c), "written.toml");
        EXPECT_FALSE(c.friction.is_coulomb());
        EXPECT_EQ(back.friction.formula(), c.friction.formula());
        for (const double p : {1e3, 1e6, 1e7})
            EXPECT_EQ(back.friction.law()->bound(p), c.friction.law()->bound(p));
        EXPECT_THROW(c.friction_coefficient(), contact::InputError);
    }
}

TEST(CaseReader, FileNamesAreMeantFromTheCaseFileAndThoseOfOverridesFromTheWorkingDirectory) {
    const std::string text = loaded_sphere + R"([fem]
mesh = "../meshes/layer.msh"
mesh_unit = "1 mm"
cache = "condensed"
)";
    const auto here = std::filesystem::current_path();
    const Case c = parse_case(text, "/home/me/cases/layer.toml");
    EXPECT_EQ(c.of<fem::Settings>().mesh, "/home/me/meshes/layer.msh");
    EXPECT_EQ(c.of<fem::Settings>().mesh_unit, 1e-3);
    EXPECT_EQ(c.of<fem::Settings>().cache, "/home/me/cases/condensed");
    EXPECT_FALSE(c.of<fem::Settings>().accuracy) << "a mesh has the size of its own";
    EXPECT_EQ(parse_case(text, "layer.toml").of<fem::Settings>().cache, here / "condensed");

    const Case overridden =
        parse_case(text, "/home/me/cases/layer.toml", {"fem.mesh=a.msh", "fem.cache=/tmp/there"});
    EXPECT_EQ(overridden.of<fem::Settings>().mesh, here / "a.msh");
    EXPECT_EQ(overridden.of<fem::Settings>().cache, "/tmp/there");

    // Written out they stay where they are, wherever the resolved case stands.
    EXPECT_EQ(parse_case(write_case(c), "elsewhere/case.toml").of<fem::Settings>().mesh,
              c.of<fem::Settings>().mesh);
    EXPECT_EQ(parse_case(write_case(c), "elsewhere/case.toml").of<fem::Settings>().cache,
              c.of<fem::Settings>().cache);
}

TEST(CaseReader, OmittedSectionsMeanRigidStaticAndDefaults) {
    const Case c = parsed();
    EXPECT_FALSE(c.indenter.material);
    EXPECT_FALSE(c.rolling);
    EXPECT_EQ(c.title, "");
    EXPECT_EQ(c.of<contact::Cells>().per_radius, 22.5);
    EXPECT_FALSE(c.of<contact::Cells>().spacing);
    EXPECT_EQ(c.of<io::Output>().vtk, io::Output::Vtk::frames);
    EXPECT_EQ(c.of<io::Output>().frames_per_period, 40);
}

// The defaults are declared twice: with the keys, for the reference, and in the structure.
TEST(CaseReader, DeclaredDefaultsAreThoseOfTheStructure) {
    const Case c = parsed({}, "[rolling]\namplitude_ratio = 0.1\n");
    const Case::Rolling rolling_defaults;
    EXPECT_EQ(c.indenter.shape, Case::IndenterData().shape);
    EXPECT_EQ(c.load.normal_amplitude_ratio, Case::Load().normal_amplitude_ratio);
    EXPECT_EQ(c.load.normal_phase, Case::Load().normal_phase);
    EXPECT_EQ(c.load.tangential_amplitude_ratio, Case::Load().tangential_amplitude_ratio);
    EXPECT_EQ(c.load.tangential_phase, Case::Load().tangential_phase);
    EXPECT_EQ(c.rolling->amplitude_reference, rolling_defaults.amplitude_reference);
    EXPECT_EQ(c.rolling->angle, rolling_defaults.angle);
    EXPECT_EQ(c.rolling->periods, rolling_defaults.periods);
    EXPECT_EQ(c.rolling->run_all, rolling_defaults.run_all);
    EXPECT_EQ(c.rolling->steps, rolling_defaults.steps);
    EXPECT_EQ(c.rolling->steps_per_quarter, rolling_defaults.steps_per_quarter);
    EXPECT_EQ(c.of<bem::Settings>().tolerance, bem::Settings().tolerance);
    EXPECT_EQ(c.of<mdr::Settings>().springs, mdr::Settings().springs);
    EXPECT_EQ(c.of<io::Output>().vtk, io::Output().vtk);
    EXPECT_EQ(c.of<io::Output>().volume, io::Output().volume);
    EXPECT_EQ(c.load.press, Case::Load().press);
    EXPECT_EQ(c.load.press_steps, Case::Load().press_steps);
    EXPECT_EQ(c.contact.coupling, Case::Contact().coupling);
    EXPECT_EQ(c.of<fem::Settings>().growth, fem::Settings().growth);
    EXPECT_EQ(c.of<fem::Settings>().sides, fem::Settings().sides);
    EXPECT_EQ(c.of<fem::Settings>().tolerance, fem::Settings().tolerance);
    EXPECT_EQ(c.of<fem::Settings>().cache, fem::Settings().cache);
    const Case layered = parsed({"substrate.thickness=8 mm", "fem.mesh=layer.msh"});
    EXPECT_EQ(layered.layer.base, Case::Layer().base);
    EXPECT_EQ(layered.of<fem::Settings>().mesh_unit, fem::Settings().mesh_unit);
}

TEST(CaseReader, ReadsManyLayersOnAnElasticGround) {
    const Case c =
        parsed({"models=[\"bem-layer\", \"mdr-layer\"]", "substrate.thickness=8 mm",
                "substrate.base=half-space", "ground.young=3 GPa", "ground.poisson=0.2",
                "lower_layer.thickness=[\"2 mm\", \"10 um\"]",
                "lower_layer.young=[\"70 GPa\", \"1 MPa\"]", "lower_layer.poisson=[0.33, 0]"});
    EXPECT_EQ(c.layer.base, Case::Base::half_space);
    ASSERT_TRUE(c.layer.ground);
    EXPECT_EQ(c.layer.ground->young, 3e9);
    EXPECT_EQ(c.layer.ground->poisson, .2);
    ASSERT_EQ(c.layer.lower.size(), 2U);
    EXPECT_EQ(c.layer.lower[0].thickness, 2e-3);
    EXPECT_EQ(c.layer.lower[0].material.young, 70e9);
    EXPECT_EQ(c.layer.lower[1].thickness, 1e-5);
    EXPECT_EQ(c.layer.lower[1].material.young, 1e6);
    EXPECT_EQ(c.layer.lower[1].material.poisson, 0);
    EXPECT_FALSE(c.kept.find<io::LayersInput>());
}

TEST(CaseReader, EveryWordOfAChoiceIsRead) {
    EXPECT_EQ(parsed({"indenter.shape=sphere"}).indenter.shape, Case::Shape::sphere);
    EXPECT_EQ(parsed({}, rolling).rolling->amplitude_reference, Case::AmplitudeReference::model);
    EXPECT_EQ(parsed({"rolling.steps=turning-points"}, rolling).rolling->steps,
              Case::Steps::turning_points);
    EXPECT_EQ(parsed({"output.vtk=none"}).of<io::Output>().vtk, io::Output::Vtk::none);
    EXPECT_EQ(parsed({"output.vtk=all"}).of<io::Output>().vtk, io::Output::Vtk::all);
    EXPECT_EQ(parsed({"output.volume=last"}).of<io::Output>().volume, io::Output::Volume::last);
    EXPECT_EQ(parsed({"output.volume=quarters"}).of<io::Output>().volume,
              io::Output::Volume::quarters);
    EXPECT_EQ(parsed({"load.press=frictionless"}).load.press, Case::Press::frictionless);
    EXPECT_EQ(parsed({"fem.sides=fixed"}).of<fem::Settings>().sides, fem::Sides::fixed);
    EXPECT_EQ(parsed({"fem.solver=direct"}).of<fem::Settings>().solver, fem::Solver::direct);
    EXPECT_EQ(parsed({"substrate.base=frictionless", "substrate.thickness=8 mm"}).layer.base,
              Case::Base::frictionless);
}

TEST(CaseReader, OverridesTakeTomlOrBareText) {
    EXPECT_EQ(parsed({"rolling.increment=\"0.1 mm\""}, rolling).rolling->increment, 1e-4);
    EXPECT_EQ(parsed({"rolling.increment=0.1 mm"}, rolling).rolling->increment, 1e-4);
    EXPECT_EQ(parsed({" rolling.periods = 3 "}, rolling).rolling->periods, 3);
    EXPECT_EQ(parsed({"title=two words"}).title, "two words");
    EXPECT_EQ(parsed({"title=a\nb"}).title, "a\nb");
    EXPECT_EQ(parsed({"models=[\"mdr\"]"}).models, std::vector<std::string>{"mdr"});
}

TEST(CaseReader, OverridingOneAlternativeRemovesTheOthersOfTheFile) {
    const Case force = parsed({"load.tangential_force=6.7 N"});
    EXPECT_EQ(force.load.tangential_force, 6.7);
    EXPECT_FALSE(force.load.tangential_ratio);

    const Case indented = parsed({"load.indentation=0.5 mm"});
    EXPECT_EQ(indented.load.indentation, 0.0005);
    EXPECT_FALSE(indented.load.normal_force);

    // amplitude_reference depends on the ratio and goes with it.
    const Case rolled = parsed({"rolling.amplitude=1.1 mm"}, rolling);
    EXPECT_EQ(rolled.rolling->amplitude, 0.0011);
    EXPECT_FALSE(rolled.rolling->amplitude_ratio);
    EXPECT_EQ(rolled.rolling->amplitude_reference, Case::AmplitudeReference::hertz);

    const Case steps = parsed({"rolling.increment=0.1 mm"}, rolling + "steps_per_quarter = 9\n");
    EXPECT_EQ(steps.rolling->steps, Case::Steps::increment);
    EXPECT_EQ(steps.rolling->steps_per_quarter, Case::Rolling().steps_per_quarter);

    const Case meshed =
        parsed({"fem.size=1 mm"}, "[fem]\nmesh = \"a.msh\"\nmesh_unit = \"1 mm\"\n");
    EXPECT_EQ(meshed.of<fem::Settings>().size, 1e-3);
    EXPECT_FALSE(meshed.of<fem::Settings>().mesh);
    EXPECT_EQ(meshed.of<fem::Settings>().mesh_unit, 1);

    const Case cells = parsed({"bem.cells_per_radius=11"}, "[bem]\nspacing = \"0.2 mm\"\n");
    EXPECT_EQ(cells.of<contact::Cells>().per_radius, 11);
    EXPECT_FALSE(cells.of<contact::Cells>().spacing);
}

TEST(CaseReader, AnOverrideMayOpenASection) {
    const Case c = parsed({"rolling.amplitude_ratio=0.3"});
    ASSERT_TRUE(c.rolling);
    EXPECT_EQ(c.rolling->amplitude_ratio, 0.3);
}

TEST(CaseReader, WrittenSectionsInlineTablesAndDottedKeysAreTheSame) {
    const std::string inlined = R"(models = ["bem"]
indenter = {radius = "40 mm"}
substrate = {young = "5.2 MPa", poisson = 0.5}
friction.coefficient = 0.57
load.normal_force = "21.1 N"
load.tangential_ratio = 0.56
)";
    EXPECT_EQ(write_case(parse_case(inlined, "inlined.toml")), write_case(parsed()));
}

TEST(CaseReader, TheLimitOfFrictionIsSharpUnderOscillation) {
    // In phase, F_T/(mu F_N) is largest at the trough of both: f (1 - t) / (1 - n).
    const double normal = 0.2, tangential = 0.1, ratio = (1 - normal) / (1 - tangential);
    const auto overrides = [&](double f) {
        return std::vector<std::string>{"load.tangential_ratio=" + std::to_string(f),
                                        "load.normal_amplitude_ratio=0.2",
                                        "load.tangential_amplitude_ratio=0.1"};
    };
    EXPECT_NO_THROW(parsed(overrides(ratio - 1e-5), rolling));
    EXPECT_THROW(parsed(overrides(ratio + 1e-5), rolling), contact::InputError);
}

TEST(CaseReader, TheDecimalPointDoesNotDependOnTheLocale) {
    struct DecimalComma : std::numpunct<char> {
        char do_decimal_point() const override { return ','; }
        char do_thousands_sep() const override { return '.'; }
        std::string do_grouping() const override { return "\3"; }
    };
    const std::locale old = std::locale::global(std::locale({}, new DecimalComma));
    const Case c = parsed();
    const std::string text = write_case(c);
    std::locale::global(old);
    EXPECT_EQ(c.load.normal_force, 21.1);
    EXPECT_NE(text.find("normal_force = \"21.1 N\""), std::string::npos) << text;
}

TEST(CaseReader, ThreadsMayReadAtOnce) {
    const std::string expected = write_case(parsed());
    std::vector<std::thread> threads;
    std::vector<int> equal(4, 0);
    threads.reserve(equal.size());
    for (int& count : equal)
        threads.emplace_back([&] {
            for (int i = 0; i < 50; ++i) count += write_case(parsed()) == expected;
        });
    for (auto& thread : threads) thread.join();
    EXPECT_EQ(equal, std::vector<int>(4, 50));
}

}  // namespace
}  // namespace tricontact::io::case_reader_test
