#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <initializer_list>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "io/results/vtk_files.h"

namespace tricontact::io {

/// A grid of a surface as an image: fields at its points, as those of elements are at their nodes.
/// A single row of cells, which has an extent across, keeps them in its cells.
struct ImageGrid {
    std::string extent, origin, spacing;
    const char* data;  ///< element of its fields: PointData or CellData
};
ImageGrid image_grid(const std::array<int, 2>& n_points, const std::array<double, 2>& first,
                     const std::array<double, 2>& spacing);

/// Memory that is used again and again, not initialised.
template <class T>
class Scratch {
  public:
    /// For `n` values, until the next call.
    std::span<T> of(std::size_t n) {
        if (n > n_) memory_ = std::make_unique_for_overwrite<T[]>(n);
        n_ = std::max(n, n_);
        return {memory_.get(), n};
    }

  private:
    std::size_t n_ = 0;
    std::unique_ptr<T[]> memory_;
};

/// A data set as VTK's XML, arrays appended, compressed by zlib, raw: small, exact, and the same
/// bytes each time. Elements and blocks are those of "VTK File Formats" (The VTK User's Guide).
/// VTK's own writer takes three times as long for a surface, and loading its libraries as long as
/// all else about the program's start. Arrays belong to the element that was begun last. Those with
/// a number `n` of points or cells throw std::invalid_argument unless there is one value for each.
class VtkXml {
  public:
    using Attributes = std::initializer_list<std::pair<std::string_view, std::string>>;

    /// `type` of data set: "ImageData" ...
    explicit VtkXml(std::string_view type, const Attributes& attributes = {});

    void begin(std::string_view element, const Attributes& attributes = {});
    void end();

    // Of field data.

    /// One tuple of numbers for the whole data set, in double precision.
    void add_numbers(std::string_view name, std::initializer_list<double> values);
    void add_texts(std::string_view name, const std::vector<std::string>& texts);
    void add_provenance(const Provenance& provenance);

    // Fields, kept in single precision, 7 digits.

    /// A number each; nothing is added if the field is empty.
    void add_scalar(std::string_view name, std::span<const double> values, std::size_t n);
    /// A vector each; components that are empty are zero. `z_sign` multiplies the third component.
    void add_vector(std::string_view name, const std::array<std::span<const double>, 3>& components,
                    std::size_t n, double z_sign = 1);
    void add_bytes(std::string_view name, std::span<const std::uint8_t> values, std::size_t n);

    // Geometry.

    /// Positions in double precision.
    void add_points(std::span<const std::array<double, 3>> positions);
    /// Points of the cells one after another, and where each cell ends among them.
    void add_cells(std::span<const std::int64_t> points, std::span<const std::int64_t> ends);

    /// Ends all elements. Nothing may be added any more.
    VtkFile file();

  private:
    void add_array(std::string_view type, std::string_view name, int n_components,
                   std::string_view attributes, const void* values, std::size_t n_bytes);
    void add_field(std::string_view name, int n_components, std::span<const float> field);
    void append(const void* values, std::size_t n_bytes);

    std::vector<std::string> open_;  // elements that have not been ended
    std::string extension_, head_, blocks_;
    Scratch<float> field_;
    Scratch<char> compressed_;
};

}  // namespace tricontact::io
