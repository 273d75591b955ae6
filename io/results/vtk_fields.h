#pragma once

#include <array>
#include <cstdint>
#include <initializer_list>
#include <span>
#include <string>
#include <vector>

#include "io/results/vtk_files.h"

class vtkDataObject;
class vtkFieldData;
class vtkPointSet;

namespace tricontact::io {

// Arrays of VTK's data sets. All throw std::invalid_argument unless there is one value for each of
// the `n` points or cells.

// Fields are kept in single precision, 7 digits.

/// A number each; nothing is added if the field is empty.
void add_scalar(vtkFieldData& data, const char* name, std::span<const double> values,
                std::size_t n);
/// A vector each; components that are empty are zero. `z_sign` multiplies the third component.
void add_vector(vtkFieldData& data, const char* name,
                const std::array<std::span<const double>, 3>& components, std::size_t n,
                double z_sign = 1);
void add_vector(vtkFieldData& data, const char* name, std::span<const std::array<double, 3>> values,
                std::size_t n);
/// A symmetric tensor each: XX YY ZZ XY YZ XZ, the order that ParaView expects.
void add_tensor(vtkFieldData& data, const char* name, std::span<const std::array<double, 6>> values,
                std::size_t n);
void add_bytes(vtkFieldData& data, const char* name, std::span<const std::uint8_t> values,
               std::size_t n);

/// One tuple of numbers for the whole data set, in double precision.
void add_numbers(vtkFieldData& data, const char* name, std::initializer_list<double> values);
void add_texts(vtkFieldData& data, const char* name, const std::vector<std::string>& texts);
void add_provenance(vtkFieldData& data, const Provenance& provenance);

/// Positions in double precision.
void set_points(vtkPointSet& data, std::span<const std::array<double, 3>> positions);

/// By LZ4, or by zlib, which makes a sixth less of a surface in twenty times the time.
enum class Compression { quick, small };
/// The data set as VTK's XML: appended, compressed, raw; small, exact, and the same bytes
/// each time. Throws std::runtime_error.
VtkFile xml_of(vtkDataObject& data, Compression compression = Compression::small);

}  // namespace tricontact::io
