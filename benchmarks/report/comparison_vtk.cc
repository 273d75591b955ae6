// A code's fields beside those of the reference for ParaView.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numeric>

#include "benchmarks/report/comparison_output.h"
#include "comparisons/quantities/quantities.h"
#include "io/results/vtk_xml.h"

namespace tricontact::benchmarks {

namespace {

using Numbers = std::vector<double>;
using Member = double SurfaceValues::*;

/// vtkCellType.h, by the number of points; of 6 a quadratic triangle.
std::uint8_t cell_type(std::size_t n_points) {
    constexpr std::array<std::uint8_t, 10> types{0, 1, 3, 5, 9, 0, 22, 0, 23, 28};
    return n_points < types.size() ? types[n_points] : 0;
}

/// Lines of three points are quadratic edges, which have the number of points of a triangle.
constexpr std::uint8_t quadratic_edge = 21;

class Fields {
  public:
    Fields(const Comparison& comparison, const MeshResult& mesh) : mesh_(mesh) {
        const ReferenceFields* fields = comparison.reference.fields.get();
        if (!fields) return;
        for (const SurfacePoint& point : mesh.points) {
            exact_.push_back(fields->at(point.x, point.y));
            bars_.push_back(fields->bar_at(point.x, point.y));
        }
    }
    void write(io::VtkXml& xml) const {
        add_scalars(xml, "pressure", &SurfaceValues::pressure);
        add_vectors(xml, "traction", "Pa",
                    {&SurfaceValues::traction_x, &SurfaceValues::traction_y});
        add_vectors(xml, "displacement", "m",
                    {&SurfaceValues::displacement_x, &SurfaceValues::displacement_y,
                     &SurfaceValues::displacement_z});
        const auto of_point = [&](const char* name, double SurfacePoint::*of) {
            Numbers values;
            for (const SurfacePoint& point : mesh_.points) values.push_back(point.*of);
            if (is_told(values)) xml.add_scalar(name, values, values.size());
        };
        of_point("gap_m", &SurfacePoint::gap);
        of_point("status", &SurfacePoint::status);
        of_point("area_m2", &SurfacePoint::area);
    }

  private:
    static bool is_told(const Numbers& values) {
        return std::ranges::any_of(values, [](double value) { return std::isfinite(value); });
    }
    Numbers of_code(Member member) const {
        Numbers values;
        for (const SurfacePoint& point : mesh_.points) values.push_back(point.values.*member);
        return values;
    }
    static Numbers of_values(const std::vector<SurfaceValues>& all, Member member) {
        Numbers values;
        for (const SurfaceValues& one : all) values.push_back(one.*member);
        return values;
    }
    static Numbers minus(Numbers a, const Numbers& b) {
        std::ranges::transform(a, b, a.begin(), std::minus<>());
        return a;
    }
    void add_scalars(io::VtkXml& xml, const std::string& name, Member member) const {
        const Numbers code = of_code(member), exact = of_values(exact_, member);
        const std::size_t n = code.size();
        if (is_told(code)) xml.add_scalar(name + "_Pa", code, n);
        if (!is_told(exact)) return;
        xml.add_scalar(name + "_reference_Pa", exact, n);
        xml.add_scalar(name + "_reference_bar_Pa", of_values(bars_, member), n);
        if (is_told(code)) xml.add_scalar(name + "_difference_Pa", minus(code, exact), n);
    }
    /// Components that are not told are zero where another one is; z turns out of the body.
    void add_vectors(io::VtkXml& xml, const std::string& name, const std::string& unit,
                     const std::vector<Member>& members) const {
        std::array<Numbers, 3> code, exact, bars, apart;
        bool is_of_code = false, is_exact = false;
        for (std::size_t d = 0; d < members.size(); ++d) {
            code[d] = of_code(members[d]);
            exact[d] = of_values(exact_, members[d]);
            bars[d] = of_values(bars_, members[d]);
            is_of_code = is_of_code || is_told(code[d]);
            is_exact = is_exact || is_told(exact[d]);
            if (!exact[d].empty()) apart[d] = minus(code[d], exact[d]);
            for (Numbers* values : {&code[d], &exact[d], &bars[d], &apart[d]})
                if (!is_told(*values)) values->clear();
        }
        const auto add = [&](const std::string& what, const std::array<Numbers, 3>& v,
                             double sign) {
            xml.add_vector(name + what + '_' + unit, {v[0], v[1], v[2]}, mesh_.points.size(), sign);
        };
        if (is_of_code) add("", code, -1);
        if (is_exact) add("_reference", exact, -1), add("_reference_bar", bars, 1);
        if (is_of_code && is_exact) add("_difference", apart, -1);
    }

    const MeshResult& mesh_;
    std::vector<SurfaceValues> exact_, bars_;
};

std::vector<std::array<double, 3>> positions_of(const MeshResult& mesh) {
    std::vector<std::array<double, 3>> positions;
    for (const SurfacePoint& point : mesh.points) positions.push_back({point.x, point.y, 0});
    return positions;
}

void write_faces(io::VtkXml& xml, const MeshResult& mesh) {
    const auto positions = positions_of(mesh);
    const Faces& faces = mesh.faces;
    xml.begin("Piece", {{"NumberOfPoints", std::to_string(positions.size())},
                        {"NumberOfCells", std::to_string(faces.size())}});
    xml.add_points(positions);
    const std::vector<std::int64_t> points(faces.points.begin(), faces.points.end());
    const std::vector<std::int64_t> ends(faces.offsets.begin() + 1, faces.offsets.end());
    std::vector<std::uint8_t> types;
    const bool lines = mesh.geometry != Geometry::spatial;
    for (std::size_t i = 0; i + 1 < faces.offsets.size(); ++i) {
        const auto n = static_cast<std::size_t>(faces.offsets[i + 1] - faces.offsets[i]);
        types.push_back(lines && n == 3 ? quadratic_edge : cell_type(n));
    }
    xml.begin("Cells");
    xml.add_cells(points, ends);
    xml.add_bytes("types", types, types.size());
    xml.end();
}

void write_vertices(io::VtkXml& xml, const MeshResult& mesh) {
    const auto positions = positions_of(mesh);
    const std::string n = std::to_string(positions.size());
    std::vector<std::int64_t> points(positions.size()), ends(positions.size());
    std::iota(points.begin(), points.end(), 0);
    std::iota(ends.begin(), ends.end(), 1);
    const bool is_line = mesh.geometry != Geometry::spatial && positions.size() > 1;
    xml.begin(
        "Piece",
        {{"NumberOfPoints", n}, {"NumberOfVerts", n}, {"NumberOfLines", is_line ? "1" : "0"}});
    xml.add_points(positions);
    xml.begin("Verts");
    xml.add_cells(points, ends);
    xml.end();
    if (!is_line) return;
    std::ranges::stable_sort(
        points, {}, [&](std::int64_t i) { return positions[static_cast<std::size_t>(i)][0]; });
    xml.begin("Lines");
    xml.add_cells(points, std::array{static_cast<std::int64_t>(points.size())});
    xml.end();
}

}  // namespace

io::VtkFile comparison_vtk(const Comparison& comparison, const MeshResult& mesh,
                           const io::Provenance& provenance) {
    const bool has_faces = mesh.faces.size() > 0;
    io::VtkXml xml(has_faces ? "UnstructuredGrid" : "PolyData");
    xml.begin("FieldData");
    xml.add_numbers("element_size_m", {mesh.size});
    xml.add_numbers(comparisons::quantities::contact_radius.key,
                    {comparison.reference.contact_radius});
    xml.add_texts("file", {mesh.file});
    xml.add_provenance(provenance);
    xml.end();
    has_faces ? write_faces(xml, mesh) : write_vertices(xml, mesh);
    xml.begin("PointData");
    Fields(comparison, mesh).write(xml);
    return xml.file();
}

}  // namespace tricontact::benchmarks
