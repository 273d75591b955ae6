#include "io/vtk_series.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkStringArray.h>
#include <vtkUnsignedCharArray.h>
#include <vtkXMLImageDataWriter.h>
#include <vtkXMLPolyDataWriter.h>
#include <vtkZLibDataCompressor.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <stdexcept>

#include "io/atomic_file.h"
#include "io/messages.h"

namespace tricontact::io {

namespace {

using contact::Surface;
using Values = std::vector<double>;

// Fields that a layout lacks are empty; any other size is a programming error.
bool present(const Values& values, const Surface& surface, const char* name) {
    if (values.empty() && surface.size() > 0) return false;
    if (values.size() != surface.size())
        throw std::invalid_argument(std::string(name) + ": one value per contact point is due");
    return true;
}

void add_scalar(vtkFieldData& data, const Surface& surface, const char* name,
                const Values& values) {
    if (!present(values, surface, name)) return;
    vtkNew<vtkDoubleArray> array;
    array->SetName(name);
    array->SetNumberOfTuples(static_cast<vtkIdType>(values.size()));
    std::copy(values.begin(), values.end(), array->GetPointer(0));
    data.AddArray(array);
}

// Components that a layout lacks are zero; `z_sign` turns a component into the substrate outwards.
void add_vector(vtkFieldData& data, const Surface& surface, const char* name,
                const std::array<const Values*, 3>& components, double z_sign = 1) {
    vtkNew<vtkDoubleArray> array;
    array->SetName(name);
    array->SetNumberOfComponents(3);
    array->SetNumberOfTuples(static_cast<vtkIdType>(surface.size()));
    array->Fill(0);
    double* out = array->GetPointer(0);
    for (std::size_t k = 0; k < 3; ++k) {
        if (!components[k] || !present(*components[k], surface, name)) continue;
        const double sign = k == 2 ? z_sign : 1;
        for (std::size_t i = 0; i < surface.size(); ++i)
            out[3 * i + k] = sign * (*components[k])[i];
    }
    data.AddArray(array);
}

void add_state(vtkFieldData& data, const Surface& surface) {
    if (surface.contact_state.size() != surface.size())
        throw std::invalid_argument("contact_state: one value per contact point is due");
    vtkNew<vtkUnsignedCharArray> array;
    array->SetName("contact_state");
    array->SetNumberOfTuples(static_cast<vtkIdType>(surface.size()));
    for (std::size_t i = 0; i < surface.size(); ++i)
        array->SetValue(static_cast<vtkIdType>(i),
                        static_cast<unsigned char>(surface.contact_state[i]));
    data.AddArray(array);
}

void add_fields(vtkFieldData& data, const Surface& s) {
    add_scalar(data, s, "normal_traction_Pa", s.normal_traction);
    add_vector(data, s, "tangential_traction_Pa",
               {&s.tangential_traction_x, &s.tangential_traction_y, nullptr});
    add_scalar(data, s, "friction_bound_Pa", s.friction_bound);
    add_vector(data, s, "displacement_m", {&s.displacement_x, &s.displacement_y, &s.displacement_z},
               -1);
    add_scalar(data, s, "gap_m", s.gap);
    add_vector(data, s, "slip_m", {&s.slip_x, &s.slip_y, nullptr});
    add_scalar(data, s, "dissipation_J_per_m2", s.dissipation);
    add_state(data, s);
    if (s.layout == Surface::Layout::line) {
        add_scalar(data, s, "normal_line_load_N_per_m", s.normal_line_load);
        add_scalar(data, s, "tangential_line_load_N_per_m", s.tangential_line_load);
    }
}

void add_numbers(vtkFieldData& data, const char* name, std::initializer_list<double> values) {
    vtkNew<vtkDoubleArray> array;
    array->SetName(name);
    array->SetNumberOfComponents(static_cast<int>(values.size()));
    array->SetNumberOfTuples(1);
    std::copy(values.begin(), values.end(), array->GetPointer(0));
    data.AddArray(array);
}

void add_text(vtkFieldData& data, const char* name, const std::string& text) {
    vtkNew<vtkStringArray> array;
    array->SetName(name);
    array->InsertNextValue(text);
    data.AddArray(array);
}

void add_provenance(vtkFieldData& data, double phase, const Surface& surface,
                    const Provenance& provenance) {
    add_numbers(data, "TimeValue", {phase});
    add_numbers(data, "indenter_position_m", {surface.offset[0], surface.offset[1], 0.});
    add_text(data, "program_version", provenance.program_version);
    add_text(data, "command_line", provenance.command_line);
}

vtkSmartPointer<vtkImageData> image_of(const Surface& s) {
    auto image = vtkSmartPointer<vtkImageData>::New();
    image->SetDimensions(s.n_x + 1, s.n_y + 1, 1);
    image->SetSpacing(s.spacing[0], s.spacing[1], 1);
    image->SetOrigin(s.first[0] - s.spacing[0] / 2, s.first[1] - s.spacing[1] / 2, 0);
    add_fields(*image->GetCellData(), s);
    return image;
}

vtkSmartPointer<vtkPolyData> line_of(const Surface& s) {
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    vtkNew<vtkCellArray> vertices, line;
    for (int i = 0; i < s.n_x; ++i) {
        const vtkIdType id = points->InsertNextPoint(s.x(i), s.first[1], 0);
        vertices->InsertNextCell(1, &id);
    }
    line->InsertNextCell(s.n_x);
    for (int i = 0; i < s.n_x; ++i) line->InsertCellPoint(i);
    auto poly = vtkSmartPointer<vtkPolyData>::New();
    poly->SetPoints(points);
    poly->SetVerts(vertices);
    poly->SetLines(line);
    add_fields(*poly->GetPointData(), s);
    return poly;
}

// Appended, zlib-compressed, raw: small, exact, and the same bytes each time.
template <class Writer, class Data>
std::string xml_of(Data& data) {
    vtkNew<Writer> writer;
    vtkNew<vtkZLibDataCompressor> compressor;
    writer->SetInputData(&data);
    writer->SetDataModeToAppended();
    writer->EncodeAppendedDataOff();
    writer->SetCompressor(compressor);
    writer->SetHeaderTypeToUInt64();
    writer->WriteToOutputStringOn();
    if (!writer->Write()) throw std::runtime_error("VTK could not serialise a contact surface");
    return writer->GetOutputString();
}

std::string xml_attribute(std::string_view text) {
    std::string out;
    for (const char c : text) {
        if (c == '&')
            out += "&amp;";
        else if (c == '<')
            out += "&lt;";
        else if (c == '"')
            out += "&quot;";
        else
            out += c;
    }
    return out;
}

}  // namespace

VtkSeries::VtkSeries(std::string folder, std::string name, Provenance provenance)
    : folder_(std::move(folder)), name_(std::move(name)), provenance_(std::move(provenance)) {}

void VtkSeries::add(double phase, const contact::Surface& surface) {
    const bool grid = surface.layout == Surface::Layout::grid;
    std::array<char, 24> number{};
    std::snprintf(number.data(), number.size(), "_%06zu", entries_.size());
    const std::string file = name_ + number.data() + (grid ? ".vti" : ".vtp");
    std::string bytes;
    if (grid) {
        const auto image = image_of(surface);
        add_provenance(*image->GetFieldData(), phase, surface, provenance_);
        bytes = xml_of<vtkXMLImageDataWriter>(*image);
    } else {
        const auto line = line_of(surface);
        add_provenance(*line->GetFieldData(), phase, surface, provenance_);
        bytes = xml_of<vtkXMLPolyDataWriter>(*line);
    }
    write_file((std::filesystem::path(folder_) / file).string(), bytes);
    entries_.push_back({phase, file});
}

void VtkSeries::finish() const {
    std::string out =
        "<?xml version=\"1.0\"?>\n"
        "<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\"LittleEndian\">\n"
        "  <Collection>\n";
    for (const Entry& entry : entries_)
        out += "    <DataSet timestep=\"" + shortest(entry.phase) +
               "\" group=\"\" part=\"0\" file=\"" + xml_attribute(entry.file) + "\"/>\n";
    out += "  </Collection>\n</VTKFile>\n";
    write_file((std::filesystem::path(folder_) / (name_ + ".pvd")).string(), out);
}

}  // namespace tricontact::io
