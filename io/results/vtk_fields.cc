#include "io/results/vtk_fields.h"

#include <vtkDataObject.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkInformation.h>
#include <vtkInformationDoubleVectorKey.h>
#include <vtkInformationInformationVectorKey.h>
#include <vtkInformationVector.h>
#include <vtkLZ4DataCompressor.h>
#include <vtkNew.h>
#include <vtkPointSet.h>
#include <vtkPoints.h>
#include <vtkSmartPointer.h>
#include <vtkStringArray.h>
#include <vtkUnsignedCharArray.h>
#include <vtkXMLDataObjectWriter.h>
#include <vtkXMLWriter.h>
#include <vtkZLibDataCompressor.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace tricontact::io {

namespace {

void check_size(const char* name, std::size_t size, std::size_t n) {
    if (size != n)
        throw std::invalid_argument(std::string(name) + ": " + std::to_string(n) +
                                    " values are due, not " + std::to_string(size));
}

template <class Array = vtkFloatArray>
vtkNew<Array> array_of(const char* name, int n_components, std::size_t n) {
    vtkNew<Array> array;
    array->SetName(name);
    array->SetNumberOfComponents(n_components);
    array->SetNumberOfTuples(static_cast<vtkIdType>(n));
    return array;
}

/// Adds the array and tells VTK its range, of vectors that of their lengths: it would wake its
/// threads to find it, which takes longer than all else about a surface.
template <class Array>
void add_array(vtkFieldData& data, Array& array) {
    using Keys = vtkDataArray;
    data.AddArray(&array);
    if (array.GetNumberOfTuples() == 0) return;
    const int n_components = array.GetNumberOfComponents();
    const auto* value = array.GetPointer(0);
    std::array range{std::numeric_limits<double>::max(), std::numeric_limits<double>::lowest()};
    for (vtkIdType i = 0; i < array.GetNumberOfTuples(); ++i) {
        double size = *value++;
        if (n_components > 1) size *= size;
        for (int k = 1; k < n_components; ++k, ++value)
            size += static_cast<double>(*value) * *value;
        range = {std::min(range[0], size), std::max(range[1], size)};
    }
    if (n_components > 1) {
        for (double& end : range) end = std::sqrt(end);
        array.GetInformation()->Set(Keys::L2_NORM_RANGE(), range.data(), 2);
    } else {
        vtkNew<vtkInformationVector> components;
        components->SetNumberOfInformationObjects(1);
        components->GetInformationObject(0)->Set(Keys::COMPONENT_RANGE(), range.data(), 2);
        array.GetInformation()->Set(Keys::PER_COMPONENT(), components);
    }
}

template <std::size_t N>
vtkNew<vtkFloatArray> array_of(const char* name, std::span<const std::array<double, N>> values,
                               std::size_t n) {
    check_size(name, values.size(), n);
    auto array = array_of(name, static_cast<int>(N), n);
    float* out = array->GetPointer(0);
    for (const auto& value : values) out = std::copy(value.begin(), value.end(), out);
    return array;
}

}  // namespace

void add_scalar(vtkFieldData& data, const char* name, std::span<const double> values,
                std::size_t n) {
    if (values.empty()) return;
    check_size(name, values.size(), n);
    auto array = array_of(name, 1, n);
    std::copy(values.begin(), values.end(), array->GetPointer(0));
    add_array(data, *array);
}

void add_vector(vtkFieldData& data, const char* name,
                const std::array<std::span<const double>, 3>& components, std::size_t n,
                double z_sign) {
    auto array = array_of(name, 3, n);
    float* out = array->GetPointer(0);
    for (std::size_t k = 0; k < 3; ++k) {
        const bool given = !components[k].empty();
        if (given) check_size(name, components[k].size(), n);
        const double sign = k == 2 ? z_sign : 1;
        for (std::size_t i = 0; i < n; ++i)
            out[3 * i + k] = given ? static_cast<float>(sign * components[k][i]) : 0;
    }
    add_array(data, *array);
}

void add_vector(vtkFieldData& data, const char* name, std::span<const std::array<double, 3>> values,
                std::size_t n) {
    add_array(data, *array_of(name, values, n));
}

void add_tensor(vtkFieldData& data, const char* name, std::span<const std::array<double, 6>> values,
                std::size_t n) {
    auto array = array_of(name, values, n);
    vtkIdType k = 0;
    for (const char* component : {"XX", "YY", "ZZ", "XY", "YZ", "XZ"})
        array->SetComponentName(k++, component);
    add_array(data, *array);
}

void add_bytes(vtkFieldData& data, const char* name, std::span<const std::uint8_t> values,
               std::size_t n) {
    check_size(name, values.size(), n);
    vtkNew<vtkUnsignedCharArray> array;
    array->SetName(name);
    array->SetNumberOfTuples(static_cast<vtkIdType>(n));
    std::copy(values.begin(), values.end(), array->GetPointer(0));
    add_array(data, *array);
}

void add_numbers(vtkFieldData& data, const char* name, std::initializer_list<double> values) {
    auto array = array_of<vtkDoubleArray>(name, static_cast<int>(values.size()), 1);
    std::copy(values.begin(), values.end(), array->GetPointer(0));
    add_array(data, *array);
}

void add_texts(vtkFieldData& data, const char* name, const std::vector<std::string>& texts) {
    vtkNew<vtkStringArray> array;
    array->SetName(name);
    for (const std::string& text : texts) array->InsertNextValue(text);
    data.AddArray(array);
}

void add_provenance(vtkFieldData& data, const Provenance& provenance) {
    add_texts(data, "program_version", {provenance.program_version});
    add_texts(data, "command_line", {provenance.command_line});
}

void set_points(vtkPointSet& data, std::span<const std::array<double, 3>> positions) {
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    for (const auto& position : positions) points->InsertNextPoint(position.data());
    data.SetPoints(points);
}

VtkFile xml_of(vtkDataObject& data, Compression compression) {
    const auto writer = vtkSmartPointer<vtkXMLWriter>::Take(
        vtkXMLDataObjectWriter::NewWriter(data.GetDataObjectType()));
    if (compression == Compression::quick) {
        writer->SetCompressor(vtkNew<vtkLZ4DataCompressor>());
    } else {
        vtkNew<vtkZLibDataCompressor> compressor;
        compressor->SetCompressionLevel(1);  // the others take twice the time for 4 % of the size
        writer->SetCompressor(compressor);
    }
    writer->SetInputDataObject(&data);
    writer->SetDataModeToAppended();
    writer->EncodeAppendedDataOff();
    writer->SetBlockSize(1 << 20);  // [bytes]; few arrays are longer
    writer->SetHeaderTypeToUInt64();
    writer->WriteToOutputStringOn();
    if (!writer->Write()) throw std::runtime_error("VTK could not serialise a data set");
    return {std::string(".") + writer->GetDefaultFileExtension(), writer->GetOutputString()};
}

}  // namespace tricontact::io
