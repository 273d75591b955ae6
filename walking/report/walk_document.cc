#include "walking/report/walk_document.h"

#include <fmt/format.h>

#include "report/format.h"

namespace tricontact::walking {

report::Document walk_document(const WalkReport& report) {
    const auto vibration = vibration_of(report.walk_case.machine, report.walk);
    report::Document document{
        .kind = "Micro-walking machine",
        .title =
            report.walk_case.title.empty() ? "Run of a walking machine" : report.walk_case.title,
        .lead =
            "How a slider on elastic contact spots moves after its transient, and how much of "
            "its friction is left: Wetter (2016), chapter 4. Lengths are in units of b, times "
            "of √(m/k_x), where nothing else is said.",
        .verdicts = walk_verdicts(report, vibration),
        .settings = walk_settings(report.walk_case),
        .sections = {motion_section(report), contact_section(report), course_section(report)},
        .files = report.files,
        .command = report.command,
        .version = report.version};
    if (vibration) document.sections.push_back(vibration_section(report, *vibration));
    if (const auto energy = energy_of(report)) {
        document.verdicts.push_back(energy_verdict(report, *energy));
        document.sections.push_back(energy_section(*energy));
    }
    const SlidingStability stability = sliding_stability(report.walk_case.machine);
    document.verdicts.push_back(stability_verdict(report, stability));
    if (!stability.eigenvalues.empty()) document.sections.push_back(stability_section(stability));
    return document;
}

}  // namespace tricontact::walking
