// The example of each key, as the reference of case files has it, is accepted by a case.

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "io/case/case_keys.h"
#include "io/case/case_reader.h"
#include "tests/paths.h"
#include "tests/unit/io/sphere_case.h"

namespace tricontact::io::case_key_examples_test {
namespace {

const std::string rolling_case = loaded_sphere + "[rolling]\namplitude_ratio = 0.24\n";

bool relaxes(const Key& key) {
    return key.section() == "substrate.relaxation" || key.needs == "substrate.relaxation";
}

// The key, what it needs, and what its section needs unless the case has that section anyway.
std::vector<const Key*> with_companions(const Key& key) {
    std::vector<const Key*> keys{&key};
    const auto add = [&](const Key* one) {
        if (std::find(keys.begin(), keys.end(), one) == keys.end()) keys.push_back(one);
    };
    for (std::size_t i = 0; i < keys.size(); ++i) {
        if (const Key* needed = find_key(keys[i]->needs)) add(needed);
        const bool is_time = key.path == "substrate.relaxation.times";
        if (is_time) add(find_key("substrate.relaxation.moduli"));
        const bool said = key.alternative > 0 || find_key(key.needs) || is_time;
        if (relaxes(*keys[i]) && !said) add(find_key("substrate.relaxation.G2"));
        if (relaxes(*keys[i])) add(find_key("rolling.speed"));
        for (const Key& other : case_keys())
            for (const std::string_view section : {"lower_layer", "ground"})
                if (other.required && other.section() == section && keys[i]->section() == section)
                    add(&other);
    }
    return keys;
}

/// The case whose body or motion has keys that others have not; empty: any will do.
std::string case_of(std::string_view path) {
    static const std::map<std::string_view, std::string> cases = {
        {"indenter.length", "rig_cylinder"},
        {"indenter.chamfer", "rig_cylinder_roller"},
        {"indenter.radius_y", "body_ellipsoid"},
        {"indenter.angle", "body_cone"},
        {"indenter.exponent", "body_power_law"},
        {"indenter.flat_radius", "body_rounded_punch"},
        {"indenter.roughness", "rough_plane"},
        {"indenter.body", "hemisphere"},
        {"indenter.support", "hemisphere"},
        {"indenter.hub_radius", "cylinder_on_hub"},
        {"indenter.height", "body_rounded_punch"},
        {"substrate.rigid", "hemisphere"},
        {"upper_plate.rigid", "ball_between_unlike_plates"},
        {"upper_plate", "hemisphere"},
        {"substrate.shape", "pin_in_hole"},
        {"substrate.hole_radius", "pin_in_hole"},
        {"substrate.outer_radius", "pin_in_hole"},
        {"load.bulk_stress", "fretting_cylinder"},
        {"path", "path_twist"},
        {"load.tangential_amplitude", "fretting_steel"},
        {"load.shift_amplitude", "fretting_steel"},
        {"load.periods", "fretting_steel"},
        {"load.steps_per_quarter", "fretting_steel"},
        {"rig", "path_twist"},
        {"wear", "fretting_wear"},
        {"adhesion", "adhesive_sphere"},
        {"bem.adhesive_edge", "adhesive_sphere"},
        {"friction.rate", "rolling_falling_friction"},
        {"friction.weakening", "path_weakening"},
        {"interface.hardening", "path_forces"},
        {"friction.temperature", "rolling_hot_friction"},
        {"indenter.heat", "rolling_temperature"},
        {"substrate.heat", "rolling_temperature"},
        {"tractive_rolling", "rolling_spin"},
        {"tractive_rolling.speed", "rolling_relaxing"},
        {"output.volume_depth", "rig_sphere_inside"}};
    for (const std::string_view key : {path, section_of(path)})
        if (const auto found = cases.find(key); found != cases.end()) return found->second;
    return {};
}

TEST(CaseKeys, EveryKeyHasAMeaningAndAnExampleThatIsAccepted) {
    for (const Key& key : case_keys()) {
        EXPECT_FALSE(key.text.empty()) << key.path;
        if (key.path == "substrate.relaxation.dma") continue;   // a file: io_relaxation.cc
        if (key.path == "substrate.relaxation.test") continue;  // a file: cli/answers/tables.sh
        if (key.path == "bem.influence") continue;              // a file: cli/runs/influence.sh
        if (key.path == "indenter.file" || key.path == "indenter.spacing" ||
            key.path == "indenter.unit" || key.path == "indenter.heights")
            continue;  // files: cli/runs/bodies.sh, cli/input/height_maps.sh
        if (key.path == "friction.map") continue;  // a file: cli/runs/friction_map.sh
        if (key.path == "path.file") continue;     // a file: cli/runs/path.sh
        if (const std::string name = case_of(key.path); !name.empty()) {
            const std::string example = std::string(key.path) + '=' + std::string(key.example);
            std::vector<std::string> overrides{example};
            if (key.path == "friction.rate.memory_speed")
                overrides.emplace_back(R"(friction.rate.memory_length="3 um")");
            if (key.path == "adhesion.range" || key.path == "adhesion.peak_stress" ||
                key.path == "adhesion.law")
                overrides.emplace_back(R"(models=["bem"])");
            if (key.path == "bem.adhesive_edge")
                for (const char* one : {R"(models=["bem"])", R"(adhesion.approach_work="0 J/m2")"})
                    overrides.emplace_back(one);
            if (key.path == "adhesion.law") overrides.emplace_back(R"(adhesion.range="1 um")");
            if (key.path == "indenter.height")
                for (const char* one :
                     {R"(indenter.young="2 MPa")", "indenter.poisson=0.5", R"(models=["bem"])",
                      R"(indenter.body="punch")", R"(indenter.support="holder")"})
                    overrides.emplace_back(one);
            if (key.section() == "upper_plate" && key.path != "upper_plate.rigid")
                for (const char* one :
                     {R"(models=["fem-axisymmetric"])", R"(indenter.young="2 MPa")",
                      "indenter.poisson=0.3", R"(indenter.body="ball")",
                      R"(indenter.support="plates")", R"(upper_plate.young="5.2 MPa")",
                      "upper_plate.poisson=0.3", R"(upper_plate.thickness="8 mm")",
                      "load.tangential_ratio=0"})
                    if (!std::string_view(one).starts_with(key.path)) overrides.emplace_back(one);
            if (key.path == "interface.hardening") {
                overrides.emplace_back(R"(interface.yield_stress="2 MPa")");
                overrides.emplace_back(R"(models=["bem"])");
            }
            EXPECT_NO_THROW(
                read_case(paths::source("examples/cases/") + name + ".toml", overrides));
            continue;
        }
        std::vector<std::string> overrides;
        for (const Key* one : with_companions(key))
            overrides.push_back(std::string(one->path) + "=" +
                                std::string(key.section() == "ground" && one != &key &&
                                                    one->path == "substrate.base"
                                                ? R"("half-space")"
                                                : one->example));
        if (key.path == "bem.period") {
            overrides.emplace_back(R"(models=["bem-layer"])");
            overrides.emplace_back(R"(substrate.thickness="8 mm")");
        }
        EXPECT_NO_THROW(parse_case(rolling_case, "rolling.toml", overrides)) << key.path;
    }
}

}  // namespace
}  // namespace tricontact::io::case_key_examples_test
