// Each bad file is a good one with one defect.

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <array>
#include <random>

#include "tests/unit/meshes/helpers.h"

namespace tricontact::meshes::bad_files_test {
namespace {

namespace fs = std::filesystem;

class MeshesBadFile : public MeshFolder {
  protected:
    void SetUp() override {
        MeshFolder::SetUp();
        LayerMeshSpec spec = small_spec();
        spec.lower_thickness = 0;
        write_mesh(make_layer_mesh(spec), at("good.msh"));
        good_ = content("good.msh");
    }
    void refused(const std::string& path, const std::string& text) const {
        expect_refusal(message_of([&] { read_mesh(path, 1); }), path, text);
    }
    void refused_text(const std::string& bytes, const std::string& text) const {
        EXPECT_NE(bytes, good_) << "is not bad";
        refused(write("bad.msh", bytes), text);
    }
    std::string replaced(const std::string& what, const std::string& by) const {
        std::string bytes = good_;
        const std::size_t start = bytes.find(what);
        EXPECT_NE(start, std::string::npos) << what;
        return bytes.replace(start, what.size(), by);
    }
    // The line after the n-th line break behind the marker, and its end.
    std::pair<std::size_t, std::size_t> line(const std::string& marker, int n) const {
        std::size_t begin = good_.find(marker);
        for (int i = 0; i < n; ++i) begin = good_.find('\n', begin) + 1;
        return {begin, good_.find('\n', begin)};
    }
    // A mesh from a script for gmsh, which saves what has a physical name.
    std::string meshed(const std::string& script) const {
        convert(write("bad.geo", script), at("bad.msh"), 4.1, false);
        return at("bad.msh");
    }

    std::string good_;
};

TEST_F(MeshesBadFile, DiffersFromAGoodOne) {
    EXPECT_NO_THROW(read_mesh(at("good.msh"), 1));
}

TEST_F(MeshesBadFile, NoFile) {
    refused(at("missing.msh"), "cannot be read (No such file or directory); check the path");
    refused(at("good.msh/x.msh"), "cannot be read (Not a directory)");
    fs::create_directory(at("folder.msh"));
    refused(at("folder.msh"), "is a directory; name a mesh file inside it");
    ASSERT_EQ(::mkfifo(at("pipe.msh").c_str(), 0600), 0);
    refused(at("pipe.msh"), "is not a regular file");
    if (::geteuid() == 0) return;  // may read everything
    fs::permissions(at("good.msh"), fs::perms::none);
    refused(at("good.msh"), "(Permission denied); give yourself the permission to read it");
}

TEST_F(MeshesBadFile, NoMesh) {
    refused_text("", "is empty; save the mesh again");
    refused_text("hello\n", "is no gmsh mesh: it does not begin with $MeshFormat");
    refused_text(replaced("4.1 0 8", "9.1 0 8"),
                 "is a gmsh mesh of version \"9.1\"; save it as version 4.1");
    refused_text("$MeshFormat", "is a gmsh mesh of version \"\"");
}

// gmsh runs any text as a script, and one beside a mesh that has its name and .opt; no mesh goes
// through it.
TEST_F(MeshesBadFile, ScriptsAreNotRun) {
    const std::string script = "Printf(\"run\") > \"" + at("proof") + "\";\n";
    refused_text(script, "is no gmsh mesh");
    refused(write("script.geo", script), "is no gmsh mesh");
    EXPECT_NO_THROW(read_mesh(write("mesh.geo", good_), 1)) << "the name does not matter";
    write("good.msh.opt", script);
    EXPECT_NO_THROW(read_mesh(at("good.msh"), 1));
    EXPECT_FALSE(fs::exists(at("proof")));
    convert(at("good.msh"), at("converted.msh"), 4.1, false);
    EXPECT_TRUE(fs::exists(at("proof"))) << "the script is none";
}

TEST_F(MeshesBadFile, CutOffAnywhere) {
    const std::size_t end = good_.find("$EndElements");
    for (std::size_t length = 30; length < end; length += end / 37)
        refused_text(good_.substr(0, length), "is cut off");
    std::string hole = good_;
    hole.erase(line("$Elements", 6).first, 200);
    refused_text(hole, "; save or copy the mesh again");
}

TEST_F(MeshesBadFile, NumbersOutOfRange) {
    refused_text(replaced("2 1 \"contact\"", "7 1 \"contact\""),
                 "line 6: a physical name of dimension 7, not 0 to 3; save or copy");
    const auto [begin, end] = line("$Elements", 5);
    for (const auto& [tag, text] :
         {std::pair("-7", "a node of an element is \"-7\", which is no number or none that it may"),
          {"x", "a node of an element is \"x\", which is no number"},
          {"99999", "node 99999 of element 3 is not among its nodes"},
          {"3000000000", "node 3000000000 of element 3 is not among its nodes"},
          {"99999999999", "node 99999999999 of element 3 is not among its nodes"}}) {
        std::string bytes = good_;
        const std::size_t last = bytes.find_last_of(' ', end - 2) + 1;
        refused_text(bytes.replace(last, bytes.find_first_of(" \n", last) - last, tag), text);
    }
    std::string bytes = good_;
    const std::size_t x = bytes.find("\n0.0", bytes.find("$Nodes")) + 1;
    refused_text(bytes.replace(x, bytes.find(' ', x) - x, "nan"), " is at (nan, ");
}

TEST_F(MeshesBadFile, BinaryNumbersOutOfRange) {
    convert(at("good.msh"), at("binary.msh"), 4.1, true);
    std::string bytes = content("binary.msh");
    // least but four byte of the last node of the last element, before a line break
    bytes[bytes.find("$EndElements") - 5] = 1;
    refused_text(bytes, "is not among its nodes");
    bytes = content("binary.msh");
    std::swap(bytes[bytes.find("8\n") + 2], bytes[bytes.find("8\n") + 5]);  // of the number 1
    refused_text(bytes, "has the bytes of its numbers in another order than this machine");
    bytes = content("binary.msh");
    bytes[bytes.find("$Nodes\n") + 7 + 8] += 1;  // of the total
    refused_text(bytes, " nodes where the section announces ");
}

TEST_F(MeshesBadFile, OldVersionsNumbersOutOfRange) {
    convert(at("good.msh"), at("old.msh"), 2.2, false);
    const std::string old = content("old.msh");
    EXPECT_NO_THROW(read_mesh(at("old.msh"), 1));
    const std::size_t row = old.find('\n', old.find("$Elements\n") + 10) + 1;
    const std::size_t type = old.find(" 3 2 ", row);
    for (const auto& [other, text] :
         {std::pair(" 30 2 ", "elements of gmsh's type 30, not of first or second order"),
          {" 3 40 ", "belongs to a partition; save the mesh in one piece"},
          {" 3 -2 ", "-2 tags of an element"},
          {" 0 2 ", "elements of gmsh's type 0"},
          {" 3 3 1 ", "belongs to a partition"},
          {" 3 x ", "the number of an element's tags is \"x\""}}) {
        std::string bytes = old;
        refused_text(bytes.replace(type, 5, other), text);
    }
    convert(at("good.msh"), at("old.msh"), 2.2, true);
    std::string bytes = content("old.msh");
    // type, number of elements, number of tags: 32-bit numbers
    const std::size_t block = bytes.find('\n', bytes.find("$Elements\n") + 10) + 1;
    const std::array texts{"elements of gmsh's type ", "elements where ", "; "};
    for (const std::size_t number : {0, 1, 2}) {
        std::string changed = bytes;
        changed[block + 4 * number + 1] = '\x7f';
        refused_text(changed, texts[number]);
    }
}

// Each corrupted the memory of gmsh 4.8, which believes what a file says of itself.
TEST_F(MeshesBadFile, CountsThatAreNotThoseOfWhatFollows) {
    for (const char* section : {"$Nodes", "$Elements"}) {
        const auto [begin, end] = line(section, 1);
        std::istringstream numbers(good_.substr(begin, end - begin));
        std::size_t n_blocks = 0, total = 0;
        numbers >> n_blocks >> total;
        const std::string head = std::to_string(n_blocks) + ' ' + std::to_string(total);
        ASSERT_TRUE(good_.substr(begin).starts_with(head));
        for (const long off : {-1, 1})
            refused_text(std::string(good_).replace(
                             begin, head.size(),
                             std::to_string(n_blocks) + ' ' + std::to_string(long(total) + off)),
                         " where the section announces ");
        refused_text(std::string(good_).replace(begin, head.size(),
                                                std::to_string(n_blocks) + " 18446744073709551615"),
                     "of which the file holds fewer");
        refused_text(
            std::string(good_).replace(begin, head.size(),
                                       std::to_string(n_blocks - 1) + ' ' + std::to_string(total)),
            "; save or copy the mesh again");
    }
    convert(at("good.msh"), at("old.msh"), 2.2, false);
    good_ = content("old.msh");
    const auto [begin, end] = line("$Nodes", 3);
    refused_text(std::string(good_).erase(begin, end + 1 - begin),
                 "the number of a node is missing");
    const auto [first, last] = line("$Nodes", 2);
    refused_text(std::string(good_).insert(first, good_.substr(first, last + 1 - first)),
                 "more follows than the nodes that are announced");
    const auto [node, after] = line("$Nodes", 4);
    const std::string twice = good_.substr(first, last + 1 - first);
    refused_text(std::string(good_).replace(node, after + 1 - node, twice), "has node 1 twice");
}

TEST_F(MeshesBadFile, SectionsTwiceOrInComments) {
    for (const char* dimension : {"99", "-1", "2"})
        refused_text(good_ + "$PhysicalNames\n1\n" + dimension + " 1 \"base\"\n$EndPhysicalNames\n",
                     "has two sections $PhysicalNames; save the mesh again");
    const std::string comments =
        "$Comments\n$Nodes\n1 5 1 5\n$EndNodes\n$PhysicalNames\n1\n99 1 \"x\"\n"
        "$EndPhysicalNames\n$EndComments\n";
    const HexMesh good = read_mesh(at("good.msh"), 1);
    for (const char* before : {"$PhysicalNames", "$Nodes", "$Elements"}) {
        const HexMesh again =
            read_mesh(write("commented.msh", replaced(before, comments + before)), 1);
        expect_same_topology(again, good);
        EXPECT_EQ(again.nodes, good.nodes);
    }
    refused_text(good_ + "and more\n", "text that belongs to no section");
    refused_text(good_ + "$PartitionedEntities\n$EndPartitionedEntities\n",
                 "is a partitioned mesh");
}

// Bytes changed, numbers replaced, pieces cut out: an error, or a mesh that passes as sound (an
// inner node moved a little); never a crash or another exception.
TEST_F(MeshesBadFile, RandomDamage) {
    for (const double version : {2.2, 4.1})
        for (const bool binary : {false, true}) {
            convert(at("good.msh"), at("whole.msh"), version, binary);
            const std::string whole = content("whole.msh");
            std::mt19937 random(20261121);
            int n_refused = 0;
            for (int i = 0; i < 60; ++i) {
                std::string bytes = whole;
                const std::size_t place = random() % bytes.size();
                if (i % 3 == 0) bytes[place] = static_cast<char>(random());
                if (i % 3 == 1)
                    bytes.replace(std::min(bytes.find_first_of("0123456789", place), place), 1,
                                  std::to_string(random()));
                if (i % 3 == 2) bytes.erase(place, random() % 40);
                const std::string path = write("damaged.msh", bytes);
                const std::string message = message_of([&] { read_mesh(path, 1); });
                if (message == "(accepted)") continue;
                ++n_refused;
                expect_refusal(message, path, "");
            }
            EXPECT_GT(n_refused, 20) << version << binary;
        }
}

TEST_F(MeshesBadFile, Names) {
    refused_text(replaced("\"contact\"", "\"contakt\""),
                 "unknown name \"contakt\" of a physical surface; the names are contact, free_top, "
                 "base, sides, symmetry");
    refused_text(replaced("\"layer\"", "\"rubber\""),
                 "unknown name \"rubber\" of a physical volume; the names are layer, lower_layer");
    refused_text(replaced("\"base\"", "\"" + std::string(60, 'b') + "\""),
                 "unknown name \"" + std::string(40, 'b') + "...\"");
    refused_text(replaced("\"contact\"", "\"free_top\""), "has no surface \"contact\"; make a");
    refused_text(replaced("\"base\"", "\"sides\""), "has no surface \"base\"; make a physical");
    refused_text(replaced("\"layer\"", "\"lower_layer\""), "has no volume \"layer\"; make a");
}

TEST_F(MeshesBadFile, EntitiesWithoutANameOrWithTwo) {
    LayerMeshSpec spec = small_spec();
    spec.lower_thickness = 0;
    const std::string script = layer_geometry(spec);
    auto without = [&](const std::string& text, const std::string& by = "") {
        std::string changed = script;
        const std::size_t start = changed.find(text);
        EXPECT_NE(start, std::string::npos) << text;
        return changed.replace(start, text.size(), by);
    };
    refused(meshed(without("Physical Surface(\"sides\", 4) = sides[];")), "has no name; put it");
    refused(meshed(without("Physical Volume(\"layer\", 1) = layer[];")), "holds no hexahedra");
    refused(meshed(without("Physical Volume(\"layer\", 1) = layer[];", "Mesh.SaveAll = 1;")),
            "belong to no physical volume; name it: layer, lower_layer");
    refused(meshed(script + "Physical Surface(\"sides\", 4) += contact[];"),
            "is named twice: contact and sides; put it into one physical group only");
    refused(meshed(script + "Physical Volume(7) = {layer[0]};"),
            "unknown name \"\" of a physical volume");
    refused(meshed(script + "Physical Surface(\"base\", 3) += {2};"), "lies inside the body");
}

TEST_F(MeshesBadFile, OtherElements) {
    const std::string box = "SetFactory(\"OpenCASCADE\"); Box(1) = {-1, -1, -2, 2, 2, 2};\n";
    const std::string names = "Physical Volume(\"layer\") = {1};\n";
    refused(meshed(box + names),  // those of 10 nodes are divided
            "elements of type \"Tetrahedron 4\"; use straight hexahedra with 8 nodes");
    LayerMeshSpec spec = small_spec();
    refused(meshed(layer_geometry(spec) + "Mesh.ElementOrder = 2;\n"),
            "elements of type \"Hexahedron 27\"");
    refused(
        meshed(layer_geometry(spec) + "Mesh.ElementOrder = 2; Mesh.SecondOrderIncomplete = 1;\n"),
        "elements of type \"Hexahedron 20\"");
    refused(meshed(layer_geometry(spec) + "Mesh.ElementOrder = 3;\n"),
            "not of first or second order; use straight hexahedra");
    // triangles on hexahedra
    std::string bytes = good_;
    const auto [begin, end] = line("$Elements", 2);
    ASSERT_EQ(bytes.substr(begin, end - begin), "2 1 3 24");
    bytes.replace(begin, end - begin, "2 1 2 24");
    for (std::size_t at = end, i = 0; i < 24; ++i) {
        at = bytes.find('\n', at + 1);
        const std::size_t last = bytes.find_last_of(' ', at - 2);
        bytes.erase(last, at - last);
        at = last;
    }
    refused_text(bytes, "surface 1 holds 24 elements of type \"Triangle 3\"");
}

TEST_F(MeshesBadFile, InvertedElement) {
    const auto [begin, end] = line("$Elements", 0);
    const std::size_t block = good_.find("\n3 1 5 ", begin);
    const std::size_t first = good_.find('\n', block + 1) + 1;
    std::istringstream row(good_.substr(first, good_.find('\n', first) - first));
    std::array<int, 9> n{};
    for (int& number : n) row >> number;
    std::ostringstream turned;
    for (const int k : {0, 4, 3, 2, 1, 8, 7, 6, 5}) turned << n[k] << ' ';
    std::string bytes = good_;
    bytes.replace(first, good_.find('\n', first) - first, turned.str());
    refused_text(bytes, "hexahedron 1 of ");
    refused_text(bytes, "is inverted or flat: its Jacobian falls to -");
}

}  // namespace
}  // namespace tricontact::meshes::bad_files_test
