#include "benchmarks/decks/deck_texts.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace tricontact::benchmarks {

namespace {

using Out = std::back_insert_iterator<std::string>;

const char* shape_words(const DeckModel& model) {
    switch (model.shape) {
        case DeckModel::Shape::axisymmetric:
            return "axisymmetric";
        case DeckModel::Shape::plane:
            return model.is_shifted() ? "plane strain" : "plane strain, x >= 0";
        case DeckModel::Shape::half:
            return "half model, y >= 0";
    }
    return "";
}

// Paragraphs are broken at 90 columns.
void write_paragraph(std::string& text, const std::string& words) {
    std::size_t column = 0, at = 0;
    while (at < words.size()) {
        std::size_t end = words.find(' ', at);
        if (end == std::string::npos) end = words.size();
        if (column > 0 && column + 1 + end - at > 90) {
            text += '\n';
            column = 0;
        } else if (column > 0) {
            text += ' ';
            ++column;
        }
        text += words.substr(at, end - at);
        column += end - at;
        at = end + 1;
    }
    text += '\n';
}

std::string load_words(const DeckModel& model) {
    const char* per = model.shape == DeckModel::Shape::plane ? "N/mm" : "N";
    std::string words = "Prescribed: ";
    for (std::size_t i = 0; i < model.steps.size(); ++i) {
        const DeckStep& step = model.steps[i];
        words += fmt::format("{}{} {:.9g} {}", i > 0 ? "; then " : "",
                             step.is_force ? "normal force" : "depth", step.normal,
                             step.is_force ? per : "mm");
        if (step.shift != 0)
            words += fmt::format(", {} {:.9g} {} along x",
                                 step.is_tangential_force ? "tangential force" : "shift",
                                 step.shift, step.is_tangential_force ? per : "mm");
        if (step.increments > 1) words += fmt::format(" in {} steps", step.increments);
    }
    words += model.mu > 0
                 ? fmt::format(". Friction {:.6g}{}.", model.mu,
                               model.presses_frictionless ? " from the second step on" : "")
                 : ". No friction.";
    if (model.share() != 1)
        words += " Forces that a code prints are those of its half: twice as much acts.";
    return words;
}

std::string round_words(const DeckModel& model) {
    return fmt::format(
        "Body: {} of R = {:.9g} mm, its pole up, {}; a rigid plane presses it from above. E = "
        "{:.9g} MPa, nu = {:.9g}. The gap is that along the plane's normal, and p the force per "
        "area of the plane.",
        model.shape == DeckModel::Shape::plane ? "the upper half of a cylinder"
                                               : "the upper half of a ball",
        model.round_radius,
        model.has_sliding_base
            ? "its middle plane held along the load alone, as the symmetry between two plates asks"
            : "its flat face bonded to a rigid holder",
        model.young, model.poisson);
}

std::string block_words(const DeckModel& model) {
    if (!model.own_words.empty()) return model.own_words;
    if (model.round_radius > 0) return round_words(model);
    std::string words = fmt::format(
        "Block: {:.9g} mm {}, {:.9g} mm thick, the same for all meshes, bonded to a rigid base, "
        "its "
        "sides free; E = {:.9g} MPa, nu = {:.9g}.",
        model.width, model.shape == DeckModel::Shape::axisymmetric ? "radius" : "to either side",
        model.thickness, model.young, model.poisson);
    if (model.upper)
        words += fmt::format(
            " On it half a ball of R = {:.9g} mm, its flat face bonded to a rigid holder, whose "
            "depth is prescribed; E = {:.9g} MPa, nu = {:.9g}.",
            model.upper->radius, model.upper->young, model.upper->poisson);
    if (!model.is_half_space) return words;
    if (model.shape == DeckModel::Shape::plane)
        return words +
               " It stands for a half-space. Its depth under a force is that of the block: in a "
               "plane "
               "half-space there is none.";
    if (model.shape == DeckModel::Shape::axisymmetric)
        return words +
               " It stands for a half-space: the base raises the force at a depth by 0.08 % or "
               "lowers "
               "the depth under a force by 0.05 %.";
    return words +
           fmt::format(
               " It stands for a half-space, though a small one: the base raises the force at "
               "a depth by about {:.2g} %.",
               78 * model.a / model.thickness);
}

std::string method_words(const DeckModel& model, const DeckFamily& family) {
    if (family.method == "mortar")
        return "Contact: pressures linear between points of the lower body's surface act on both "
               "(mortar); gap and normal of the undeformed surfaces. Each body is condensed to "
               "those points, so that the script solves a dense contact problem.";
    if (!family.has_stiffness)
        return "Contact: augmented Lagrangian, gap and normal of the undeformed surface.";
    std::string words = fmt::format("Contact: penalty of {:.9g} MPa/mm", model.stiffness);
    if (model.mu > 0) words += fmt::format(", stick slope {:.9g} MPa/mm", model.stick_slope);
    return words + (family.kinematics == "displaced"
                        ? ", gap and normal of the displaced surface, strains linear."
                        : ", gap and normal of the undeformed surface.");
}

}  // namespace

std::string submission_text(const DeckModel& model, const DeckFamily& family) {
    std::string text;
    const Out out = std::back_inserter(text);
    fmt::format_to(out, "case = \"{}\"\n", model.name);
    if (family.code.empty())
        text += "# code = \"name and version\"\n";
    else
        fmt::format_to(out, "code = \"{}\"\nelements = \"{}\"\n", family.code, family.elements);
    if (model.round_radius == 0) fmt::format_to(out, "block_width = \"{:.9g} mm\"\n", model.width);
    if (!family.method.empty()) {
        fmt::format_to(out, "\n[contact]\nmethod = \"{}\"\nkinematics = \"{}\"\n", family.method,
                       family.kinematics);
        if (family.has_stiffness) {
            fmt::format_to(out, "stiffness = \"{:.9g} MPa/mm\"\n", model.stiffness);
            if (model.mu > 0)
                fmt::format_to(out, "stick_slope = \"{:.9g} MPa/mm\"\n", model.stick_slope);
        }
        if (model.mu > 0) fmt::format_to(out, "press_steps = {}\n", model.steps.front().increments);
    }
    for (const DeckRun& run : family.runs) {
        fmt::format_to(out, "\n[[mesh]]\nsize = \"{:.9g} mm\"\nfield = \"{}\"\n", run.size,
                       run.field);
        if (!run.set.empty()) fmt::format_to(out, "set = \"{}\"\n", run.set);
        if (!run.totals.empty()) fmt::format_to(out, "totals = \"{}\"\n", run.totals);
    }
    return text;
}

std::string readme_text(const DeckModel& model, const DeckFamily& family, bool has_submission) {
    std::string text;
    const std::string code = family.code.empty() ? "meshes for any code" : family.code;
    write_paragraph(text, fmt::format("{}: {}, {} ({})", model.name, code, family.elements,
                                      shape_words(model)));
    if (!model.title.empty()) write_paragraph(text, model.title);
    text += "\nRun here:\n\n";
    for (const DeckRun& run : family.runs)
        if (!run.command.empty()) text += "    " + run.command + "\n";
    if (has_submission) text += "    tricontact benchmark compare submission.toml\n";
    text += '\n';
    if (family.runs.front().command.empty())
        write_paragraph(
            text,
            std::string("The meshes (.msh of Gmsh 4.1, .vtu) ") +
                (model.upper ? "are two of each size, lower and upper, one of each body. They have "
                               "the parts contact, axis (x = 0), base (what holds the body, or "
                               "moves it) and loaded (under a pressure), where there are such"
                             : "have the parts base, side, contact, and axis or symmetry") +
                ". Make an input for your code, and let it write the CSV files that "
                "submission.toml names, with the columns r [mm] (or x [mm], y [mm]) and p [MPa].");
    write_paragraph(text, "Units: mm, N, MPa. " + load_words(model));
    write_paragraph(text, block_words(model));
    if (!family.method.empty()) write_paragraph(text, method_words(model, family));
    write_paragraph(
        text,
        fmt::format(
            "Family: the meshes have {} elements in the contact radius a = {:.9g} mm, whose edge "
            "is at a node. Every element of one is divided into {} of the next, so that all "
            "are similar: the pressure then converges with the order 1 in L2, for any elements.",
            [&] {
                std::string counts;
                for (const DeckRun& run : family.runs)
                    counts += (counts.empty() ? "" : ", ") + std::to_string(run.n);
                return counts;
            }(),
            model.a, model.shape == DeckModel::Shape::half ? 8 : 4,
            model.has_sharp_edge
                ? ""
                : " The pressure then converges with the order 1 in L2, for any elements."));
    if (!model.remarks.empty() || !family.remarks.empty()) text += '\n';
    for (const std::string& remark : model.remarks) write_paragraph(text, remark);
    for (const std::string& remark : family.remarks) write_paragraph(text, remark);
    return text;
}

std::vector<DeckFile> family_files(const DeckModel& model, const DeckWishes& wishes) {
    const DeckFamily family = make_family(model, wishes);
    std::vector<DeckFile> files;
    for (const DeckRun& run : family.runs)
        files.insert(files.end(), run.files.begin(), run.files.end());
    files.push_back({"README.txt", readme_text(model, family, false)});
    return files;
}

}  // namespace tricontact::benchmarks
