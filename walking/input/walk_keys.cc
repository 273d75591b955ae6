#include "walking/input/walk_keys.h"

#include <algorithm>

namespace tricontact::walking {

namespace {

using contact::Material;

// Place of a number of the contact's bodies: `body` is the machine's, else the substrate's.
template <double Material::*member>
io::Field of_body(WalkCase& c) {
    return c.input.contact ? io::Field(&(c.input.contact->body.*member)) : io::Field();
}
template <double Material::*member>
io::Field of_substrate(WalkCase& c) {
    return c.input.contact ? io::in(c.input.contact->substrate, member) : io::Field();
}

void add_contact(std::vector<WalkKey>& keys) {
    constexpr std::string_view diameter = "contact.diameter";
    keys.push_back({io::length_key(diameter, R"("1.8 mm")",
                                   "diameter D_c of a contact: k_z = E* D_c, k_x = G* D_c",
                                   {.alternative = spot_stiffness}),
                    [](WalkCase& c) { return io::in(c.input.contact, &SpotContact::diameter); }});
    keys.push_back(
        {io::modulus_key("contact.young", R"("1.4 GPa")", "Young's modulus of the machine",
                         {.required = true, .needs = diameter}),
         of_body<&Material::young>});
    keys.push_back({io::poisson_key("contact.poisson", "0.3", "Poisson's ratio of the machine",
                                    {.required = true, .needs = diameter}),
                    of_body<&Material::poisson>});
    keys.push_back(
        {io::modulus_key("contact.substrate_young", R"("90 GPa")",
                         "Young's modulus of the substrate; without it the substrate is rigid",
                         {.needs = diameter}),
         of_substrate<&Material::young>});
    keys.push_back({io::poisson_key("contact.substrate_poisson", "0.3",
                                    "Poisson's ratio of the substrate", {.needs = diameter}),
                    of_substrate<&Material::poisson>});
}

void add_spots(std::vector<WalkKey>& keys) {
    keys.push_back({io::list_of(io::number_key("spots.positions", {-1000, 1000}, "[-1, 0, 1]",
                                               "along the base from its middle, in units of b")),
                    [](WalkCase& c) -> io::Field { return &c.input.positions; }});
    keys.push_back({io::list_of(io::number_key(
                        "spots.heights", {0, 1000}, "[0, 1e-5, 0]",
                        "of the tips above the lowest one, in units of b; without it all 0",
                        {.needs = "spots.positions"})),
                    [](WalkCase& c) -> io::Field { return &c.input.heights; }});
    keys.push_back(
        {io::list_of(io::number_key("spots.stiffnesses", io::above_zero(1e9), "[1, 0.5, 1]",
                                    "normal in units of k_z, tangential of k_x; without it all 1",
                                    {.needs = "spots.positions"})),
         [](WalkCase& c) -> io::Field { return &c.input.stiffnesses; }});
}

void add_bed(std::vector<WalkKey>& keys) {
    keys.push_back({io::number_key("bed.radius", io::above_zero(1e9), "0.5",
                                   "radius R of the tips, in units of b", {.required = true}),
                    [](WalkCase& c) { return io::in(c.machine.bed, &Bed::radius); }});
    keys.push_back({io::integer_key("bed.springs", {1, 10000}, "40", "springs of each spot",
                                    {.default_value = "40", .needs = "bed.radius"}),
                    [](WalkCase& c) { return io::in(c.machine.bed, &Bed::springs); }});
    keys.push_back(
        {io::number_key(
             "bed.width", {1, 1000}, "3",
             "width of the bed over the diameter of the contact at rest; a tip ends there",
             {.reason = "at rest the contact has a width of 1",
              .default_value = "3.0",
              .needs = "bed.radius"}),
         [](WalkCase& c) { return io::in(c.machine.bed, &Bed::width); }});
}

void add_mechanisms(std::vector<WalkKey>& keys) {
    const auto add = [&](std::string_view path, std::string_view text,
                         io::Field (*field)(WalkCase&)) {
        keys.push_back({io::boolean_key(path, "false", text, {.default_value = "true"}), field});
    };
    add("mechanisms.vertical", "vertical motion; else z stays at rest",
        [](WalkCase& c) -> io::Field { return &c.machine.mechanisms.vertical; });
    add("mechanisms.rotation", "rotation; else phi stays 0",
        [](WalkCase& c) -> io::Field { return &c.machine.mechanisms.rotation; });
    add("mechanisms.coupling",
        "friction follows the normal forces; else mu times those at rest bounds it",
        [](WalkCase& c) -> io::Field { return &c.machine.mechanisms.coupling; });
}

void add_number(std::vector<WalkKey>& keys, std::string_view path, io::Range range,
                std::string_view default_value, std::string_view example, std::string_view text,
                io::Field (*field)(WalkCase&)) {
    keys.push_back(
        {io::number_key(path, range, example, text, {.default_value = default_value}), field});
}

void add_excitation(std::vector<WalkKey>& keys) {
    add_number(keys, "excitation.moment", io::from_zero(1e9), "0.0", "1e-5",
               "amplitude of a moment sin(omega t) from outside, in units of k_x b^2",
               [](WalkCase& c) -> io::Field { return &c.machine.excitation.moment; });
    add_number(keys, "excitation.force", io::from_zero(1e9), "0.0", "1e-5",
               "amplitude of a vertical force sin(omega t) from outside, in units of k_x b",
               [](WalkCase& c) -> io::Field { return &c.machine.excitation.force; });
    add_number(keys, "excitation.frequency", io::from_zero(1e9), "0.0", "1.5",
               "omega of both, in units of sqrt(k_x/m)",
               [](WalkCase& c) -> io::Field { return &c.machine.excitation.frequency; });
}

void add_time(std::vector<WalkKey>& keys) {
    add_number(keys, "time.step", io::above_zero(1e3), "0.001", "1e-3",
               "step of the integration, in units of sqrt(m/k_x)",
               [](WalkCase& c) -> io::Field { return &c.time.step; });
    keys.push_back(
        {io::number_key("time.end", io::above_zero(1e9), "20000",
                        "end of the run, in units of sqrt(m/k_x)",
                        {.default_value = "20000.0", .alternative = end_of_run}),
         [](WalkCase& c) { return c.input.duration ? io::Field() : io::Field(&c.time.end); }});
    keys.push_back(
        {io::quantity_key("time.duration", io::Dimension::time, io::above_zero(1e9), R"("8 s")",
                          "the same of a machine with dimensions", {.alternative = end_of_run}),
         [](WalkCase& c) -> io::Field { return &c.input.duration; }});
}

void add_start(std::vector<WalkKey>& keys) {
    constexpr io::Range any{-1e6, 1e6};
    add_number(keys, "start.x", any, "0.0", "0.5", "displacement, in static displacements",
               [](WalkCase& c) -> io::Field { return &c.start.x; });
    add_number(keys, "start.z", any, "1.0", "1.5",
               "downward displacement, in static displacements: 1 is at rest",
               [](WalkCase& c) -> io::Field { return &c.start.z; });
    add_number(keys, "start.phi", any, "0.0", "0.1",
               "rotation (a/b) Phi, counter-clockwise, in static displacements",
               [](WalkCase& c) -> io::Field { return &c.start.phi; });
    add_number(keys, "start.base", any, "0.0", "2",
               "displacement of the spring's base, in static displacements",
               [](WalkCase& c) -> io::Field { return &c.start.base; });
    add_number(keys, "start.x_velocity", any, "0.0", "1", "in velocities of the base",
               [](WalkCase& c) -> io::Field { return &c.start.x_velocity; });
    add_number(keys, "start.z_velocity", any, "0.0", "1", "in velocities of the base",
               [](WalkCase& c) -> io::Field { return &c.start.z_velocity; });
    add_number(keys, "start.phi_velocity", any, "0.0", "1", "in velocities of the base",
               [](WalkCase& c) -> io::Field { return &c.start.phi_velocity; });
}

void add_output(std::vector<WalkKey>& keys) {
    keys.push_back(
        {io::integer_key("output.frames", {0, 10000}, "100",
                         "of the animation for ParaView; 0: none", {.default_value = "100"}),
         [](WalkCase& c) -> io::Field { return &c.output.frames; }});
}

const std::vector<WalkKey>& declared_keys() {
    static const std::vector<WalkKey> keys = [] {
        std::vector<WalkKey> all;
        all.push_back({io::text_key("title", R"("Set B walks")", "what the case is",
                                    {.default_value = "\"\""}),
                       [](WalkCase& c) -> io::Field { return &c.title; }});
        add_machine_keys(all);
        add_contact(all);
        add_spots(all);
        add_bed(all);
        add_mechanisms(all);
        add_excitation(all);
        add_time(all);
        add_start(all);
        add_output(all);
        return all;
    }();
    return keys;
}

constexpr double large = 1e9;

void add_model(std::vector<WalkKey>& keys) {
    using Model = Machine::Model;
    keys.push_back(
        {io::choice_key("machine.model",
                        {io::choice("two-spot", Model::two_spot), io::choice("prism", Model::prism),
                         io::choice("spots", Model::spots)},
                        R"("two-spot")",
                        "contact spots: one at each end of the base, the same in a prism of "
                        "45 degrees, or those of [spots]",
                        {.default_value = R"("two-spot")"}),
         [](WalkCase& c) -> io::Field { return &c.machine.model; }});
    keys.push_back(
        {io::quantity_key("machine.tilting_angle", io::Dimension::angle, io::above_zero(1e6),
                          R"("0.1 rad")",
                          "rotation above which it counts as tilting: the run ends there",
                          {.default_value = R"("0.1 rad")"}),
         [](WalkCase& c) -> io::Field { return &c.machine.tilting_angle; }});
}

// Place of a kappa in a case whose machine has no dimensions.
template <double Kappas::*member>
io::Field kappa(WalkCase& c) {
    return c.dimensional ? io::Field() : io::Field(&(c.machine.kappas.*member));
}

void add_kappas(std::vector<WalkKey>& keys) {
    const auto add = [&](std::string_view path, io::Range range, std::string_view example,
                         std::string_view text, io::Field (*field)(WalkCase&),
                         std::string_view reason = {}) {
        keys.push_back(
            {io::number_key(path, range, example, text, {.reason = reason, .required = true}),
             field});
    };
    add("machine.kappa1", io::above_zero(large), "2",
        "k_s/k_x, spring of the base over contact spot", kappa<&Kappas::kappa1>);
    add("machine.kappa2", io::above_zero(large), "1.2", "k_z/k_x, normal over tangential stiffness",
        kappa<&Kappas::kappa2>, "the static displacement kappa4/(2 kappa2) is the unit of lengths");
    add("machine.kappa3", io::above_zero(large), "0.5", "a/b, half height over half width",
        kappa<&Kappas::kappa3>, "phi is (a/b) times the angle");
    add("machine.kappa4", io::above_zero(large), "1e-4", "m g/(k_x b), weight",
        kappa<&Kappas::kappa4>, "without weight there is no friction");
    add("machine.kappa5", io::from_zero(100), "0.68", "Coulomb's coefficient of friction mu",
        kappa<&Kappas::kappa5>);
    add("machine.kappa6", io::from_zero(large), "1e-4", "(v_0/b) sqrt(m/k_x), velocity of the base",
        kappa<&Kappas::kappa6>);
    add("machine.kappa7", io::above_zero(large), "0.42", "Theta/(m b^2), moment of inertia",
        kappa<&Kappas::kappa7>, "rotation divides by it");
    add("machine.kappa8", {-1000, 1000}, "1.18",
        "h/a, where the spring pulls: above the centre of gravity, negative below",
        kappa<&Kappas::kappa8>);
}

template <double DimensionalMachine::*member>
io::Field dimension(WalkCase& c) {
    return io::in(c.dimensional, member);
}

void add_body(std::vector<WalkKey>& keys) {
    const auto add = [&](std::string_view path, io::Dimension dimension, std::string_view example,
                         std::string_view text, io::Field (*field)(WalkCase&)) {
        keys.push_back({io::quantity_key(path, dimension, io::above_zero(large), example, text,
                                         {.required = true}),
                        field});
    };
    add("machine.mass", io::Dimension::mass, R"("490 g")", "mass m",
        dimension<&DimensionalMachine::mass>);
    add("machine.half_height", io::Dimension::length, R"("21.2 mm")", "half height a",
        dimension<&DimensionalMachine::half_height>);
    add("machine.half_width", io::Dimension::length, R"("14 mm")", "half width b",
        dimension<&DimensionalMachine::half_width>);
    add("machine.moment_of_inertia", io::Dimension::moment_of_inertia, R"("1.7e-4 kg m2")",
        "moment of inertia Theta about the centre of gravity",
        dimension<&DimensionalMachine::moment_of_inertia>);
    add("machine.spring_stiffness", io::Dimension::stiffness, R"("4.34e6 N/m")",
        "stiffness k_s of the spring that drags", dimension<&DimensionalMachine::spring_stiffness>);
}

void add_stiffnesses(std::vector<WalkKey>& keys) {
    keys.push_back({io::quantity_key("machine.tangential_stiffness", io::Dimension::stiffness,
                                     io::above_zero(1e15), R"("2.2e6 N/m")",
                                     "k_x of one contact spot", {.alternative = spot_stiffness}),
                    [](WalkCase& c) {
                        return c.input.contact ? io::Field()
                                               : io::in(c.dimensional,
                                                        &DimensionalMachine::tangential_stiffness);
                    }});
    keys.push_back(
        {io::quantity_key("machine.normal_stiffness", io::Dimension::stiffness,
                          io::above_zero(1e15), R"("2.9e6 N/m")", "k_z of one contact spot",
                          {.required = true, .needs = "machine.tangential_stiffness"}),
         [](WalkCase& c) {
             return c.input.contact ? io::Field()
                                    : io::in(c.dimensional, &DimensionalMachine::normal_stiffness);
         }});
}

void add_motion(std::vector<WalkKey>& keys) {
    keys.push_back({io::number_key("machine.friction_coefficient", io::from_zero(100), "0.75",
                                   "Coulomb's coefficient of friction mu", {.required = true}),
                    dimension<&DimensionalMachine::friction_coefficient>});
    keys.push_back(
        {io::quantity_key("machine.base_velocity", io::Dimension::velocity, io::from_zero(1e6),
                          R"("40 mm/s")", "velocity v_0 of the spring's base", {.required = true}),
         dimension<&DimensionalMachine::base_velocity>});
    keys.push_back(
        {io::quantity_key("machine.lever_arm", io::Dimension::length, {-1e6, 1e6}, R"("-10 mm")",
                          "height h of the spring above the centre of gravity",
                          {.alternative = lever_arm}),
         [](WalkCase& c) {
             return c.input.height_ratio ? io::Field()
                                         : io::in(c.dimensional, &DimensionalMachine::lever_arm);
         }});
    keys.push_back(
        {io::number_key("machine.height_ratio", {-1000, 1000}, "-0.47",
                        "h/a, the same over the half height", {.alternative = lever_arm}),
         [](WalkCase& c) {
             return c.dimensional ? io::Field(&c.input.height_ratio) : io::Field();
         }});
    keys.push_back(
        {io::quantity_key("machine.gravity", io::Dimension::acceleration, io::above_zero(1e6),
                          R"("9.81 m/s2")", "acceleration g of gravity",
                          {.default_value = R"("9.81 m/s2")"}),
         dimension<&DimensionalMachine::gravity>});
}

}  // namespace

std::span<const WalkKey> walk_keys() {
    return declared_keys();
}

const io::KeyList& walk_key_list() {
    static const io::KeyList list(declared_keys(), "docs/walking.md");
    return list;
}

bool is_dimensional(const io::Key& key) {
    constexpr std::string_view body = "machine.mass";
    if (key.section() == "contact" || key.path == "time.duration") return true;
    const auto keys = walk_key_list().keys();  // [machine]: those of any kind, kappas, then these
    const auto first = std::ranges::find(keys, body, &io::Key::path);
    return key.section() == "machine" && std::find(first, keys.end(), &key) != keys.end();
}

void add_machine_keys(std::vector<WalkKey>& keys) {
    add_model(keys);
    add_kappas(keys);
    add_body(keys);
    add_stiffnesses(keys);
    add_motion(keys);
}

}  // namespace tricontact::walking
