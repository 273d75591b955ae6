#include "benchmarks/vtk_reader/vtk_files.h"

#include <vtkCGNSReader.h>
#include <vtkCell.h>
#include <vtkCellData.h>
#include <vtkCompositeDataSet.h>
#include <vtkDataArray.h>
#include <vtkDataObjectTree.h>
#include <vtkDataObjectTreeIterator.h>
#include <vtkDataSet.h>
#include <vtkExodusIIReader.h>
#include <vtkGenericDataObjectReader.h>
#include <vtkGenericEnSightReader.h>
#include <vtkHDFReader.h>
#include <vtkInformation.h>
#include <vtkPointData.h>
#include <vtkSmartPointer.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkUnsignedCharArray.h>
#include <vtkXMLGenericDataObjectReader.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <set>
#include <stdexcept>

#include "benchmarks/submissions/column_names.h"

namespace tricontact::benchmarks {

namespace {

namespace fs = std::filesystem;
template <class T>
using Pointer = vtkSmartPointer<T>;

bool means_something(const std::string& name, int n_components) {
    return std::ranges::any_of(component_names(name, n_components), [](const auto& component) {
        return recognised(component).meaning != Meaning::other;
    });
}

/// Arrays whose components mean something; others are named.
std::vector<MeshArray> arrays_of(vtkDataSetAttributes* data, std::size_t n,
                                 std::set<std::string>& unused) {
    std::vector<MeshArray> arrays;
    for (int i = 0; data && i < data->GetNumberOfArrays(); ++i) {
        vtkDataArray* const values = data->GetArray(i);
        if (!values || !values->GetName()) continue;
        std::string name = values->GetName();
        const int n_components = values->GetNumberOfComponents();
        // VTK writes names for EnSight with "_n" for nodes and "_c" for cells.
        const bool has_end = name.ends_with("_n") || name.ends_with("_c");
        if (has_end && !means_something(name, n_components)) name.resize(name.size() - 2);
        if (n_components > 9 || static_cast<std::size_t>(values->GetNumberOfTuples()) != n ||
            !means_something(name, n_components)) {
            if (!name.starts_with("vtk") && unused.size() < 100) unused.insert(name);
            continue;
        }
        MeshArray array{name, n_components, {}, {}};
        array.values.reserve(n * static_cast<std::size_t>(n_components));
        for (vtkIdType k = 0; k < values->GetNumberOfTuples(); ++k)
            for (int c = 0; c < n_components; ++c)
                array.values.push_back(values->GetComponent(k, c));
        arrays.push_back(std::move(array));
    }
    return arrays;
}

MeshData mesh_of(vtkDataSet* data, const std::string& name, std::set<std::string>& unused) {
    constexpr vtkIdType most = 20'000'000;
    if (data->GetNumberOfPoints() > most || data->GetNumberOfCells() > most)
        throw std::runtime_error("has more than 20 million points or cells");
    MeshData mesh;
    mesh.name = name;
    for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i) {
        std::array<double, 3> at{};
        data->GetPoint(i, at.data());
        mesh.points.push_back(at);
    }
    const vtkUnsignedCharArray* const ghosts = data->GetCellGhostArray();
    std::vector<std::size_t> kept;
    const auto nodes = Pointer<vtkIdList>::New();
    for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell) {
        constexpr int left_out =
            vtkDataSetAttributes::DUPLICATECELL | vtkDataSetAttributes::HIDDENCELL;
        if (ghosts && (const_cast<vtkUnsignedCharArray*>(ghosts)->GetValue(cell) & left_out) != 0)
            continue;
        kept.push_back(static_cast<std::size_t>(cell));
        data->GetCellPoints(cell, nodes);
        for (vtkIdType k = 0; k < nodes->GetNumberOfIds(); ++k) {
            const vtkIdType node = nodes->GetId(k);
            if (node < 0 || node >= data->GetNumberOfPoints())
                throw std::runtime_error("a cell has a point that is not there");
            mesh.connectivity.push_back(static_cast<int>(node));
        }
        mesh.types.push_back(static_cast<std::uint8_t>(data->GetCellType(cell)));
        mesh.offsets.push_back(static_cast<std::int64_t>(mesh.connectivity.size()));
    }
    mesh.point_arrays = arrays_of(data->GetPointData(), mesh.points.size(), unused);
    mesh.cell_arrays =
        arrays_of(data->GetCellData(), static_cast<std::size_t>(data->GetNumberOfCells()), unused);
    if (kept.size() < static_cast<std::size_t>(data->GetNumberOfCells()))
        for (MeshArray& array : mesh.cell_arrays) {
            std::vector<double> values;
            const auto n = static_cast<std::size_t>(array.n_components);
            for (const std::size_t cell : kept)
                values.insert(values.end(),
                              array.values.begin() + static_cast<std::ptrdiff_t>(cell * n),
                              array.values.begin() + static_cast<std::ptrdiff_t>((cell + 1) * n));
            array.values = std::move(values);
        }
    return mesh;
}

/// Leaves of a tree with their names.
void add_meshes(vtkDataObject* object, MeshAnswer& answer, std::set<std::string>& unused) {
    if (auto* const data = vtkDataSet::SafeDownCast(object)) {
        answer.meshes.push_back(mesh_of(data, "", unused));
        return;
    }
    auto* const tree = vtkDataObjectTree::SafeDownCast(object);
    if (!tree) throw std::runtime_error("holds no mesh that VTK can read");
    const auto leaves = Pointer<vtkDataObjectTreeIterator>::New();
    leaves->SetDataSet(tree);
    leaves->SkipEmptyNodesOn();
    leaves->VisitOnlyLeavesOn();
    leaves->TraverseSubTreeOn();
    for (leaves->InitTraversal(); !leaves->IsDoneWithTraversal(); leaves->GoToNextItem()) {
        auto* const data = vtkDataSet::SafeDownCast(leaves->GetCurrentDataObject());
        if (!data || data->GetNumberOfPoints() == 0) continue;
        const char* const name =
            leaves->HasCurrentMetaData()
                ? leaves->GetCurrentMetaData()->Get(vtkCompositeDataSet::NAME())
                : nullptr;
        answer.meshes.push_back(mesh_of(
            data, name ? name : "block " + std::to_string(answer.meshes.size() + 1), unused));
        if (answer.meshes.size() > 1000) throw std::runtime_error("has more than 1000 blocks");
    }
}

/// At the last time that the reader offers.
void update_to_last(vtkAlgorithm* reader) {
    reader->UpdateInformation();
    vtkInformation* const information = reader->GetOutputInformation(0);
    const auto key = vtkStreamingDemandDrivenPipeline::TIME_STEPS();
    if (information && information->Has(key) && information->Length(key) > 0)
        reader->UpdateTimeStep(information->Get(key)[information->Length(key) - 1]);
    else
        reader->Update();
}

/// Value of an attribute of an element of XML; empty if it has none.
std::string attribute(std::string_view element, const std::string& name) {
    for (const char quote : {'"', '\''}) {
        const std::string begin = name + '=' + quote;
        auto at = element.find(begin);
        while (at != element.npos && at > 0 &&
               !std::isspace(static_cast<unsigned char>(element[at - 1])))
            at = element.find(begin, at + 1);
        if (at == element.npos) continue;
        at += begin.size();
        return std::string(element.substr(at, element.find(quote, at) - at));
    }
    return {};
}

/// Files of the last time of a collection of ParaView (.pvd).
std::vector<std::string> files_of_last_time(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    std::string text(4'000'000, '\0');
    in.read(text.data(), static_cast<std::streamsize>(text.size()));
    text.resize(static_cast<std::size_t>(in.gcount()));
    if (in.peek() != EOF) throw std::runtime_error("is larger than 4 MB: no collection of files");
    std::vector<std::string> files;
    double last = -INFINITY;
    for (auto at = text.find("<DataSet"); at != text.npos; at = text.find("<DataSet", at + 1)) {
        const std::string_view element = std::string_view(text).substr(at, text.find('>', at) - at);
        const std::string file = attribute(element, "file"), time = attribute(element, "timestep");
        double value = 0;
        if (!time.empty() &&
            std::from_chars(time.data(), time.data() + time.size(), value).ec != std::errc())
            throw std::runtime_error("a timestep is no number");
        if (file.empty() || value < last) continue;
        if (value > last) files.clear();
        last = value;
        files.push_back((fs::path(path).parent_path() / file).string());
    }
    if (files.empty()) throw std::runtime_error("names no files: <DataSet timestep=... file=.../>");
    if (files.size() > 1000) throw std::runtime_error("names more than 1000 files of one time");
    return files;
}

/// A reader holds what it reads.
Pointer<vtkAlgorithm> make_reader(const std::string& path, const std::string& ending) {
    if (ending == ".vtk") {
        const auto reader = Pointer<vtkGenericDataObjectReader>::New();
        reader->SetFileName(path.c_str());
        reader->ReadAllScalarsOn();
        reader->ReadAllVectorsOn();
        reader->ReadAllTensorsOn();
        reader->ReadAllFieldsOn();
        return reader;
    }
    if (ending == ".e" || ending == ".exo" || ending == ".ex2") {
        const auto reader = Pointer<vtkExodusIIReader>::New();
        reader->SetFileName(path.c_str());
        reader->ApplyDisplacementsOff();
        reader->GenerateObjectIdCellArrayOff();
        reader->UpdateInformation();
        for (const int kind :
             {vtkExodusIIReader::NODAL, vtkExodusIIReader::ELEM_BLOCK, vtkExodusIIReader::SIDE_SET})
            reader->SetAllArrayStatus(kind, 1);
        for (int i = 0; i < reader->GetNumberOfObjects(vtkExodusIIReader::SIDE_SET); ++i)
            reader->SetObjectStatus(vtkExodusIIReader::SIDE_SET, i, 1);
        return reader;
    }
    if (ending == ".case") {
        const auto reader = Pointer<vtkGenericEnSightReader>::New();
        reader->SetCaseFileName(path.c_str());
        reader->ReadAllVariablesOn();
        return reader;
    }
    if (ending == ".cgns") {
        const auto reader = Pointer<vtkCGNSReader>::New();
        reader->SetFileName(path.c_str());
        reader->UpdateInformation();
        reader->EnableAllBases();
        reader->EnableAllPointArrays();
        reader->EnableAllCellArrays();
        return reader;
    }
    if (ending == ".vtkhdf" || ending == ".hdf") {
        const auto reader = Pointer<vtkHDFReader>::New();
        if (reader->CanReadFile(path.c_str()) == 0) throw std::runtime_error("is no VTKHDF file");
        reader->SetFileName(path.c_str());
        return reader;
    }
    const auto reader = Pointer<vtkXMLGenericDataObjectReader>::New();
    reader->SetFileName(path.c_str());
    return reader;
}

void read_one(const std::string& path, MeshAnswer& answer, std::set<std::string>& unused) {
    std::string ending = fs::path(path).extension().string();
    std::ranges::transform(ending, ending.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    const Pointer<vtkAlgorithm> reader = make_reader(path, ending);
    update_to_last(reader);
    vtkDataObject* const output = reader->GetOutputDataObject(0);
    if (!output) throw std::runtime_error("VTK cannot read it");
    const std::size_t before = answer.meshes.size();
    add_meshes(output, answer, unused);
    if (ending.starts_with(".pv"))
        for (std::size_t i = before; i < answer.meshes.size(); ++i)
            answer.meshes[i].has_pieces = true;
}

/// Pieces of one collection as one mesh; arrays that all of them have.
void join(std::vector<MeshData>& meshes, std::set<std::string>& unused) {
    const auto joined = [&](auto of, auto n_items) {
        std::vector<MeshArray> arrays = of(meshes.front());
        std::erase_if(arrays, [&](MeshArray& array) {
            for (std::size_t m = 1; m < meshes.size(); ++m) {
                const auto& others = of(meshes[m]);
                const auto same = std::ranges::find_if(others, [&](const MeshArray& other) {
                    return other.name == array.name && other.n_components == array.n_components;
                });
                if (same == others.end() && n_items(meshes[m]) > 0) {
                    unused.insert(array.name);
                    return true;
                }
                if (same != others.end())
                    array.values.insert(array.values.end(), same->values.begin(),
                                        same->values.end());
            }
            return false;
        });
        return arrays;
    };
    std::vector<MeshArray> at_points = joined(
        [](const MeshData& mesh) -> const auto& { return mesh.point_arrays; },
        [](const MeshData& mesh) { return mesh.points.size(); });
    std::vector<MeshArray> at_cells = joined(
        [](const MeshData& mesh) -> const auto& { return mesh.cell_arrays; },
        [](const MeshData& mesh) { return mesh.n_cells(); });
    MeshData all = std::move(meshes.front());
    for (std::size_t m = 1; m < meshes.size(); ++m) {
        const auto first = static_cast<int>(all.points.size());
        const auto begin = static_cast<std::int64_t>(all.connectivity.size());
        all.points.insert(all.points.end(), meshes[m].points.begin(), meshes[m].points.end());
        all.types.insert(all.types.end(), meshes[m].types.begin(), meshes[m].types.end());
        for (const int node : meshes[m].connectivity) all.connectivity.push_back(first + node);
        for (std::size_t k = 1; k < meshes[m].offsets.size(); ++k)
            all.offsets.push_back(begin + meshes[m].offsets[k]);
    }
    all.point_arrays = std::move(at_points);
    all.cell_arrays = std::move(at_cells);
    all.has_pieces = true;
    meshes = {std::move(all)};
}

}  // namespace

MeshAnswer read_by_vtk(const std::string& path) {
    MeshAnswer answer;
    std::set<std::string> unused;
    std::string ending = fs::path(path).extension().string();
    if (ending == ".pvd" || ending == ".PVD") {
        const auto files = files_of_last_time(path);
        for (const std::string& file : files) {
            if (fs::path(file).extension() == ".pvd")
                throw std::runtime_error("names a collection again");
            if (!fs::is_regular_file(file))
                throw std::runtime_error("names a file that is not there: " + file);
            read_one(file, answer, unused);
        }
        if (files.size() > 1 && answer.meshes.size() > 1) join(answer.meshes, unused);
    } else {
        read_one(path, answer, unused);
    }
    if (answer.meshes.empty()) throw std::runtime_error("holds no points");
    std::string names;
    for (const std::string& name : unused) names += (names.empty() ? "" : ", ") + name;
    if (!names.empty()) answer.notes.push_back("arrays not used: " + names);
    return answer;
}

}  // namespace tricontact::benchmarks
