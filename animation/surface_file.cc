#include "animation/surface_file.h"

#include <vtkCallbackCommand.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCommand.h>
#include <vtkImageData.h>
#include <vtkLogger.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLImageDataReader.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <algorithm>
#include <array>

#include "contact/error.h"
#include "files/regular_file.h"

namespace tricontact::animation {

namespace {

using contact::Surface;

constexpr std::uint64_t most_bytes = 1'000'000'000;

[[noreturn]] void refuse(const std::string& path, const std::string& what) {
    throw contact::InputError(path + ": " + what + "; run the case again");
}

vtkDataArray& array_of(vtkDataSetAttributes& data, const char* name, int n_components,
                       std::size_t n, const std::string& path) {
    vtkDataArray* array = data.GetArray(name);
    if (!array || array->GetNumberOfComponents() != n_components ||
        array->GetNumberOfTuples() != static_cast<vtkIdType>(n))
        refuse(path, std::string("has no field ") + name + " of its points");
    return *array;
}

std::vector<double> component(vtkDataArray& array, int k, double sign = 1) {
    std::vector<double> values(static_cast<std::size_t>(array.GetNumberOfTuples()));
    for (std::size_t i = 0; i < values.size(); ++i)
        values[i] = sign * array.GetComponent(static_cast<vtkIdType>(i), k);
    return values;
}

void set_fields(vtkDataSetAttributes& data, Surface& s, const std::string& path) {
    const std::size_t n = s.size();
    const auto array = [&](const char* name, int n_components) -> vtkDataArray& {
        return array_of(data, name, n_components, n, path);
    };
    s.normal_traction = component(array("normal_traction_Pa", 1), 0);
    s.tangential_traction_x = component(array("tangential_traction_Pa", 3), 0);
    s.tangential_traction_y = component(array("tangential_traction_Pa", 3), 1);
    s.gap = component(array("gap_m", 1), 0);
    s.displacement_x = component(array("displacement_m", 3), 0);
    s.displacement_y = component(array("displacement_m", 3), 1);
    s.displacement_z = component(array("displacement_m", 3), 2, -1);  // out of the substrate there
    for (const double state : component(array("contact_state", 1), 0)) {
        if (state != 0 && state != 1 && state != 2) refuse(path, "has a contact state beyond 2");
        s.contact_state.push_back(static_cast<contact::ContactState>(static_cast<int>(state)));
    }
}

/// Has the reader read the bytes; what VTK complains about is refused.
template <class Reader>
void read_into(Reader& reader, const std::string& bytes, const std::string& path) {
    vtkLogger::SetStderrVerbosity(
        vtkLogger::VERBOSITY_OFF);  // it is said once, as an error of ours
    bool failed = false;
    vtkNew<vtkCallbackCommand> complaint;
    complaint->SetClientData(&failed);
    complaint->SetCallback(
        [](vtkObject*, unsigned long, void* seen, void*) { *static_cast<bool*>(seen) = true; });
    reader.AddObserver(vtkCommand::ErrorEvent, complaint);
    reader.ReadFromInputStringOn();
    reader.SetInputString(bytes);
    reader.Update();
    if (failed || reader.GetErrorCode() != 0) refuse(path, "is no whole file of VTK");
}

Surface grid_of(const std::string& bytes, const std::string& path) {
    vtkNew<vtkXMLImageDataReader> reader;
    read_into(*reader, bytes, path);
    vtkImageData& image = *reader->GetOutput();
    Surface s;
    s.layout = Surface::Layout::grid;
    s.n_x = image.GetDimensions()[0] - 1;
    s.n_y = image.GetDimensions()[1] - 1;
    if (s.n_x < 1 || s.n_y < 1) refuse(path, "has no cells");
    for (int d = 0; d < 2; ++d) {
        s.spacing[d] = image.GetSpacing()[d];
        s.first[d] = image.GetOrigin()[d] + s.spacing[d] / 2;
    }
    set_fields(*image.GetCellData(), s, path);
    return s;
}

Surface line_of(const std::string& bytes, const std::string& path) {
    vtkNew<vtkXMLPolyDataReader> reader;
    read_into(*reader, bytes, path);
    vtkPolyData& poly = *reader->GetOutput();
    Surface s;
    s.layout = Surface::Layout::line;
    s.n_x = static_cast<int>(poly.GetNumberOfPoints());
    s.n_y = 1;
    if (s.n_x < 2) refuse(path, "has no line of points");
    std::array<double, 3> first{}, last{};
    poly.GetPoint(0, first.data());
    poly.GetPoint(s.n_x - 1, last.data());
    s.first = {first[0], first[1]};
    s.spacing = {(last[0] - first[0]) / (s.n_x - 1), 0};
    if (!(s.spacing[0] > 0)) refuse(path, "has points that do not follow each other");
    set_fields(*poly.GetPointData(), s, path);
    return s;
}

Surface nodes_of(const std::string& bytes, const std::string& path) {
    vtkNew<vtkXMLUnstructuredGridReader> reader;
    read_into(*reader, bytes, path);
    vtkUnstructuredGrid& grid = *reader->GetOutput();
    Surface s;
    s.layout = Surface::Layout::nodes;
    for (vtkIdType i = 0; i < grid.GetNumberOfPoints(); ++i) {
        std::array<double, 3> place{};
        grid.GetPoint(i, place.data());
        s.node_x.push_back(place[0]);
        s.node_y.push_back(place[1]);
    }
    for (vtkIdType i = 0; i < grid.GetNumberOfCells(); ++i) {
        vtkIdType n = 0;
        const vtkIdType* nodes = nullptr;
        grid.GetCellPoints(i, n, nodes);
        const auto is_node = [&](vtkIdType k) { return k >= 0 && k < grid.GetNumberOfPoints(); };
        if (n != 9 || !std::all_of(nodes, nodes + n, is_node))
            refuse(path, "has a cell that is no quadrilateral of nine nodes");
        auto& quad = s.quads.emplace_back();
        std::copy(nodes, nodes + n, quad.begin());
    }
    if (s.quads.empty()) refuse(path, "has no cells");
    set_fields(*grid.GetPointData(), s, path);
    return s;
}

}  // namespace

std::string content_of(const std::string& path) {
    try {
        return files::RegularFile(path).content(most_bytes);
    } catch (const files::Unreadable& error) {
        throw contact::InputError(path + ": " + error.what());
    }
}

Surface read_surface(const std::string& path) {
    const std::string bytes = content_of(path);
    if (path.ends_with(".vti")) return grid_of(bytes, path);
    if (path.ends_with(".vtp")) return line_of(bytes, path);
    if (path.ends_with(".vtu")) return nodes_of(bytes, path);
    refuse(path, "is no .vti, .vtp or .vtu");
}

}  // namespace tricontact::animation
