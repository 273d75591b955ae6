#include "comparisons/run/answer.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <iterator>
#include <limits>

#include "comparisons/quantities/model_traits.h"
#include "comparisons/quantities/reference.h"
#include "comparisons/resolution/error_note.h"
#include "comparisons/run/input_reading.h"
#include "comparisons/run/path_section.h"
#include "contact/models/model_kind.h"
#include "contact/relaxing_case.h"
#include "report/format.h"

namespace tricontact::comparisons {

namespace {

using contact::Case;
using contact::State;
using report::Verdict;

constexpr double tolerance = .05;  // from which on an assumption fails

/// The headline's number where both tell the same.
std::optional<double> ratio_of(const Case& c, const Results& s, const Results& other) {
    const Headline own = headline_of(c, s);
    if (own.length != headline_of(c, other).length) return {};
    const auto ours = s.number(*own.length), theirs = other.number(*own.length);
    if (!ours || !theirs || *theirs == 0) return {};
    return *ours / *theirs;
}

/// Who takes least beside `s` for granted, yet less: what separates them are few assumptions.
const Results* next_of(const Case& c, const Results& s, const std::vector<Results>& results) {
    const unsigned own = traits_of(c, s.model);
    const Results* next = nullptr;
    int most = -1;
    for (const Results& other : results) {
        const unsigned set = traits_of(c, other.model);
        // Of equals one on cells, whose error is told best.
        const int size =
            2 * std::popcount(set) + (contact::model_kind(other.model).is_on_cells() ? 1 : 0);
        if (set == own || (set & own) != set || size <= most) continue;
        next = &other;
        most = size;
    }
    return next;
}

/// Whether both know their state, and it is another.
bool differ(const Results& a, const Results& b) {
    const auto decided = [](const Results& s) {
        return s.state() && *s.state() != State::undecided;
    };
    return decided(a) && decided(b) && a.state() != b.state();
}

Verdict::Standing standing_of(double change) {
    return std::abs(change) < tolerance ? Verdict::Standing::holds : Verdict::Standing::violated;
}

Verdict effect(const std::string& assumption, const char* words, double change,
               const std::string& between) {
    return {standing_of(change),
            fmt::format("{}: {} of the {} ({}).", report::capitalised(assumption),
                        report::percent(1 + change), words, between)};
}

/// Models side by side.
void add_model_verdicts(const Case& c, const std::vector<Results>& results,
                        std::vector<Verdict>& verdicts) {
    std::vector<unsigned> told;
    for (std::size_t i = results.size(); i-- > 0;) {
        const Results& s = results[i];
        const Results* other = next_of(c, s, results);
        if (!other) continue;
        const unsigned removed = traits_of(c, s.model) & ~traits_of(c, other->model);
        if (std::ranges::find(told, removed) != told.end()) continue;
        told.push_back(removed);
        const std::string pair =
            report::display_name(s.model) + " beside " + report::display_name(other->model);
        if (differ(s, *other))
            verdicts.push_back(
                {Verdict::Standing::violated,
                 fmt::format("{}: {} instead of {} ({}).", report::capitalised(names_of(removed)),
                             contact::name_of(*s.state()), contact::name_of(*other->state()),
                             pair)});
        else if (const auto ratio = ratio_of(c, s, *other))
            verdicts.push_back(
                effect(names_of(removed), headline_of(c, s).words, *ratio - 1, pair));
    }
}

/// Who takes the same for granted as the reference ought to come to the same.
void add_disagreements(const Case& c, const std::vector<Results>& results,
                       std::vector<Verdict>& verdicts) {
    const Results& reference = results.back();
    for (const Results& s : results)
        if (traits_of(c, s.model) == traits_of(c, reference.model) && differ(s, reference))
            verdicts.push_back(
                {Verdict::Standing::not_resolved,
                 fmt::format("{} and {} make the same assumptions but reach different verdicts "
                             "({} and {}): compare their distance to the limit, the periods "
                             "run and the resolution.",
                             report::display_name(s.model), report::display_name(reference.model),
                             contact::name_of(*s.state()), contact::name_of(*reference.state()))});
}

void add_variant_verdicts(const Case& c, const std::vector<Results>& results,
                          const std::vector<LoadingVariant>& variants,
                          std::vector<Verdict>& verdicts) {
    for (const LoadingVariant& v : variants) {
        if (v.key != "contact.coupling" || v.model != results.back().model) continue;
        const auto change = v.run.state ? v.rolled_error() : v.loaded_error();
        // The variant is the assumption where the run couples, else its absence.
        const bool assumed = v.changed == "false";
        if (change)
            verdicts.push_back(effect("no coupling of normal and tangential contact",
                                      headline_of(c, results.back()).words,
                                      assumed ? *change : 1 / (1 + *change) - 1,
                                      report::display_name(v.model) + " with and without"));
    }
}

std::string not_tested(const Case& c, const std::vector<Results>& results) {
    std::vector<std::string> list;
    if (c.law == Case::Law::linear) {
        const Results& s = results.back();
        const auto d = s.number(quantities::indentation);
        list.push_back(c.layer.thickness && d
                           ? fmt::format("small strains (the indentation is {} of the thickness)",
                                         report::share(*d / *c.layer.thickness))
                           : "small strains");
    }
    if (c.has_rigid_substrate && !contact::indenter_relaxes(c))
        list.emplace_back("an elastic indenter");
    if (!c.has_rigid_substrate && !contact::substrate_relaxes(c))
        list.emplace_back("an elastic substrate");
    list.emplace_back(c.friction.is_coulomb()  ? "Coulomb friction of one coefficient"
                      : c.friction.remembers() ? "friction that depends on pressure and slip alone"
                                               : "friction that depends on the pressure alone");
    if (!c.interface.is_elastic()) list.emplace_back("a rigid interface");
    if (!c.indenter.height_map && !c.indenter.file) list.emplace_back("a smooth surface");
    return fmt::format("{}", fmt::join(list, ", "));
}

/// Along a path that ends with a closed cycle.
bool has_loop(const Case& c, const Results& s) {
    return c.prescribed_path && s.number(quantities::dissipation);
}

bool ends_at_prescribed_shift(const Case& c) {
    return c.prescribed_path && c.prescribed_path->rows.back().tangential[0].kind ==
                                    contact::TangentialControl::Kind::shift;
}

}  // namespace

Headline headline_of(const Case& c, const Results& s) {
    using namespace quantities;
    if (has_loop(c, s)) return {"frictional work per cycle", &dissipation, nullptr};
    if (c.adhesion && c.is_pressed_only() && s.number(pull_off_force))
        return {"pull-off force", &pull_off_force, nullptr};
    // All models end at a shift that is prescribed: they differ in what it takes.
    if (ends_at_prescribed_shift(c))
        return s.number(path_work).value_or(0) > 0
                   ? Headline{"frictional work of the path", &path_work, nullptr}
                   : Headline{"tangential force at the end of the path", &path_force, nullptr};
    if (is_pressed_alone(s))
        return {c.load.indentation ? "normal force" : "indentation", &not_prescribed(c), nullptr};
    if (s.state() == State::ratcheting)
        return {"shift per period", &shift_increment, &shift_increment_ratio};
    if (!s.state() && !s.number(static_shift))
        return {"shift at the end of the path", &final_shift, &final_shift_ratio};
    if (!s.state()) return {"static shift", &static_shift, &static_shift_ratio};
    if (s.number(settled_shift)) return {"settled shift", &settled_shift, &settled_shift_ratio};
    return {"shift so far", &final_shift, &final_shift_ratio};
}

Verdict answer_of(const Case& c, const Results& s, const std::optional<NumericalError>& error,
                  const std::optional<Refinement>& refinement) {
    using namespace quantities;
    const std::string by = " (" + report::display_name(s.model) + ").";
    const auto length = [&](const Quantity& q) {
        return value_text(s.number(q).value_or(0), q.unit,
                          error ? error->of(q) : refined_width(refinement, q));
    };
    const auto note_on = [&](const Quantity& q) {
        return refinement ? refinement_note(*refinement, q) : error_note(error, q);
    };
    if (c.adhesion && c.is_pressed_only() && s.number(pull_off_force))
        return {Verdict::Standing::finding,
                fmt::format("The contact holds {} at most, at the radius {}; pressed hardest its "
                            "radius is {}{}{}",
                            length(pull_off_force), length(pull_off_radius), length(contact_radius),
                            by, note_on(pull_off_force)),
                "pulled"};
    if (is_pressed_alone(s)) {
        const std::string answer = length(*headline_of(c, s).length);
        const std::string pressed = c.load.indentation
                                        ? fmt::format("Pressed in by {}, the indenter carries {}",
                                                      length(end_indentation), answer)
                                        : "The indenter is pressed in by " + answer;
        return {Verdict::Standing::finding,
                fmt::format("{}; the {} is {}{}{}", pressed, size_name(c), length(contact_radius),
                            by, note_on(*headline_of(c, s).length)),
                "pressed"};
    }
    const Headline headline = headline_of(c, s);
    const std::string number = length(*headline.length) + by, note = note_on(*headline.length);
    const auto verdict = [&](Verdict::Standing standing, const std::string& words,
                             const char* word) {
        return Verdict{standing, words + number + note, word};
    };
    if (has_loop(c, s)) return verdict(Verdict::Standing::finding, loop_words(s), "path");
    if (ends_at_prescribed_shift(c))
        return verdict(Verdict::Standing::finding,
                       headline.length == &path_work
                           ? "The shift is prescribed; along the path friction works "
                           : "The shift is prescribed; at its end the tangential force is ",
                       "path");
    if (!s.state() && !s.number(static_shift))
        return verdict(Verdict::Standing::finding, "At the end of the path the shift is ", "path");
    if (!s.state())
        return verdict(Verdict::Standing::finding, "The tangential force shifts the indenter by ",
                       "static");
    const char* const word = contact::name_of(*s.state());
    Verdict told = [&] {
        if (*s.state() == State::ratcheting)
            return verdict(Verdict::Standing::violated, "Every period shifts the indenter by ",
                           word);
        if (*s.state() == State::undecided) {
            Verdict open =
                verdict(Verdict::Standing::not_resolved,
                        fmt::format("After {} periods the shift is ", s.periods()), word);
            if (!s.verdict.missing.empty())
                open.sentence += " Undecided: " + s.verdict.missing + ".";
            return open;
        }
        if (!s.number(settled_shift))
            return verdict(Verdict::Standing::holds,
                           fmt::format("It settles, but after {} periods it is not known where; so "
                                       "far it has shifted by ",
                                       s.periods()),
                           word);
        return verdict(Verdict::Standing::holds,
                       *s.state() == State::cyclic_slip
                           ? "Cyclic slip persists; the shift settles at "
                           : "The indenter settles at a shift of ",
                       word);
    }();
    if (const auto other = error ? error->other_state() : std::nullopt) {
        told.standing = Verdict::Standing::not_resolved;
        told.sentence += fmt::format(
            " Coarser meshes or longer steps come to {}: refine before relying on the verdict.",
            contact::name_of(*other));
    }
    return told;
}

report::DocumentTable models_table(const Case& c, const std::vector<Results>& results,
                                   const std::optional<NumericalError>& error) {
    const Results& reference = results.back();
    const Headline headline = headline_of(c, reference);
    const report::Unit unit =
        report::fitting_unit(reference.number(*headline.length).value_or(0), headline.length->unit);
    const std::string name = report::display_name(reference.model);
    report::DocumentTable table{
        .id = "models",
        .title = "Models",
        .columns = {{.heading = "model"},
                    {.heading = "state"},
                    {.heading = fmt::format("{} [{}]", headline.words, unit.symbol)},
                    {.heading = "beside " + name + " [%]", .change = true},
                    {.heading = "assumes"}},
        .stacks = true};
    const unsigned of_reference = traits_of(c, reference.model);
    for (std::size_t i = results.size(); i-- > 0;) {
        const Results& s = results[i];
        const bool is_reference = &s == &reference;
        const bool same = headline_of(c, s).length == headline.length;
        const auto value = same ? s.number(*headline.length) : std::nullopt;
        const double width = is_reference && error ? error->of(*headline.length).value_or(0) : 0;
        const auto ratio = is_reference ? std::nullopt : ratio_of(c, s, reference);
        const unsigned extra = traits_of(c, s.model) & ~of_reference;
        table.rows.push_back({report::display_name(s.model),
                              s.state() ? contact::name_of(*s.state()) : std::string("–"),
                              value && width > 0 ? report::Cell(report::WithError{
                                                       *value / unit.factor, width / unit.factor})
                                                 : report::number_cell(value, unit.factor),
                              ratio ? 100 * (*ratio - 1) : std::numeric_limits<double>::quiet_NaN(),
                              is_reference ? std::string("reference")
                              : extra      ? names_of(extra)
                                           : "the same as " + name});
    }
    // Of a run that is undecided, what is missing: one beside the answer is not left unexplained.
    for (const Results& s : results)
        if (!s.verdict.missing.empty() && &s != &reference)
            table.note += fmt::format("{}{} is undecided: {}.", table.note.empty() ? "" : " ",
                                      report::display_name(s.model), s.verdict.missing);
    return table;
}

std::vector<Verdict> assumption_verdicts(const Case& c, const std::vector<Results>& results,
                                         const ReportExtras& extras) {
    std::vector<Verdict> verdicts;
    add_model_verdicts(c, results, verdicts);
    add_disagreements(c, results, verdicts);
    add_variant_verdicts(c, results, extras.study.variants, verdicts);
    for (const SmallStrains& study : extras.small_strains) {
        const auto ratio = study.linear ? ratio_of(c, *study.linear, study.finite) : std::nullopt;
        if (ratio)
            verdicts.push_back(
                effect("small strains", headline_of(c, study.finite).words, *ratio - 1,
                       report::display_name(study.model) + " with a linear material"));
    }
    for (const RunComparison& twin : extras.relaxation.twins) {
        const auto change = twin.other ? twin_error(*twin.other, twin.run) : std::nullopt;
        if (change && twin.model == results.back().model)
            verdicts.push_back(effect("an elastic substrate of the relaxed modulus",
                                      headline_of(c, results.back()).words, *change,
                                      report::display_name(twin.model) + " without relaxation"));
    }
    std::ranges::move(border_verdicts(c, results), std::back_inserter(verdicts));
    verdicts.push_back({Verdict::Standing::not_testable,
                        "Assumed by all models and not tested: " + not_tested(c, results) + "."});
    return verdicts;
}

}  // namespace tricontact::comparisons
