#include <fmt/format.h>

#include <algorithm>

#include "comparisons/half_space/layer.h"
#include "comparisons/quantities/left_out.h"
#include "comparisons/quantities/reference.h"
#include "comparisons/quantities/undefined.h"
#include "comparisons/run/reading.h"
#include "contact/load_path.h"
#include "contact/models/model_kind.h"
#include "contact/substrates/normal_tangential.h"
#include "report/format.h"
#include "theory/rolling/body_rolling.h"

namespace tricontact::comparisons {

namespace {

using contact::ModelKind;
using Summaries = std::vector<Results>;

/// Whether one of the models has this property of ModelKind.
template <class Property>
bool has_model(const Summaries& summaries, const Property& property) {
    return std::ranges::any_of(summaries, property, [](const Results& s) -> const ModelKind& {
        return contact::model_kind(s.model);
    });
}

/// "All models take", "MDR and BEM take", "MDR takes".
std::string taking(const std::vector<std::string>& models, const Summaries& summaries) {
    if (models.size() == summaries.size())
        return models.size() > 1 ? "All models take" : report::display_names(models) + " takes";
    return report::display_names(models) + (models.size() > 1 ? " take" : " takes");
}

std::string half_space_sentence(const contact::Case& c, const Summaries& summaries,
                                bool has_section) {
    std::vector<std::string> models;
    for (const Results& s : summaries)
        if (is_half_space(s.model) && !is_tabulated(c, s.model)) models.push_back(s.model);
    if (models.empty()) return {};
    const bool told = has_section && c.layer.thickness && why_no_exact_theory(c).empty();
    std::vector<std::string> unseen;
    if (c.layer.thickness)
        unseen.push_back(
            fmt::format("the thickness of the layer is not seen{}",
                        told ? " (The section on the layer, below, gives the effect)" : ""));
    else if (!c.has_rigid_substrate)
        unseen.emplace_back(
            "a layer of finite thickness, usually stiffer on its rigid base, is not seen");
    if (c.indenter.body || c.has_rigid_substrate)
        unseen.emplace_back("the size of the indenter is not seen");
    return fmt::format("{} the bodies as {}half-spaces: {}.", taking(models, summaries),
                       c.relaxation ? "" : "elastic ", fmt::join(unseen, ", and "));
}

std::string thickness_sentence(const contact::Case& c, const Summaries& summaries) {
    return half_space_sentence(c, summaries, true);
}

/// Who couples and who does not, where half-spaces are taken.
std::string uncoupled_sentence(const contact::Case& c, const Summaries& summaries) {
    const auto models = uncoupled_half_spaces(c, summaries);
    if (models.empty()) return {};
    return fmt::format("{} normal and tangential contact as uncoupled (Dundurs' β = {}).",
                       taking(models, summaries),
                       report::significant(c.materials().dundurs_beta(), 2));
}
std::string coupled_sentence(const contact::Case& c, const Summaries& summaries) {
    const auto couples_half_spaces = [&](const Results& s) {
        const ModelKind& kind = contact::model_kind(s.model);
        return kind.is_on_cells_of(ModelKind::Body::half_space) && !is_tabulated(c, s.model) &&
               couples(c, s.model);
    };
    if (std::ranges::none_of(summaries, couples_half_spaces)) return {};
    return fmt::format("BEM couples normal and tangential contact (Dundurs' β = {}).",
                       report::significant(c.materials().dundurs_beta(), 2));
}

std::string pressure_sentence(const contact::Case& c, const Summaries& summaries) {
    if (contact::has_conical_tip(c))
        return "Under the tip the pressure is infinite, as a logarithm: that of a model's cells "
               "there grows as they shrink, and is no result.";
    if (c.indenter.shape == contact::Case::Shape::profile || !theory::has_body_theory(c) ||
        contact::pressure_falls(c))
        return {};
    std::string text = "The pressure on a half-space is largest in a ring, not at the centre.";
    if (c.rolling && has_model(summaries, &ModelKind::is_independent))
        text +=
            " The shakedown limit of MDR, whose springs depend on line loads only, is then above "
            "the exact one.";
    return text;
}

/// Loads that each model sets by its own limit.
std::string own_load_sentence(const contact::Case& c, const Summaries& summaries) {
    if (!c.load.is_by_limit() || summaries.size() < 2) return {};
    std::vector<std::string> loads;
    for (const Results& s : summaries)
        loads.push_back(fmt::format("{} for {}",
                                    report::significant(s.number(quantities::tangential_ratio)),
                                    report::display_name(s.model)));
    const std::string share =
        c.load.limit_fraction
            ? report::as_given(*c.load.limit_fraction) + " of its own limit of shakedown"
            : report::as_given(*c.load.limit_excess) +
                  " of the way from its own limit of shakedown to " + c.friction.limit_symbol();
    return fmt::format("Each model's F_T is {}, so the models are under different loads: f_T = {}.",
                       share, fmt::join(loads, ", "));
}

/// A linear model leaves the contact where it is, however far it is shifted.
std::string far_shift_sentence(const contact::Case& c, const Summaries&) {
    constexpr double far = .1;  // of the contact radius
    if (!c.prescribed_path || c.law != contact::Case::Law::linear) return {};
    double farthest = 0;
    for (const auto& row : c.prescribed_path->rows)
        for (const auto& control : row.tangential)
            if (control.kind == contact::TangentialControl::Kind::shift)
                farthest = std::max(farthest, std::abs(control.value));
    const double ratio = farthest / contact::half_space_scales(c).contact_radius;
    if (ratio <= far) return {};
    return fmt::format(
        "The path prescribes shifts up to {} of the contact radius: these models, of small "
        "displacements, leave the contact where it is on the substrate.",
        report::significant(ratio, 2));
}

std::string direction_sentence(const contact::Case& c, const Summaries& summaries) {
    if (!c.rolling || !has_model(summaries, &ModelKind::is_independent)) return {};
    return std::string(
               "MDR's springs lie on one line, so it cannot distinguish rolling along the load "
               "from "
               "rolling across it: its result is the same for every angle. Transformed back to "
               "three "
               "dimensions its traction may exceed ") +
           c.friction.bound_symbol() + ": the bound holds spring by spring only.";
}

/// What small strains leave of two bodies that roll on each other: how far they creep without a
/// force, and how far pairs of points have moved apart.
std::vector<std::string> rolling_body_sentences(const contact::Case& c,
                                                const Summaries& summaries) {
    using contact::ElasticBody;
    std::vector<std::string> sentences;
    const auto& body = c.indenter.body;
    const bool is_ball = body && body->form == ElasticBody::Form::ball;
    if (!body || !(is_ball || body->form == ElasticBody::Form::cylinder) ||
        body->support != ElasticBody::Support::hub ||
        !(contact::path_reach(c, c.indenter.radius)[0] > 0))
        return sentences;
    for (const Results& s : summaries) {
        if (!contact::model_kind(s.model).sees_indenter_body) continue;
        const double a = s.number(quantities::contact_radius).value_or(0);
        const double slope = a / c.indenter.radius;
        sentences.push_back(fmt::format(
            "{}: without a tangential force too the {} creeps by about (a/R)² = {} of its "
            "way, as much as small strains leave out: creep of that order is no result.",
            report::display_name(s.model), is_ball ? "ball" : "cylinder",
            report::significant(slope * slope, 2)));
        if (const auto shift = s.number(quantities::final_shift))
            sentences.push_back(fmt::format(
                "{}: points that touch stay pairs. At the end the shift is {} of the contact "
                "radius, and what pairs miss is of this order.",
                report::display_name(s.model), report::share(std::abs(*shift) / a)));
    }
    return sentences;
}

/// Of friction that changes with the way of slip: whether a step has one state alone, and whether
/// one jumped.
std::vector<std::string> slip_memory_sentences(const contact::Case& c, const Summaries& summaries) {
    constexpr double noticed = 1e-3, long_steps = .01;  // of the frictional work so far
    std::vector<std::string> sentences;
    if (!c.friction.remembers()) return sentences;
    if (c.rolling)
        sentences.emplace_back(
            "What the layer between the surfaces has flowed stays, and it hardens until it carries "
            "what the surfaces do: the limits of shakedown are theirs.");
    for (const Results& s : summaries) {
        const std::string name = report::display_name(s.model);
        const double others = s.number(quantities::steps_of_other_states).value_or(0);
        const double released = s.number(quantities::released_energy).value_or(0);
        const double share = released / s.number(quantities::friction_energy).value_or(0);
        if (others > 0)
            sentences.push_back(fmt::format(
                "{}: in {} the same loads have another state, of more slip, or none is known not "
                "to. The state of least slip is followed, which a slow load leads to; a jerk may "
                "lead to the other.",
                name, others == 1 ? "one step" : fmt::format("{:.0f} steps", others)));
        else if (c.friction.law()->weakens())
            sentences.push_back(name +
                                ": every step has one state alone; searched from least and from "
                                "most slip it is the same.");
        if (others > 0 && share > noticed)
            sentences.push_back(fmt::format(
                "{}: one step set free {} beyond what friction took, {} of its work so far: the "
                "contact jumped. Shorter steps tell how far.",
                name, report::quantity(released, "J"), report::share(share)));
        else if (share > long_steps)
            sentences.push_back(fmt::format(
                "{}: the steps are long: the work of the loads in one of them is {} more than "
                "friction took, {} of its work so far. Of shorter steps it is less.",
                name, report::quantity(released, "J"), report::share(share)));
    }
    return sentences;
}

/// Whether a sentence of its own says that a model leaves it out.
bool is_told_above(const contact::Case& c, const std::string& model, const std::string& left_out) {
    return left_out.starts_with("substrate.thickness") ||
           (contact::model_kind(model).is_independent() && c.rolling &&
            left_out.starts_with("rolling direction"));
}

std::vector<std::string> left_out_sentences(const contact::Case& c, const Summaries& summaries) {
    std::vector<std::string> sentences;
    for (const Results& s : summaries)
        for (const std::string& one : left_out(c, s.model))
            if (!is_told_above(c, s.model, one))
                sentences.push_back(report::display_name(s.model) + " leaves out " + one + ".");
    return sentences;
}

}  // namespace

std::vector<std::string> uncoupled_half_spaces(const contact::Case& c, const Summaries& summaries) {
    std::vector<std::string> models;
    for (const Results& s : summaries)
        if (is_uncoupled_half_space(c, s.model)) models.push_back(s.model);
    return models;
}

std::vector<std::string> limitations(const contact::Case& c, const Summaries& summaries) {
    std::vector<std::string> findings;
    for (const auto& sentence :
         {direction_sentence, own_load_sentence, thickness_sentence, uncoupled_sentence,
          coupled_sentence, pressure_sentence, far_shift_sentence})
        findings.push_back(sentence(c, summaries));
    if (c.indenter.shape == contact::Case::Shape::sphere)
        findings.push_back(
            "The theory column holds for a paraboloid; the exact sphere departs from it with "
            "(a/R)².");
    if (c.rolling && !constant_loads(c))
        findings.push_back(
            "The loads oscillate with the rolling: the closed forms, κ and η assume constant loads "
            "and are left out; f_T and w refer to the mean loads.");
    for (const std::string& sentence : rolling_body_sentences(c, summaries))
        findings.push_back(sentence);
    for (const std::string& sentence : slip_memory_sentences(c, summaries))
        findings.push_back(sentence);
    for (const std::string& sentence : left_out_sentences(c, summaries))
        findings.push_back(sentence);
    for (const Results& s : summaries)
        for (const auto& [quantity, why] : why_undefined(c, s))
            if (constant_loads(c))  // else the sentence above
                findings.push_back(fmt::format("{}: no {} {}: {}.", report::display_name(s.model),
                                               quantity->name, quantity->symbol, why));
    std::erase(findings, "");
    return findings;
}

std::vector<std::string> body_limitations(const contact::Case& c,
                                          const std::vector<std::string>& models) {
    Summaries summaries(models.size());
    for (std::size_t i = 0; i < models.size(); ++i) summaries[i].model = models[i];
    std::vector<std::string> findings;
    if (c.layer.thickness) findings.push_back(half_space_sentence(c, summaries, false));
    if (contact::half_spaces_couple(c.materials()))
        findings.push_back(uncoupled_sentence(c, summaries));
    findings.push_back(direction_sentence(c, summaries));
    for (const std::string& one : left_out_sentences(c, summaries)) findings.push_back(one);
    std::erase(findings, "");
    return findings;
}

}  // namespace tricontact::comparisons
