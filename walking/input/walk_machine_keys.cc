#include "walking/input/walk_key_declarations.h"

namespace tricontact::walking {

namespace {

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

void add_machine_keys(std::vector<WalkKey>& keys) {
    add_model(keys);
    add_kappas(keys);
    add_body(keys);
    add_stiffnesses(keys);
    add_motion(keys);
}

}  // namespace tricontact::walking
