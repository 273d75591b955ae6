#include "experiments/identification/layer_contact.h"

#include <cmath>
#include <map>
#include <memory>
#include <mutex>

#include "report/lazy_table.h"

namespace tricontact::experiments {

namespace {

using contact::Case;
using contact::NormalControl;
using report::LazyTable;
using theory::AbelLayer;

constexpr double logarithmic_step = .2;
// Of E*/(k_n b): softer ones are refused by no table, stiffer ones are rigid to 1e-6.
constexpr int stiffest_row = -70, softest_row = 60;
constexpr double rigid_compliance = 1e-6;

/// Contacts of one Poisson's ratio, in units of E*, b and R: the logarithms of F R/(E* b^3), a/b
/// and d R/b^2 over that of the force or depth, and over that of E*/(k_n b).
class LayerPresses {
  public:
    explicit LayerPresses(double poisson)
        : layer_(theory::make_abel_layer(poisson)),
          rigid_{table(NormalControl::Kind::force, false),
                 table(NormalControl::Kind::indentation, false)},
          sprung_{table(NormalControl::Kind::force, true),
                  table(NormalControl::Kind::indentation, true)} {}
    LayerPresses(const LayerPresses&) = delete;  // its tables call it back
    LayerPresses& operator=(const LayerPresses&) = delete;

    AbelLayer& layer() { return *layer_; }

    Pressed at(const NormalControl& control, double compliance) {
        const std::scoped_lock lock(mutex_);
        const int kind = control.kind == NormalControl::Kind::force ? 0 : 1;
        const auto logs =
            compliance > rigid_compliance
                ? sprung_[kind].at(std::log(control.value), std::log(compliance) / logarithmic_step)
                : rigid_[kind].at(std::log(control.value), 0);
        return {std::exp(logs[0]), std::exp(logs[1]), std::exp(logs[2])};
    }

  private:
    LazyTable table(NormalControl::Kind kind, bool has_springs) {
        return {[this, kind, has_springs](double x, double row) {
                    const theory::SprungPress press = theory::press_on_layer(
                        1, 1, has_springs ? std::exp(logarithmic_step * row) : 0.,
                        {kind, std::exp(x)}, 1, *layer_);
                    return std::vector<double>{std::log(press.normal_force),
                                               std::log(press.contact_radius),
                                               std::log(press.indentation)};
                },
                logarithmic_step, 1,
                has_springs ? LazyTable::Rows{stiffest_row, softest_row} : LazyTable::Rows{0, 0}};
    }

    std::shared_ptr<AbelLayer> layer_;
    LazyTable rigid_[2], sprung_[2];
    std::mutex mutex_;
};

LayerPresses& presses_of(double poisson) {
    static std::map<double, std::unique_ptr<LayerPresses>> all;
    static std::mutex mutex;
    const std::scoped_lock lock(mutex);
    auto& one = all[poisson];
    if (!one) one = std::make_unique<LayerPresses>(poisson);
    return *one;
}

}  // namespace

bool is_beyond_coulomb(const Case& rig) {
    return rig.interface.is_elastic() || !rig.friction.is_coulomb();
}

std::string why_no_layer_contact(const Case& rig) {
    constexpr double rigid_ratio = 1e-3;
    if (rig.indenter.shape != Case::Shape::paraboloid)
        return "indenter.shape: a paraboloid is computed; a sphere is one near its tip";
    if (rig.indenter.roughness) return "indenter.roughness: a smooth paraboloid is computed";
    if (rig.layer.base != Case::Base::bonded || !rig.layer.lower.empty())
        return "substrate.base: one layer that is bonded to a rigid ground is computed";
    if (rig.layer.width || rig.layer.depth || rig.period)
        return "substrate.width: an infinitely wide layer under one indenter is computed";
    if (rig.indenter.material &&
        rig.indenter.material->plane_compliance() > rigid_ratio * rig.substrate.plane_compliance())
        return "indenter.young: a rigid indenter is computed";
    return {};
}

Pressed layer_press(const Case& rig, const NormalControl& control) {
    const double b = *rig.layer.thickness, radius = rig.indenter.radius;
    const double modulus = 1 / rig.substrate.plane_compliance();
    const double force = modulus * b * b * b / radius, height = b * b / radius;
    const bool is_force = control.kind == NormalControl::Kind::force;
    const Pressed unit = presses_of(rig.substrate.poisson)
                             .at({control.kind, control.value / (is_force ? force : height)},
                                 modulus * rig.interface.normal_compliance() / b);
    return {unit.normal_force * force, unit.contact_radius * b, unit.indentation * height};
}

theory::SprungContact layer_contact(const Case& rig, double normal_force) {
    const contact::MaterialPair layer({}, rig.substrate);
    return {rig.friction,
            rig.interface,
            layer_press(rig, {NormalControl::Kind::force, normal_force}).contact_radius,
            normal_force,
            layer.effective_modulus(),
            layer.effective_shear_modulus(),
            *rig.layer.thickness,
            presses_of(rig.substrate.poisson).layer()};
}

}  // namespace tricontact::experiments
