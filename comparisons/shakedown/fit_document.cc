#include "comparisons/shakedown/fit_document.h"

#include <fmt/format.h>

namespace tricontact::comparisons {

namespace {

void add(report::Document& document, report::DocumentSection section) {
    std::erase_if(section.tables,
                  [](const report::DocumentTable& table) { return table.rows.empty(); });
    if (!section.figures.empty() || !section.tables.empty())
        document.sections.push_back(std::move(section));
}

std::string with_minus_signs(std::string formula) {
    constexpr std::string_view plain = " - ";
    for (std::size_t at = 0; (at = formula.find(plain, at)) != std::string::npos;)
        formula.replace(at, plain.size(), " − ");
    return formula;
}

constexpr std::size_t most_named = 4;  // a longer list is the table once more

/// How many of the assumptions and comparisons do not hold.
std::optional<report::Verdict> fit_answer(const std::vector<report::Verdict>& verdicts) {
    using enum report::Verdict::Standing;
    std::vector<std::string> failed;
    int n = 0;
    for (const report::Verdict& one : verdicts) {
        if (one.subject.empty()) continue;
        ++n;
        if (one.standing == violated || one.standing == fail) failed.push_back(one.subject);
    }
    if (n == 0) return {};
    if (failed.empty())
        return report::Verdict{finding, fmt::format("No statement of {} is contradicted.", n),
                               "none fails"};
    const std::string word = fmt::format("{} of {} fail", failed.size(), n);
    if (failed.size() > most_named)
        return report::Verdict{fail, "The table begins with them.", word};
    return report::Verdict{fail, fmt::format("{}.", fmt::join(failed, "; ")), word};
}

}  // namespace

report::Document fit_document(const StudyFit& fit) {
    const bool is_coulomb = fit.law->is_coulomb();
    report::Document document{
        .kind = "Fits to a sweep",
        .title = fit.title,
        .lead = std::string("Which κ and η each model has, how far one constant holds, and how the "
                            "models differ from each other") +
                (is_coulomb ? " and from the formulas of the thesis" : "") +
                ". w, f_T and u are ratios to each model's own contact radius, friction limit and "
                "U_max.",
        .verdicts = fit_verdicts(fit),
        .settings = fit.settings,
        .files = {{"all numbers (JSON)", "fit.json"}, {"fits (CSV)", "fits.csv"}},
        .command = fit.command,
        .version = fit.version};
    document.answer = fit_answer(document.verdicts);
    if (is_coulomb)
        add(document, {.id = "thesis",
                       .heading = "Figures of the thesis",
                       .paragraphs = {"Its formulas are dashed. Bars are numerical errors."},
                       .figures = thesis_figures(fit)});
    add(document,
        {.id = "mapping",
         .heading = "Settled shifts: the mapping parameter κ",
         .paragraphs = {fmt::format(
             "{}, which MDR fulfils with κ = {}. At small w u_sd small errors of u_sd are large "
             "ones of κ: what counts is how far off u_sd a κ is.",
             with_minus_signs(settled_form(*fit.law, "κ")), fit.law->mdr_text)},
         .figures = mapping_figures(fit),
         .tables = {mapping_use_table(fit),
                    form_table("kappa_fits", "Fits of κ", mapping_rows(fit))}});
    add(document,
        {.id = "ratcheting",
         .heading = "Beyond the limit: the ratcheting slope η",
         .paragraphs = {"Δu = η (w − w_lim), w_lim being the model's own. Δu depends on the length "
                        "of the steps to first order: it is extrapolated where the study varies "
                        "it, else it has no error bar."},
         .figures = increment_residual_figures(fit),
         .tables = {form_table("ratcheting_fits", "Fits of limits and of the shift per period",
                               ratcheting_rows(fit))}});
    add(document,
        {.id = "models",
         .heading = "Models side by side",
         .paragraphs = {"Two models differ where their numerical error bars do not overlap."},
         .tables = {difference_table(fit), point_difference_table(fit)}});
    return document;
}

}  // namespace tricontact::comparisons
