#include "fem/case/plates_model.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "contact/base/between_rows.h"
#include "contact/base/error.h"
#include "contact/base/state_bytes.h"
#include "contact/surface_audit.h"
#include "fem/case/model_of_revolution.h"

namespace tricontact::fem {

namespace {

using contact::Case;

constexpr int most_rounds = 60;
constexpr double of_tolerance = .1;  // of the solvers: what is left between both contacts

/// A body whose surface lies lower by what the pressures of its other side displace it, given at
/// points of one line, increasing.
class LoweredBody final : public contact::Indenter {
  public:
    LoweredBody(std::shared_ptr<const contact::Indenter> body, const std::vector<double>& x)
        : body_(std::move(body)), x_(x), raised_(x.size(), 0.) {}

    double height(double x, double y) const override { return body_->height(x, y) + raised_at(x); }
    contact::Vector2 slope(double x, double y) const override { return body_->slope(x, y); }
    bool presses_like_a_ball() const override { return body_->presses_like_a_ball(); }

    const std::vector<double>& raised() const { return raised_; }
    void raise(std::vector<double> by) { raised_ = std::move(by); }

  private:
    double raised_at(double x) const {
        return contact::between_rows(x_, raised_, std::clamp(x, x_.front(), x_.back()));
    }

    std::shared_ptr<const contact::Indenter> body_;
    std::vector<double> x_, raised_;
};

}  // namespace

/// One of both contacts.
class PlatesModel::Side {
  public:
    Side(const Setup& setup, std::shared_ptr<const contact::Compliance> compliance)
        : setup_(setup),
          compliance_(std::move(compliance)),
          body_(std::make_shared<LoweredBody>(setup.body, compliance_->points().x)) {
        make();
    }

    contact::Model& model() const { return *model_; }
    LoweredBody& body() const { return *body_; }
    /// On the points of the section [Pa].
    std::vector<double> pressure() const { return radial_->surface().normal_traction; }
    /// A model keeps what it was pressed to, and the surface has moved since.
    void restart(const std::string& state) {
        make();
        model_->read_state(state);
    }

  private:
    void make() {
        auto model = std::make_unique<contact::SurfaceModel>(
            setup_.name, compliance_, body_, setup_.friction, setup_.tolerance, setup_.options);
        radial_ = model.get();
        model_ = std::move(model);
        if (setup_.shear_modulus > 0)
            model_ = std::make_unique<ModelOfRevolution>(std::move(model_), setup_.shear_modulus);
    }

    const Setup& setup_;
    std::shared_ptr<const contact::Compliance> compliance_;
    std::shared_ptr<LoweredBody> body_;
    contact::SurfaceModel* radial_ = nullptr;
    std::unique_ptr<contact::Model> model_;
};

PlatesModel::PlatesModel(Setup setup) : setup_(std::move(setup)) {
    compliances_ = setup_.compliances(room_);
    make_sides();
}

PlatesModel::PlatesModel(Setup setup, Compliances compliances)
    : setup_(std::move(setup)), compliances_(std::move(compliances)) {
    make_sides();
}

PlatesModel::~PlatesModel() = default;

void PlatesModel::make_sides() {
    lower_ = std::make_unique<Side>(setup_, compliances_.lower);
    upper_ = std::make_unique<Side>(setup_, compliances_.upper);
    audit_ = {};
}

void PlatesModel::release() {
    for (const auto* side : {&lower_, &upper_}) {
        (*side)->model().release();
        (*side)->body().raise(std::vector<double>((*side)->body().raised().size(), 0.));
    }
}

void PlatesModel::enlarge(const contact::ContactAtEdge&) {
    room_ *= setup_.growth;
    compliances_ = setup_.compliances(room_);
    make_sides();
}

/// Both contacts once.
PlatesModel::Pressed PlatesModel::press(const contact::LoadStep& step) {
    Pressed pressed;
    const auto raise = [&](Side& side, const Side& other) {
        std::vector<double> by(side.body().raised().size());
        compliances_.across->normal(other.pressure(), by);
        for (std::size_t i = 0; i < by.size(); ++i)
            pressed.change = std::max(pressed.change, std::abs(by[i] - side.body().raised()[i]));
        side.body().raise(std::move(by));
    };
    pressed.lower = lower_->model().advance(step);
    raise(*upper_, *lower_);
    contact::LoadStep above = step;
    above.normal = {contact::NormalControl::Kind::force, pressed.lower.normal_force};
    above.friction = false;
    pressed.upper = upper_->model().advance(above);
    raise(*lower_, *upper_);
    return pressed;
}

/// That the pressures of either side work on the displacements by the other [J].
double PlatesModel::shared_energy() const {
    const std::vector<double> below = lower_->pressure();
    const auto& area = compliances_.lower->points().area;
    double energy = 0;
    for (std::size_t i = 0; i < below.size(); ++i)
        energy += area[i] * below[i] * lower_->body().raised()[i];
    return energy;
}

void PlatesModel::note(const Pressed& pressed) {
    for (const Side* side : {lower_.get(), upper_.get()})
        for (const auto& [name, worst, allowed] : side->model().audit().checks())
            audit_.record(name, worst, allowed);
    const double force = pressed.lower.normal_force;
    if (force > 0)
        audit_.record("forces_of_both_plates", std::abs(pressed.upper.normal_force / force - 1),
                      contact::exact_force);
}

contact::StepRecord PlatesModel::advance(const contact::LoadStep& step) {
    const std::string lower = lower_->model().write_state(), upper = upper_->model().write_state();
    double change = 0;
    for (int round = 0; round < most_rounds; ++round) {
        if (round > 0) {
            lower_->restart(lower);
            upper_->restart(upper);
        }
        const Pressed pressed = press(step);
        change = pressed.change / std::abs(pressed.lower.indentation);
        if (change > of_tolerance * setup_.tolerance) continue;
        note(pressed);
        contact::StepRecord record = pressed.lower;
        record.stored_energy += pressed.upper.stored_energy + shared_energy();
        return record;
    }
    throw contact::NotConverged(fmt::format(
        "{}: the contacts with both plates do not settle at phase {:.4g}: after {} rounds the "
        "surfaces still move by {:.3g} of the depth (allowed {:.3g})",
        name(), step.phase, most_rounds, change, of_tolerance * setup_.tolerance));
}

contact::Scales PlatesModel::scales() const {
    return lower_->model().scales();
}
std::optional<contact::Scales> PlatesModel::upper_scales() const {
    return upper_->model().scales();
}
contact::Surface PlatesModel::surface() const {
    return lower_->model().surface();
}
std::vector<contact::ContactState> PlatesModel::contact_states() const {
    return lower_->model().contact_states();
}
double PlatesModel::limit_tangential_ratio() const {
    return lower_->model().limit_tangential_ratio();
}
void PlatesModel::start_limit() {
    lower_->model().start_limit();
}

// Pressures of one contact that slips would move the surface of the other along itself.
std::unique_ptr<contact::Model> PlatesModel::sibling(const Case::Contact& options) const {
    if (options.coupling) return nullptr;
    Setup setup = setup_;
    setup.options = options;
    return std::unique_ptr<contact::Model>(new PlatesModel(std::move(setup), compliances_));
}

std::string PlatesModel::write_state() const {
    contact::StateWriter out;
    out(room_);
    for (const Side* side : {lower_.get(), upper_.get()})
        out(side->model().write_state(), side->body().raised());
    return out.take();
}

void PlatesModel::read_state(std::string_view bytes) {
    contact::StateReader in(bytes);
    double room = 0;
    in(room);
    if (room != room_) {
        room_ = room;
        compliances_ = setup_.compliances(room_);
        make_sides();
    }
    for (const Side* side : {lower_.get(), upper_.get()}) {
        std::string state;
        std::vector<double> raised;
        in(state, raised);
        side->model().read_state(state);
        side->body().raise(std::move(raised));
    }
}

}  // namespace tricontact::fem
