#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "contact/bodies/height_map.h"
#include "io/tables/divided_text.h"

namespace tricontact::io {

/// What a file of bare numbers leaves open.
struct HeightMapScale {
    double spacing = 0;  ///< of the nodes in x and y [m]
    double unit = 0;     ///< 1 of the heights [m]
};

/// The file's format, by the end of its name, says spacing and unit itself: .sdf.
bool says_its_scale(const std::string& path);

/// Reads a height map, rows along x, the first at the smallest y:
///   .npy  an array of n_y by n_x (NumPy's format 1.0 or 2.0, little endian f4 or f8);
///   .sdf  ASCII file of ISO 25178-71, which says spacing and unit itself;
///   .csv, .txt  a matrix of numbers divided by commas, semicolons, tabs or blanks.
/// Arrays and matrices may also hold coordinates, see laid_out(). Missing values, infinite ones and
/// what does not fit are refused with file, line (of an array: row and column), rule, remedy. The
/// heights are as the file has them, whichever way they point. `scale`: empty for .sdf alone.
/// Throws contact::InputError.
contact::HeightMap read_height_map(const std::string& path,
                                   const std::optional<HeightMapScale>& scale);

/// The three formats, `name` standing for the file in messages.
contact::HeightMap parse_npy(std::string_view bytes, const std::string& name,
                             const HeightMapScale& scale);
contact::HeightMap parse_sdf(std::string_view text, const std::string& name);
contact::HeightMap parse_height_matrix(std::string_view text, const std::string& name,
                                       const HeightMapScale& scale);

/// A height in a text. Throws contact::InputError where it is none.
double height_in(std::string_view word, DecimalReader& numbers, const std::string& name,
                 std::size_t line);

/// Most nodes of a map: those of the largest grid.
inline constexpr double most_height_nodes = 4096. * 4096;

}  // namespace tricontact::io
