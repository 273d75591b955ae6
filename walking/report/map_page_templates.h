#pragma once

namespace tricontact::walking {

// map_page.* of this folder, embedded when the program is built.

extern const char* const map_page_template;
extern const char* const map_page_style;
extern const char* const map_page_script;

}  // namespace tricontact::walking
