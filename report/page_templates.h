#pragma once

#include <string_view>

namespace tricontact::report {

// *.html.mustache, *.css and *.js of this folder, embedded when the program is built.

/// What every page shares: colours by day, night and on paper, letters, tables, figures.
extern const char* const page_style;

/// What the scripts that draw share, without its colours: charts_script() is for pages.
extern const char* const charts_template;

/// A map with a marker on it, and the charts beside it.
extern const char* const marked_map_style;
extern const char* const marked_map_script;

extern const char* const document_template;
/// Its parts.
extern const char* const table_template;
extern const char* const figure_template;
extern const char* const verdicts_template;
extern const char* const document_style;
extern const char* const figures_script;
extern const char* const document_script;

/// Plays the contact of a document that has a player.
extern const char* const player_style;
extern const char* const player_movie;
extern const char* const player_difference;
extern const char* const player_script;

/// The script that draws charts (plotly.js), its licence in front, embedded when the program is
/// built: cmake/npm_packages.cmake. It defines `Plotly`.
std::string_view chart_library();
/// The script that draws the contact of a player in three dimensions (three.js), likewise. It
/// defines `contact_scene`.
std::string_view scene_library();

}  // namespace tricontact::report
