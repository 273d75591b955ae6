#include "walking/input/walk_keys.h"

#include <algorithm>

#include "io/case/rig_keys.h"

namespace tricontact::walking {

namespace {

using contact::Material;
using io::at;
using Keys = std::vector<WalkKey>;

constexpr double large = 1e9;

/// Place of a stiffness of a dimensional machine that is its own.
template <double DimensionalMachine::*member>
io::Field own_stiffness(WalkCase& c) {
    return c.input.contact ? io::Field() : io::in(c.dimensional, member);
}

/// Place of a kappa in a case whose machine has no dimensions.
template <double Kappas::*member>
io::Field kappa(WalkCase& c) {
    return c.dimensional ? io::Field() : io::Field(&(c.machine.kappas.*member));
}

/// A number with a default.
io::Key number(std::string_view path, const io::Range& range, std::string_view default_value,
               std::string_view example, std::string_view text) {
    return io::number_key(path, range, example, text, {.default_value = default_value});
}

Keys model_keys() {
    using Model = Machine::Model;
    return {{io::choice_key("machine.model",
                            {io::choice("two-spot", Model::two_spot),
                             io::choice("prism", Model::prism), io::choice("spots", Model::spots)},
                            R"("two-spot")",
                            "contact spots: one at each end of the base, the same in a prism of "
                            "45 degrees, or those of [spots]",
                            {.default_value = R"("two-spot")"}),
             at<&WalkCase::machine, &Machine::model>},
            {io::quantity_key("machine.tilting_angle", io::Dimension::angle, io::above_zero(1e6),
                              R"("0.1 rad")",
                              "rotation above which it counts as tilting: the run ends there",
                              {.default_value = R"("0.1 rad")"}),
             at<&WalkCase::machine, &Machine::tilting_angle>}};
}

Keys kappa_keys() {
    const auto key = [](std::string_view path, io::Range range, std::string_view example,
                        std::string_view text, std::string_view reason = {}) {
        return io::number_key(path, range, example, text, {.reason = reason, .required = true});
    };
    return {
        {key("machine.kappa1", io::above_zero(large), "2",
             "k_s/k_x, spring of the base over contact spot"),
         kappa<&Kappas::kappa1>},
        {key("machine.kappa2", io::above_zero(large), "1.2",
             "k_z/k_x, normal over tangential stiffness",
             "the static displacement kappa4/(2 kappa2) is the unit of lengths"),
         kappa<&Kappas::kappa2>},
        {key("machine.kappa3", io::above_zero(large), "0.5", "a/b, half height over half width",
             "phi is (a/b) times the angle"),
         kappa<&Kappas::kappa3>},
        {key("machine.kappa4", io::above_zero(large), "1e-4", "m g/(k_x b), weight",
             "without weight there is no friction"),
         kappa<&Kappas::kappa4>},
        {key("machine.kappa5", io::from_zero(100), "0.68", "Coulomb's coefficient of friction mu"),
         kappa<&Kappas::kappa5>},
        {key("machine.kappa6", io::from_zero(large), "1e-4",
             "(v_0/b) sqrt(m/k_x), velocity of the base"),
         kappa<&Kappas::kappa6>},
        {key("machine.kappa7", io::above_zero(large), "0.42", "Theta/(m b^2), moment of inertia",
             "rotation divides by it"),
         kappa<&Kappas::kappa7>},
        {key("machine.kappa8", {-1000, 1000}, "1.18",
             "h/a, where the spring pulls: above the centre of gravity, negative below"),
         kappa<&Kappas::kappa8>}};
}

Keys dimension_keys() {
    using enum io::Dimension;
    using D = DimensionalMachine;
    constexpr auto si = &WalkCase::dimensional;
    const auto key = [](std::string_view path, io::Dimension of, std::string_view example,
                        std::string_view text) {
        return io::quantity_key(path, of, io::above_zero(large), example, text, {.required = true});
    };
    return {
        {key("machine.mass", mass, R"("490 g")", "mass m"), at<si, &D::mass>},
        {key("machine.half_height", length, R"("21.2 mm")", "half height a"),
         at<si, &D::half_height>},
        {key("machine.half_width", length, R"("14 mm")", "half width b"), at<si, &D::half_width>},
        {key("machine.moment_of_inertia", moment_of_inertia, R"("1.7e-4 kg m2")",
             "moment of inertia Theta about the centre of gravity"),
         at<si, &D::moment_of_inertia>},
        {key("machine.spring_stiffness", io::Dimension::stiffness, R"("4.34e6 N/m")",
             "stiffness k_s of the spring that drags"),
         at<si, &D::spring_stiffness>},
        {io::quantity_key("machine.tangential_stiffness", io::Dimension::stiffness,
                          io::above_zero(1e15), R"("2.2e6 N/m")", "k_x of one contact spot",
                          {.alternative = spot_stiffness}),
         own_stiffness<&D::tangential_stiffness>},
        {io::quantity_key("machine.normal_stiffness", io::Dimension::stiffness,
                          io::above_zero(1e15), R"("2.9e6 N/m")", "k_z of one contact spot",
                          {.required = true, .needs = "machine.tangential_stiffness"}),
         own_stiffness<&D::normal_stiffness>},
        {io::number_key("machine.friction_coefficient", io::from_zero(100), "0.75",
                        "Coulomb's coefficient of friction mu", {.required = true}),
         at<si, &D::friction_coefficient>},
        {io::quantity_key("machine.base_velocity", velocity, io::from_zero(1e6), R"("40 mm/s")",
                          "velocity v_0 of the spring's base", {.required = true}),
         at<si, &D::base_velocity>},
        {io::quantity_key("machine.lever_arm", length, {-1e6, 1e6}, R"("-10 mm")",
                          "height h of the spring above the centre of gravity",
                          {.alternative = lever_arm}),
         [](WalkCase& c) { return c.input.height_ratio ? io::Field() : at<si, &D::lever_arm>(c); }},
        {io::number_key("machine.height_ratio", {-1000, 1000}, "-0.47",
                        "h/a, the same over the half height", {.alternative = lever_arm}),
         [](WalkCase& c) {
             return c.dimensional ? io::Field(&c.input.height_ratio) : io::Field();
         }},
        {io::quantity_key("machine.gravity", acceleration, io::above_zero(1e6), R"("9.81 m/s2")",
                          "acceleration g of gravity", {.default_value = R"("9.81 m/s2")"}),
         at<si, &D::gravity>}};
}

Keys contact_keys() {
    constexpr std::string_view diameter = "contact.diameter";
    constexpr auto part = &WalkCase::Input::contact;
    return {{io::length_key(diameter, R"("1.8 mm")",
                            "diameter D_c of a contact: k_z = E* D_c, k_x = G* D_c",
                            {.alternative = spot_stiffness}),
             [](WalkCase& c) { return io::in(c.input.contact, &SpotContact::diameter); }},
            {io::modulus_key("contact.young", R"("1.4 GPa")", "Young's modulus of the machine",
                             {.required = true, .needs = diameter}),
             at<&WalkCase::input, part, &SpotContact::body, &Material::young>},
            {io::poisson_key("contact.poisson", "0.3", "Poisson's ratio of the machine",
                             {.required = true, .needs = diameter}),
             at<&WalkCase::input, part, &SpotContact::body, &Material::poisson>},
            {io::modulus_key("contact.substrate_young", R"("90 GPa")",
                             "Young's modulus of the substrate; without it the substrate is rigid",
                             {.needs = diameter}),
             at<&WalkCase::input, part, &SpotContact::substrate, &Material::young>},
            {io::poisson_key("contact.substrate_poisson", "0.3", "Poisson's ratio of the substrate",
                             {.needs = diameter}),
             at<&WalkCase::input, part, &SpotContact::substrate, &Material::poisson>}};
}

Keys spot_keys() {
    using Input = WalkCase::Input;
    return {{io::list_of(io::number_key("spots.positions", {-1000, 1000}, "[-1, 0, 1]",
                                        "along the base from its middle, in units of b")),
             at<&WalkCase::input, &Input::positions>},
            {io::list_of(
                 io::number_key("spots.heights", {0, 1000}, "[0, 1e-5, 0]",
                                "of the tips above the lowest one, in units of b; without it all 0",
                                {.needs = "spots.positions"})),
             at<&WalkCase::input, &Input::heights>},
            {io::list_of(io::number_key("spots.stiffnesses", io::above_zero(1e9), "[1, 0.5, 1]",
                                        "normal in units of k_z, tangential of k_x; without it "
                                        "all 1",
                                        {.needs = "spots.positions"})),
             at<&WalkCase::input, &Input::stiffnesses>},
            {io::number_key("bed.radius", io::above_zero(1e9), "0.5",
                            "radius R of the tips, in units of b", {.required = true}),
             at<&WalkCase::machine, &Machine::bed, &Bed::radius>},
            {io::integer_key("bed.springs", {1, 10000}, "40", "springs of each spot",
                             {.default_value = "40", .needs = "bed.radius"}),
             at<&WalkCase::machine, &Machine::bed, &Bed::springs>},
            {io::number_key(
                 "bed.width", {1, 1000}, "3",
                 "width of the bed over the diameter of the contact at rest; a tip ends there",
                 {.reason = "at rest the contact has a width of 1",
                  .default_value = "3.0",
                  .needs = "bed.radius"}),
             at<&WalkCase::machine, &Machine::bed, &Bed::width>}};
}

Keys mechanism_keys() {
    const auto key = [](std::string_view path, std::string_view text) {
        return io::boolean_key(path, "false", text, {.default_value = "true"});
    };
    constexpr auto mechanisms = &Machine::mechanisms;
    constexpr auto excitation = &Machine::excitation;
    return {{key("mechanisms.vertical", "vertical motion; else z stays at rest"),
             at<&WalkCase::machine, mechanisms, &Mechanisms::vertical>},
            {key("mechanisms.rotation", "rotation; else phi stays 0"),
             at<&WalkCase::machine, mechanisms, &Mechanisms::rotation>},
            {key("mechanisms.coupling",
                 "friction follows the normal forces; else mu times those at rest bounds it"),
             at<&WalkCase::machine, mechanisms, &Mechanisms::coupling>},
            {number("excitation.moment", io::from_zero(1e9), "0.0", "1e-5",
                    "amplitude of a moment sin(omega t) from outside, in units of k_x b^2"),
             at<&WalkCase::machine, excitation, &Excitation::moment>},
            {number("excitation.force", io::from_zero(1e9), "0.0", "1e-5",
                    "amplitude of a vertical force sin(omega t) from outside, in units of k_x b"),
             at<&WalkCase::machine, excitation, &Excitation::force>},
            {number("excitation.frequency", io::from_zero(1e9), "0.0", "1.5",
                    "omega of both, in units of sqrt(k_x/m)"),
             at<&WalkCase::machine, excitation, &Excitation::frequency>}};
}

Keys run_keys() {
    constexpr io::Range any{-1e6, 1e6};
    const auto velocity = [&](std::string_view path) {
        return number(path, any, "0.0", "1", "in velocities of the base");
    };
    return {{number("time.step", io::above_zero(1e3), "0.001", "1e-3",
                    "step of the integration, in units of sqrt(m/k_x)"),
             at<&WalkCase::time, &WalkCase::Time::step>},
            {io::number_key("time.end", io::above_zero(1e9), "20000",
                            "end of the run, in units of sqrt(m/k_x)",
                            {.default_value = "20000.0", .alternative = end_of_run}),
             [](WalkCase& c) { return c.input.duration ? io::Field() : io::Field(&c.time.end); }},
            {io::quantity_key("time.duration", io::Dimension::time, io::above_zero(1e9), R"("8 s")",
                              "the same of a machine with dimensions", {.alternative = end_of_run}),
             at<&WalkCase::input, &WalkCase::Input::duration>},
            {number("start.x", any, "0.0", "0.5", "displacement, in static displacements"),
             at<&WalkCase::start, &Start::x>},
            {number("start.z", any, "1.0", "1.5",
                    "downward displacement, in static displacements: 1 is at rest"),
             at<&WalkCase::start, &Start::z>},
            {number("start.phi", any, "0.0", "0.1",
                    "rotation (a/b) Phi, counter-clockwise, in static displacements"),
             at<&WalkCase::start, &Start::phi>},
            {number("start.base", any, "0.0", "2",
                    "displacement of the spring's base, in static displacements"),
             at<&WalkCase::start, &Start::base>},
            {velocity("start.x_velocity"), at<&WalkCase::start, &Start::x_velocity>},
            {velocity("start.z_velocity"), at<&WalkCase::start, &Start::z_velocity>},
            {velocity("start.phi_velocity"), at<&WalkCase::start, &Start::phi_velocity>},
            {io::integer_key("output.frames", {0, 10000}, "100",
                             "of the animation for ParaView; 0: none", {.default_value = "100"}),
             at<&WalkCase::frames>}};
}

}  // namespace

const std::vector<WalkKey>& walk_keys() {
    static const Keys keys = [] {
        Keys all{{io::text_key("title", R"("Set B walks")", "what the case is",
                               {.default_value = "\"\""}),
                  at<&WalkCase::title>}};
        for (const Keys& more : {model_keys(), kappa_keys(), dimension_keys(), contact_keys(),
                                 spot_keys(), mechanism_keys(), run_keys()})
            all.insert(all.end(), more.begin(), more.end());
        return all;
    }();
    return keys;
}

const io::KeyList& walk_key_list() {
    static const io::KeyList list(walk_keys(), "docs/reference/walking.md");
    return list;
}

const io::KeyList& walk_file_keys() {
    static const io::KeyList list = io::with_rig_keys(walk_key_list(), io::walking_rig_keys());
    return list;
}

bool is_dimensional(const io::Key& key) {
    if (key.section() == "contact" || key.path == "time.duration") return true;
    const auto keys = walk_key_list().keys();  // [machine]: those of any kind, kappas, then these
    const auto first = std::ranges::find(keys, "machine.mass", &io::Key::path);
    return key.section() == "machine" && std::find(first, keys.end(), &key) != keys.end();
}

}  // namespace tricontact::walking
