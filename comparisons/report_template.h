#pragma once

namespace tricontact::comparisons {

/// report.html.mustache, report_table.html.mustache and report.css, embedded when the program is
/// built.
extern const char* const report_template;
extern const char* const report_table_template;
extern const char* const report_style;

}  // namespace tricontact::comparisons
