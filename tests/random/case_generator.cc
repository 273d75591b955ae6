#include "tests/random/case_generator.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <random>
#include <string_view>

#include "contact/substrates/material.h"

namespace tricontact::random_cases {

namespace {

/// Draws of the same bits with every standard library.
class Dice {
  public:
    Dice(std::uint64_t seed, std::uint64_t index) {
        std::seed_seq mixed{seed, seed >> 32, index, index >> 32};
        bits_.seed(mixed);
    }
    double uniform(double low, double high) {
        return low + (high - low) * static_cast<double>(bits_() >> 11) * 0x1p-53;
    }
    double scale(double low, double high) {
        return std::exp(uniform(std::log(low), std::log(high)));
    }
    int whole(int low, int high) {  // both included
        return low + static_cast<int>(uniform(0, 1) * (high - low + 1));
    }
    bool chance(double probability) { return uniform(0, 1) < probability; }
    template <class... Values>
    auto one_of(Values... values) {
        const std::common_type_t<Values...> all[] = {values...};
        return all[whole(0, sizeof...(values) - 1)];
    }

  private:
    std::mt19937_64 bits_;
};

/// Near the ends of its range as often as inside.
double drawn_poisson(Dice& dice) {
    if (dice.chance(.3)) return .5;
    if (dice.chance(.15)) return .5 - dice.scale(1e-8, 1e-2);
    return dice.uniform(-.9, .5);
}

double drawn_tangential_ratio(Dice& dice) {
    if (dice.chance(.05)) return 0;
    if (dice.chance(.3)) return 1 - dice.scale(1e-9, 1e-1);
    if (dice.chance(.15)) return dice.scale(1e-9, 1e-1);
    return dice.uniform(0, 1);
}

double drawn_angle(Dice& dice) {
    constexpr double pi = std::numbers::pi;
    return dice.chance(.5) ? dice.one_of(0., pi / 2, pi) : dice.uniform(-2 * pi, 2 * pi);
}

class Drawing {
  public:
    Drawing(std::uint64_t seed, std::uint64_t index) : dice_(seed, index), further_(~seed, index) {}

    std::string text() {
        model_ = dice_.one_of("mdr", "mdr", "mdr", "bem", "bem", "bem", "mdr-layer", "bem-layer");
        is_mdr_ = model_.starts_with("mdr");
        is_layered_ = model_.ends_with("layer");
        add("models = [\"{}\"]\n", model_);
        draw_indenter();
        draw_substrate();
        friction_ = dice_.scale(1e-6, 10);
        add("[friction]\ncoefficient = {}\n", friction_);
        draw_contact();
        draw_load();
        draw_rolling();
        draw_discretisation();
        draw_layer_between();
        return std::move(text_);
    }

  private:
    template <class... Arguments>
    void add(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
        fmt::format_to(std::back_inserter(text_), format, std::forward<Arguments>(arguments)...);
    }

    // The radius of contact is a, but for the shape's own factor near 1.
    void draw_indenter() {
        const double radius = dice_.scale(1e-9, 1e3);
        radius_ = radius * dice_.scale(1e-4, .4);
        const double slope = radius_ / radius;
        const int shape = dice_.chance(.6) ? 0 : dice_.whole(1, is_mdr_ ? 4 : 5);
        add("[indenter]\n");
        switch (shape) {
            case 0:
                add("shape = \"paraboloid\"\nradius = \"{} m\"\n", radius);
                break;
            case 1:
                add("shape = \"sphere\"\nradius = \"{} m\"\n", radius);
                break;
            case 2:
                add("shape = \"cone\"\nangle = \"{} rad\"\n", slope);
                break;
            case 3:
                add("shape = \"power-law\"\nradius = \"{} m\"\nexponent = {}\n", radius_,
                    dice_.uniform(1.2, 8));
                break;
            case 4:
                add("shape = \"rounded-punch\"\nradius = \"{} m\"\nflat_radius = \"{} m\"\n",
                    radius, radius_ * dice_.uniform(.2, .9));
                break;
            default:
                add("shape = \"ellipsoid\"\nradius = \"{} m\"\nradius_y = \"{} m\"\n", radius,
                    radius * dice_.scale(.2, 5));
        }
        depth_ = shape == 3 ? radius_ * dice_.scale(1e-4, .1) : radius_ * slope;
        if (shape == 3 || !dice_.chance(.3)) return;
        indenter_ = {dice_.scale(1, 1e12), drawn_poisson(dice_)};
        add("young = \"{} Pa\"\npoisson = {}\n", indenter_->young, indenter_->poisson);
    }

    void draw_substrate() {
        substrate_ = {dice_.scale(1, 1e12), drawn_poisson(dice_)};
        if (is_mdr_ && dice_.chance(.7) && !indenter_) substrate_.poisson = .5;
        add("[substrate]\nyoung = \"{} Pa\"\npoisson = {}\n", substrate_.young, substrate_.poisson);
        if (is_layered_) draw_layers();
        draw_relaxation();
    }

    void draw_layers() {
        thickness_ = radius_ * (is_mdr_ ? dice_.scale(1e-2, 1e4) : dice_.scale(1e-3, 1e4));
        const std::string_view base =
            is_mdr_ ? dice_.one_of("bonded", "bonded", "half-space")
                    : dice_.one_of("bonded", "bonded", "frictionless", "half-space");
        add("thickness = \"{} m\"\nbase = \"{}\"\n", thickness_, base);
        if (dice_.chance(.2))
            add("[lower_layer]\nthickness = \"{} m\"\nyoung = \"{} Pa\"\npoisson = {}\n",
                thickness_ * dice_.scale(.1, 10), substrate_.young * dice_.scale(1e-2, 1e2),
                drawn_poisson(dice_));
        if (base == "half-space")
            add("[ground]\nyoung = \"{} Pa\"\npoisson = {}\n",
                substrate_.young * dice_.scale(1e-2, 1e4), drawn_poisson(dice_));
    }

    void draw_relaxation() {
        relaxes_ = dice_.chance(.15);
        if (!relaxes_) return;
        const double shear_modulus = substrate_.young / 2 / (1 + substrate_.poisson);
        time_ = dice_.scale(1e-6, 1e6);
        add("[substrate.relaxation]\nmoduli = [\"{} Pa\", \"{} Pa\"]\ntimes = [\"{} s\", \"{} "
            "s\"]\n",
            shear_modulus * dice_.scale(.01, 10), shear_modulus * dice_.scale(.01, 10), time_,
            time_ * dice_.scale(2, 100));
    }

    void draw_contact() {
        // MDR has no coupling: a case that has must leave it out.
        const bool coupled = is_mdr_ ? false : dice_.chance(.8);
        add("[contact]\ncoupling = {}\n", coupled);
    }

    void draw_load() {
        const double modulus = contact::MaterialPair(indenter_, substrate_).effective_modulus();
        add("[load]\n");
        if (dice_.chance(.6))
            add("normal_force = \"{} N\"\n", 4. / 3 * modulus * radius_ * depth_);
        else
            add("indentation = \"{} m\"\n", depth_);
        double ratio = drawn_tangential_ratio(dice_);
        oscillates_ = dice_.chance(.2);
        if (oscillates_) {
            const double normal = dice_.uniform(0, .9), tangential = dice_.uniform(0, 2);
            ratio *= (1 - normal) / (1 + tangential);  // below mu F_N everywhere
            add("normal_amplitude_ratio = {}\nnormal_phase = \"{} rad\"\n"
                "tangential_amplitude_ratio = {}\ntangential_phase = \"{} rad\"\n",
                normal, dice_.uniform(-6, 6), tangential, dice_.uniform(-6, 6));
        }
        add("tangential_ratio = {}\npress_steps = {}\n", ratio, dice_.whole(1, 4));
        if (dice_.chance(.2)) add("press = \"frictionless\"\n");
        if (!relaxes_) return;
        if (dice_.chance(.5)) add("press_time = \"{} s\"\n", time_ * dice_.scale(.01, 100));
        if (dice_.chance(.3)) add("hold = \"{} s\"\n", time_ * dice_.scale(.01, 100));
    }

    void draw_rolling() {
        const double ratio = dice_.scale(.001, 1.2);
        add("[rolling]\namplitude_ratio = {}\nangle = \"{} rad\"\nperiods = {}\nrun_all = {}\n",
            ratio, drawn_angle(dice_), dice_.whole(1, 3), dice_.chance(.5));
        if (!oscillates_ && !relaxes_ && dice_.chance(.2))
            add("steps = \"turning-points\"\n");
        else
            add("steps_per_quarter = {}\n", dice_.whole(1, 4));
        if (dice_.chance(.1)) add("amplitude_reference = \"model\"\n");
        if (relaxes_) add("speed = \"{} m/s\"\n", ratio * radius_ / time_ * dice_.scale(.01, 100));
    }

    /// A layer between the surfaces that yields and hardens, of points that know their slip: within
    /// a flow of the order of the contact.
    void draw_layer_between() {
        if (is_mdr_ || relaxes_ || !further_.chance(1)) return;
        const double modulus = contact::MaterialPair(indenter_, substrate_).effective_modulus();
        add("[interface]\nyield_stress = \"{} Pa\"\nhardening = \"{} Pa/m\"\n",
            std::max(friction_ * modulus * depth_ / radius_ * further_.scale(1e-2, 1), 1e-300),
            std::min(modulus / radius_ * further_.scale(1e-1, 1e6), 1e20));
    }

    void draw_discretisation() {
        if (is_mdr_)
            add("[mdr]\nsprings = {}\n", static_cast<int>(dice_.scale(100, 3e5)));
        else
            add("[bem]\ncells_per_radius = {}\n", dice_.uniform(4, is_layered_ ? 8 : 12));
    }

    Dice dice_;
    Dice further_;  // what was added later leaves the draws before as they are
    double friction_ = 0;
    std::string text_;
    std::string_view model_;
    bool is_mdr_ = false, is_layered_ = false, relaxes_ = false, oscillates_ = false;
    double radius_ = 0;     // of the contact [m]
    double depth_ = 0;      // d [m]
    double thickness_ = 0;  // b [m]
    double time_ = 0;       // of relaxation [s]
    std::optional<contact::Material> indenter_;
    contact::Material substrate_{0, 0};
};

}  // namespace

std::string random_case(std::uint64_t seed, std::uint64_t index) {
    return Drawing(seed, index).text();
}

}  // namespace tricontact::random_cases
