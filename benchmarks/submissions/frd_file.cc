#include "benchmarks/submissions/frd_file.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <span>
#include <unordered_map>

#include "benchmarks/submissions/fixed_columns.h"
#include "benchmarks/submissions/mesh_cells.h"
#include "benchmarks/submissions/plane_slice.h"
#include "io/keys/messages.h"

namespace tricontact::benchmarks {

namespace {

/// Results of all nodes of one kind at one time.
struct FrdBlock {
    std::string name, time;  ///< "DISP", the value and number of its state
    std::vector<std::string> components;
    std::vector<int> nodes;
    std::vector<double> values;
};

struct FrdElement {
    int type = 0, material = 0;
    std::vector<int> nodes;
};

/// Number of nodes, VTK's type, and VTK's order by that of the file (CalculiX cgx manual, "Element
/// types"): middle nodes of upright edges come before those of the top.
struct FrdType {
    std::size_t n_nodes;
    std::uint8_t vtk;
    std::vector<int> order = {};
};
const std::map<int, FrdType>& frd_types() {
    static const std::map<int, FrdType> types{
        {1, {8, 12}},
        {2, {6, 13}},
        {3, {4, 10}},
        {4, {20, 25, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 16, 17, 18, 19, 12, 13, 14, 15}}},
        {5, {15, 26, {0, 1, 2, 3, 4, 5, 6, 7, 8, 12, 13, 14, 9, 10, 11}}},
        {6, {10, 24}},
        {7, {3, 5}},
        {8, {6, 22}},
        {9, {4, 9}},
        {10, {8, 23}},
        {11, {2, 3}},
        {12, {3, 21}}};
    return types;
}

class FrdParser {
  public:
    FrdParser(std::string_view text, const std::string& name) : lines_(text), name_(name) {}

    FrdFile parse() {
        bool is_frd = false;
        while (lines_.next()) {
            const std::string_view line = lines_.line();
            const std::string_view key = line.substr(0, std::min<std::size_t>(6, line.size()));
            if (key == "    1C" || key == "    1U" || key == "    1P") {
                is_frd = true;
                if (line.starts_with("    1UMAT")) read_material(line);
            } else if (key == "    2C") {
                read_nodes();
            } else if (key == "    3C") {
                read_elements();
            } else if (line.starts_with("  100C")) {
                read_results();
            } else if (line.starts_with(" 9999")) {
                break;
            }
            if (!is_frd && lines_.number() > 20) break;
        }
        if (!is_frd || points_.empty())
            io::fail(name_, "", "is no result file of CalculiX: it has no block of nodes (2C)",
                     "name the .frd file of a run that ended");
        return assembled();
    }

  private:
    [[noreturn]] void refuse(const std::string& rule, const std::string& remedy) const {
        io::fail(name_ + ':' + std::to_string(lines_.number()), "", rule, remedy);
    }

    /// Width of node numbers by the last number of a block's heading.
    std::size_t width_of_format(std::string_view line) const {
        const auto format = whole_number(line, line.find_last_of(' ') + 1, 10);
        if (format && *format > 1)
            refuse("the results are binary",
                   "write *NODE FILE, *EL FILE, *CONTACT FILE instead of *NODE OUTPUT ...");
        return format && *format == 0 ? 5 : 10;
    }

    std::string_view heading() const {
        const std::string_view line = lines_.line();
        return line.substr(0, line.find_last_not_of(" \t") + 1);
    }

    bool next_of_block() {
        if (!lines_.next()) refuse("the file ends within a block", "repeat the run");
        return !lines_.line().starts_with(" -3");
    }

    void read_material(std::string_view line) {
        const auto number = whole_number(line, 9, 5);
        if (number && line.size() > 14)
            materials_[*number] = std::string(io::trimmed(line.substr(14)));
    }

    void read_nodes() {
        const std::size_t width = width_of_format(heading());
        while (next_of_block()) {
            const auto number = whole_number(lines_.line(), 3, width);
            const auto at = numbers_of_twelve(lines_.line(), 3 + width, 3);
            if (!number || at.size() < 3 || !std::isfinite(at[0] + at[1] + at[2]))
                refuse("a node needs its number and three finite coordinates", "repeat the run");
            if (!index_.emplace(*number, points_.size()).second)
                refuse("node " + std::to_string(*number) + " stands twice", "repeat the run");
            points_.push_back({at[0], at[1], at[2]});
        }
    }

    void read_elements() {
        const std::size_t width = width_of_format(heading());
        while (next_of_block()) {
            const std::string_view line = lines_.line();
            if (line.starts_with(" -1")) {
                elements_.push_back({whole_number(line, 3 + width, 5).value_or(0),
                                     whole_number(line, 13 + width, 5).value_or(0),
                                     {}});
            } else if (line.starts_with(" -2") && !elements_.empty()) {
                for (std::size_t at = 3; at < line.size(); at += width) {
                    const auto node = whole_number(line, at, width);
                    if (!node) {
                        if (io::trimmed(line.substr(at)).empty()) break;
                        refuse("a node's number is due", "repeat the run");
                    }
                    elements_.back().nodes.push_back(*node);
                }
            } else {
                refuse("an element's line begins with -1 or -2", "repeat the run");
            }
        }
    }

    /// "  100CL  102 1.000000000         387                     0    2           1".
    void read_results() {
        const std::string_view line = heading();
        FrdBlock block;
        block.time = std::string(line.substr(std::min<std::size_t>(12, line.size()), 12)) + ' ' +
                     std::to_string(whole_number(line, 58, 5).value_or(0));
        const std::size_t width = width_of_format(line);
        while (next_of_block()) {
            const std::string_view row = lines_.line();
            if (row.starts_with(" -4")) {
                block.name = io::trimmed(row.substr(std::min<std::size_t>(5, row.size()), 8));
            } else if (row.starts_with(" -5")) {
                const bool is_computed = whole_number(row, 33, 5).value_or(0) != 0;
                if (!is_computed)
                    block.components.emplace_back(
                        io::trimmed(row.substr(std::min<std::size_t>(5, row.size()), 8)));
            } else if (row.starts_with(" -1") || row.starts_with(" -2")) {
                read_values(row, width, block);
            } else {
                refuse("a line of results begins with -1 to -5", "repeat the run");
            }
        }
        if (!block.name.empty()) keep(std::move(block));
    }

    void read_values(std::string_view row, std::size_t width, FrdBlock& block) const {
        const std::size_t n = block.components.size();
        const std::size_t left = n - (row.starts_with(" -2") ? block.values.size() % n : 0);
        if (row.starts_with(" -1")) {
            const auto node = whole_number(row, 3, width);
            if (!node || n == 0 || block.values.size() != n * block.nodes.size())
                refuse("a node's number is due", "repeat the run");
            block.nodes.push_back(*node);
        }
        const auto values = numbers_of_twelve(row, 3 + width, std::min<std::size_t>(left, 6));
        if (values.size() < std::min<std::size_t>(left, 6))
            refuse(block.name + " has fewer numbers than its components", "repeat the run");
        for (const double value : values)
            if (!std::isfinite(value))
                refuse(block.name + " is not a finite number", "repeat the run");
        block.values.insert(block.values.end(), values.begin(), values.end());
    }

    /// The last of each name.
    void keep(FrdBlock block) {
        if (block.values.size() != block.nodes.size() * block.components.size())
            refuse(block.name + " has fewer numbers than its components", "repeat the run");
        last_time_ = block.time;
        const std::string name = block.name;
        blocks_.insert_or_assign(name, std::move(block));
    }

    /// Values at all nodes, zero where the block has none.
    MeshArray array_of(const FrdBlock& block, const std::string& name, std::size_t first,
                       std::size_t n, FrdFile& file) const {
        MeshArray array{name, static_cast<int>(n), std::vector<double>(n * points_.size()), {}};
        for (std::size_t k = 0; k < n; ++k) array.headings.push_back(block.components[first + k]);
        std::size_t n_lost = 0;
        for (std::size_t i = 0; i < block.nodes.size(); ++i) {
            const auto found = index_.find(block.nodes[i]);
            if (found == index_.end()) {
                ++n_lost;
                continue;
            }
            for (std::size_t k = 0; k < n; ++k)
                array.values[found->second * n + k] =
                    block.values[i * block.components.size() + first + k];
        }
        if (n_lost > 0)
            file.notes.push_back(array.headings[0] + ": values at " + std::to_string(n_lost) +
                                 " nodes whose coordinates the file does not have are not used; "
                                 "write *NODE FILE, OUTPUT=3D");
        return array;
    }

    std::vector<MeshArray> arrays(FrdFile& file) const {
        std::vector<MeshArray> all;
        std::vector<std::string> unused;
        for (const auto& [name, block] : blocks_) {
            const std::size_t n = block.components.size();
            if (block.time != last_time_) {
                file.notes.push_back(name + " is not used: the last state does not have it");
            } else if (name == "DISP" && n >= 3) {
                all.push_back(array_of(block, "u", 0, 3, file));
            } else if (name == "STRESS" && n >= 6) {
                all.push_back(array_of(block, "stress", 0, 6, file));
            } else if (name == "CONTACT") {
                for (std::size_t k = 0; k < n; ++k)
                    all.push_back(array_of(block, block.components[k], k, 1, file));
            } else {
                unused.push_back(name);
            }
        }
        if (!unused.empty()) file.notes.push_back("results not used: " + io::joined(unused));
        return all;
    }

    MeshData mesh_of(int material, const std::vector<MeshArray>& arrays) const {
        MeshData mesh;
        const auto named = materials_.find(material);
        mesh.name =
            named == materials_.end() ? "material " + std::to_string(material) : named->second;
        mesh.points = points_;
        mesh.point_arrays = arrays;
        for (const FrdElement& element : elements_) {
            if (element.material != material) continue;
            const auto type = frd_types().find(element.type);
            if (type == frd_types().end() || element.nodes.size() != type->second.n_nodes)
                io::fail(name_, "",
                         "an element of type " + std::to_string(element.type) + " has " +
                             std::to_string(element.nodes.size()) + " nodes",
                         "read are types 1 to 12 of CalculiX");
            for (std::size_t k = 0; k < element.nodes.size(); ++k) {
                const std::size_t from = type->second.order.empty()
                                             ? k
                                             : static_cast<std::size_t>(type->second.order[k]);
                const auto node = index_.find(element.nodes[from]);
                if (node == index_.end())
                    io::fail(name_, "",
                             "an element has the node " + std::to_string(element.nodes[from]) +
                                 ", whose coordinates are missing",
                             "repeat the run");
                mesh.connectivity.push_back(static_cast<int>(node->second));
            }
            mesh.types.push_back(type->second.vtk);
            mesh.offsets.push_back(static_cast<std::int64_t>(mesh.connectivity.size()));
        }
        keep_used_points(mesh);
        return mesh;
    }

    FrdFile assembled() const {
        FrdFile file;
        const std::vector<MeshArray> all = arrays(file);
        std::vector<int> materials;
        for (const FrdElement& element : elements_)
            if (std::ranges::count(materials, element.material) == 0)
                materials.push_back(element.material);
        if (materials.empty())
            io::fail(name_, "", "has no elements (3C)", "name the .frd file of a run that ended");
        if (materials.size() > 1000)
            io::fail(name_, "", "has more than 1000 materials", "repeat the run");
        for (const int material : materials) file.meshes.push_back(mesh_of(material, all));
        const bool is_wedge = is_wedge_of_two_degrees(file.meshes);
        for (MeshData& mesh : file.meshes) {
            if (is_wedge)
                mesh = collapsed_wedge(mesh);
            else if (const auto plane = collapsed_slice(mesh))
                mesh = *plane;
            flatten(mesh);
        }
        if (is_wedge)
            file.notes.emplace_back(
                "the wedge of two degrees of an axisymmetric model: its face "
                "at +1 degree");
        return file;
    }

    LineReader lines_;
    std::string name_, last_time_;
    std::map<int, std::string> materials_;
    std::unordered_map<int, std::size_t> index_;  // of points by the numbers of nodes
    std::vector<std::array<double, 3>> points_;
    std::vector<FrdElement> elements_;
    std::map<std::string, FrdBlock> blocks_;
};

}  // namespace

FrdFile parse_frd(std::string_view text, const std::string& name) {
    return FrdParser(text, name).parse();
}

}  // namespace tricontact::benchmarks
