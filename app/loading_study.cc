#include "app/loading_study.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <functional>
#include <stdexcept>

#include "contact/run.h"

namespace tricontact::app {

namespace {

using comparisons::StaticVariant;
using contact::Case;

const char* name_of(Case::Kinematics kinematics) {
    return kinematics == Case::Kinematics::linear ? "linear" : "deformed";
}
const char* name_of(bool yes) {
    return yes ? "true" : "false";
}
const char* name_of(Case::Press press) {
    return press == Case::Press::friction ? "friction" : "frictionless";
}

constexpr Case::Contact uncoupled{.coupling = false, .kinematics = Case::Kinematics::linear};

/// Normal traction displaces tangentially in the model's bodies, whether the case asks for it or
/// not.
bool is_elastically_coupled(const contact::Model& model) {
    const auto coupled = model.sibling({.coupling = true, .kinematics = Case::Kinematics::linear});
    return coupled && coupled->is_coupled();
}

/// Flips the key's value in `c` and notes both.
template <class Value>
void change(Value& value, Value other, StaticVariant& variant) {
    variant.chosen = name_of(value);
    variant.changed = name_of(other);
    value = other;
}

void load_once_more(const Case& c, const contact::Model& model, StaticVariant& variant) {
    try {
        const auto sibling = model.sibling(c.contact);
        variant.changed_shift = contact::run(c, *sibling).static_shift;
    } catch (const std::runtime_error& error) {  // the run itself is none the worse for it
        variant.why_none = error.what();
    }
}

/// dF/dd = F/d times the slope of ln F over ln d, which is nearly straight: at the last of three
/// points on their parabola.
double stiffness_at_last(const std::array<contact::StepRecord, 3>& pressed) {
    std::array<double, 3> x{}, y{};
    for (int k = 0; k < 3; ++k) {
        x[k] = std::log(pressed[k].indentation);
        y[k] = std::log(pressed[k].normal_force);
    }
    const double first = (y[1] - y[0]) / (x[1] - x[0]), second = (y[2] - y[1]) / (x[2] - x[1]);
    const double slope = second + (second - first) * (x[2] - x[1]) / (x[2] - x[0]);
    return pressed[2].normal_force / pressed[2].indentation * slope;
}

double frictionless_stiffness(const Case& c, const contact::Model& model) {
    // Nodes join the contact one by one: wider steps average over that, and the parabola is good to
    // 1e-3 over this range.
    constexpr std::array shares{0.6, 0.8, 1.0};
    const auto sibling = model.sibling(uncoupled);
    std::array<contact::StepRecord, 3> pressed;
    for (int k = 0; k < 3; ++k) {
        contact::LoadStep step = contact::press_step(c);
        step.normal.value *= shares[k];
        step.friction = false;
        pressed[k] = sibling->advance(step);
    }
    return stiffness_at_last(pressed);
}

/// One loading after another with one key changed.
class Variants {
  public:
    using Flip = std::function<void(Case&, StaticVariant&)>;

    Variants(const Case& c, const contact::Model& model, const contact::History& history,
             const Say& say, std::vector<StaticVariant>& variants)
        : case_(c), model_(model), history_(history), say_(say), variants_(variants) {}

    void add(const char* key, const Flip& flip) {
        StaticVariant variant;
        variant.model = history_.model;
        variant.key = key;
        variant.static_shift = history_.static_shift;
        Case still = case_;
        still.rolling.reset();
        flip(still, variant);
        say_(fmt::format("{}: loading once more with {} = {}", history_.model, key,
                         variant.changed));
        load_once_more(still, model_, variant);
        variants_.push_back(std::move(variant));
    }

  private:
    const Case& case_;
    const contact::Model& model_;
    const contact::History& history_;
    const Say& say_;
    std::vector<StaticVariant>& variants_;
};

void flip_kinematics(Case& still, StaticVariant& v) {
    const bool linear = still.contact.kinematics == Case::Kinematics::linear;
    change(still.contact.kinematics, linear ? Case::Kinematics::deformed : Case::Kinematics::linear,
           v);
}
void flip_coupling(Case& still, StaticVariant& v) {
    change(still.contact.coupling, !still.contact.coupling, v);
}
void flip_press(Case& still, StaticVariant& v) {
    const bool friction = still.load.press == Case::Press::friction;
    change(still.load.press, friction ? Case::Press::frictionless : Case::Press::friction, v);
}

}  // namespace

void study_loading(const Case& c, const contact::Model& model, const contact::History& history,
                   const Say& say, comparisons::LoadingStudy& study) {
    const bool elastic = is_elastically_coupled(model);
    if (!elastic && !model.is_coupled()) return;
    Variants variants(c, model, history, say, study.variants);
    variants.add("contact.kinematics", flip_kinematics);
    if (elastic) variants.add("contact.coupling", flip_coupling);
    if (model.is_coupled()) variants.add("load.press", flip_press);
    study.normal_stiffness[history.model] = frictionless_stiffness(c, model);
}

}  // namespace tricontact::app
