#pragma once

namespace tricontact::atlas {

// The files of this folder, embedded when the program is built.

extern const char* const atlas_page_template;
extern const char* const atlas_page_style;
/// Numbers, pictures, and what moves them: they stand in this order.
extern const char* const atlas_theory_script;
extern const char* const atlas_maps_script;
extern const char* const atlas_charts_script;
extern const char* const atlas_page_script;

}  // namespace tricontact::atlas
