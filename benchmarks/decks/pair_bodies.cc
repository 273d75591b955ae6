#include "benchmarks/decks/pair_bodies.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>

#include "benchmarks/decks/contact_mesh.h"
#include "contact/base/error.h"

namespace tricontact::benchmarks {

namespace {

/// The elements [first, last) of both bodies' mesh, with the sets and surfaces of these names.
class BodyCut {
  public:
    BodyCut(const DeckMesh& mesh, int first, int last)
        : mesh_(mesh), first_(first), last_(last), number_(mesh.nodes.size(), -1) {
        for (int e = first; e < last; ++e) {
            std::vector<int>& element = body_.elements.emplace_back();
            for (const int node : mesh.elements[e]) {
                if (number_[node] < 0) {
                    number_[node] = static_cast<int>(body_.nodes.size());
                    body_.nodes.push_back(mesh.nodes[node]);
                }
                element.push_back(number_[node]);
            }
        }
    }

    BodyMesh cut(const char* held, const char* surface) {
        body_.held = nodes_of(held);
        body_.axis = nodes_of("NAXIS");
        body_.contact = edges_of(surface);
        body_.loaded = edges_of("SLOAD");
        return std::move(body_);
    }

  private:
    std::vector<int> nodes_of(const char* set) const {
        std::vector<int> nodes;
        if (const auto found = mesh_.node_sets.find(set); found != mesh_.node_sets.end())
            for (const int node : found->second)
                if (number_[node] >= 0) nodes.push_back(number_[node]);
        return nodes;
    }
    std::vector<std::vector<int>> edges_of(const char* surface) const {
        std::vector<std::vector<int>> edges;
        const auto found = mesh_.surfaces.find(surface);
        if (found == mesh_.surfaces.end()) return edges;
        for (const ElementFace& face : found->second) {
            if (face.element < first_ || face.element >= last_) continue;
            std::vector<int>& edge = edges.emplace_back(mesh_.face_nodes(face));
            for (int& node : edge) node = number_[node];
        }
        return edges;
    }

    const DeckMesh& mesh_;
    int first_, last_;
    std::vector<int> number_;
    BodyMesh body_;
};

std::vector<char> flags_of_nodes(const BodyMesh& body, const std::vector<int>& nodes) {
    std::vector<char> flags(body.nodes.size(), 0);
    for (const int node : nodes) flags[node] = 1;
    return flags;
}

using NodePair = std::pair<int, int>;
NodePair sorted_pair(int a, int b) {
    return {std::min(a, b), std::max(a, b)};
}

constexpr int held_label = 1, contact_label = 3, axis_label = 4, loaded_label = 5, free_label = 9;

/// Labels of the edges of the boundary, which belong to one element each.
std::map<NodePair, int> boundary_labels(const BodyMesh& body) {
    std::map<NodePair, int> labels;
    for (const auto& element : body.elements)
        for (int k = 0; k < 4; ++k) {
            const auto edge = sorted_pair(element[k], element[(k + 1) % 4]);
            if (const auto found = labels.find(edge); found != labels.end())
                labels.erase(found);
            else
                labels[edge] = free_label;
        }
    const std::vector<char> held = flags_of_nodes(body, body.held),
                            axis = flags_of_nodes(body, body.axis);
    for (auto& [edge, label] : labels) {
        const auto [a, b] = edge;
        if (held[a] && held[b])
            label = held_label;
        else if ((held[a] || axis[a]) && (held[b] || axis[b]))
            label = axis_label;
    }
    for (const auto& edge : body.loaded) labels[sorted_pair(edge[0], edge[1])] = loaded_label;
    for (const auto& edge : body.contact) labels[sorted_pair(edge[0], edge[1])] = contact_label;
    return labels;
}

}  // namespace

BodyPair body_pair(const DeckModel& model, int n, int level, bool is_quadratic) {
    const DeckMesh mesh = bodies_of(model, n, level, is_quadratic);
    volume_of(mesh, 0, mesh.n_elements());
    return {BodyCut(mesh, 0, mesh.n_body_elements).cut("NBASE", "SLAYER"),
            BodyCut(mesh, mesh.n_body_elements, mesh.n_elements()).cut("NIND", "SIND")};
}

std::vector<double> pressure_points(const DeckModel& model, const BodyMesh& lower) {
    std::vector<double> points;
    const double radius = model.conforming_radius;
    for (const auto& edge : lower.contact)
        for (const int node : {edge[0], edge[1]}) {
            const DeckMesh::Point& p = lower.nodes[node];
            points.push_back(radius > 0 ? radius * std::atan2(p[0], -p[1]) : p[0]);
        }
    std::ranges::sort(points);
    const auto ends = std::ranges::unique(
        points, [&](double a, double b) { return std::abs(a - b) < 1e-9 * model.a; });
    points.erase(ends.begin(), ends.end());
    return points;
}

std::string freefem_mesh(const BodyMesh& body) {
    const std::map<NodePair, int> labels = boundary_labels(body);
    std::string text =
        fmt::format("{} {} {}\n", body.nodes.size(), 2 * body.elements.size(), labels.size());
    const auto out = std::back_inserter(text);
    for (const DeckMesh::Point& p : body.nodes)
        fmt::format_to(out, "{:.15g} {:.15g} 0\n", p[0], p[1]);
    for (const auto& e : body.elements)
        fmt::format_to(out, "{} {} {} 0\n{} {} {} 0\n", e[0] + 1, e[1] + 1, e[2] + 1, e[0] + 1,
                       e[2] + 1, e[3] + 1);
    for (const auto& [edge, label] : labels)
        fmt::format_to(out, "{} {} {}\n", edge.first + 1, edge.second + 1, label);
    return text;
}

std::string plain_mesh(const BodyMesh& body) {
    std::string text = fmt::format("nodes {}\n", body.nodes.size());
    const auto out = std::back_inserter(text);
    for (const DeckMesh::Point& p : body.nodes)
        fmt::format_to(out, "{:.15g} {:.15g}\n", p[0], p[1]);
    const auto write_rows = [&](const char* name, const std::vector<std::vector<int>>& rows) {
        fmt::format_to(out, "{} {}\n", name, rows.size());
        for (const auto& row : rows) fmt::format_to(out, "{}\n", fmt::join(row, " "));
    };
    write_rows("elements", body.elements);
    write_rows("contact", body.contact);
    write_rows("loaded", body.loaded);
    const auto one_a_row = [](const std::vector<int>& nodes) {
        std::vector<std::vector<int>> rows;
        for (const int node : nodes) rows.push_back({node});
        return rows;
    };
    write_rows("held", one_a_row(body.held));
    write_rows("axis", one_a_row(body.axis));
    return text;
}

std::vector<TemplateValue> pair_values(const DeckModel& model, const BodyPair& pair,
                                       const DeckRun& run, const DeckFamily& family,
                                       const std::string& job, std::vector<TemplateValue> own) {
    const bool is_plane = model.shape == DeckModel::Shape::plane;
    const double share = model.last().is_force ? model.share() : 1;
    own.insert(own.end(), {{"name", model.name},
                           {"n", std::to_string(run.n)},
                           {"a", number(model.a)},
                           {"job", job},
                           {"points", number_list(pressure_points(model, pair.lower))},
                           {"gap", model.gap},
                           {"target", number(model.last().normal * share)},
                           {"share", is_plane ? "2*" : ""},
                           {"code", family.code},
                           {"element", family.elements},
                           {"force_unit", is_plane ? "N/mm" : "N"},
                           {"size", number(run.size)},
                           {"column", is_plane ? "x" : "r"}});
    return own;
}

void check_pair_deck(const DeckModel& model, const char* code) {
    if (model.mu > 0 || model.is_shifted() || model.steps.size() > 1)
        throw contact::InputError(std::string("deck: two bodies of a deck for ") + code +
                                  " are pressed once without friction; take calculix");
}

}  // namespace tricontact::benchmarks
