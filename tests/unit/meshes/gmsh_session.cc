#include "meshes/gmsh/gmsh_session.h"

#include <gmsh.h>
#include <gtest/gtest.h>

#include <clocale>
#include <csignal>
#include <cstdlib>
#include <stdexcept>
#include <thread>

#include "tests/unit/meshes/helpers.h"

namespace tricontact::meshes::gmsh_session_test {
namespace {

namespace fs = std::filesystem;

class MeshesSession : public MeshFolder {};

TEST_F(MeshesSession, GmshsErrorsAreExceptions) {
    const GmshSession session;
    try {
        GmshSession::call([] { gmsh::model::geo::addPlaneSurface({4711}); });
        FAIL() << "no exception";
    } catch (const std::runtime_error& error) {
        EXPECT_EQ(std::string(error.what()).rfind("gmsh: ", 0), 0U);
        EXPECT_NE(std::string(error.what()).find("4711"), std::string::npos) << error.what();
    }
    EXPECT_THROW(GmshSession::call([] { throw contact::InputError("ours"); }), contact::InputError);
}

TEST_F(MeshesSession, IsSilent) {
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    write_mesh(make_layer_mesh(small_spec()), at("a.msh"));
    read_mesh(at("a.msh"), 1);
    write("bad.msh",
          "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Nodes\n$EndNodes\n$Elements\n0 0 0 0\n"
          "$EndElements\n");
    EXPECT_NE(message_of([&] { read_mesh(at("bad.msh"), 1); }), "(accepted)");
    EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST_F(MeshesSession, LeavesNothingBehind) {
    const std::string home = std::getenv("HOME") != nullptr ? std::getenv("HOME") : "";
    ASSERT_EQ(::setenv("HOME", folder_.c_str(), 1), 0);
    const bool had_system_preferences = fs::exists("/etc/fltk");
    const std::string locale = std::setlocale(LC_ALL, nullptr);
    struct sigaction interrupt {
    }, fault{}, after{};
    ::sigaction(SIGINT, nullptr, &interrupt);
    ::sigaction(SIGSEGV, nullptr, &fault);

    { const GmshSession session; }

    ::setenv("HOME", home.c_str(), 1);
    EXPECT_TRUE(fs::is_empty(folder_)) << fs::directory_iterator(folder_)->path();
    EXPECT_EQ(fs::exists("/etc/fltk"), had_system_preferences);
    EXPECT_EQ(std::setlocale(LC_ALL, nullptr), locale);
    ::sigaction(SIGINT, nullptr, &after);
    EXPECT_EQ(after.sa_handler, interrupt.sa_handler);
    ::sigaction(SIGSEGV, nullptr, &after);
    EXPECT_EQ(after.sa_handler, fault.sa_handler);
}

TEST_F(MeshesSession, KeepsWhatWasThere) {
    const std::string home = std::getenv("HOME") != nullptr ? std::getenv("HOME") : "";
    fs::create_directories(folder_ / ".fltk/fltk.org");
    write(".fltk/fltk.org/fltk.prefs", "; FLTK preferences file format 1.0\n\n[.]\n\nmine:1\n");
    const std::string before = content(".fltk/fltk.org/fltk.prefs");
    ASSERT_EQ(::setenv("HOME", folder_.c_str(), 1), 0);
    { const GmshSession session; }
    ::setenv("HOME", home.c_str(), 1);
    EXPECT_NE(content(".fltk/fltk.org/fltk.prefs").find("mine:1"), std::string::npos);
}

TEST_F(MeshesSession, ThreadsTakeTurns) {
    const HexMesh expected = make_layer_mesh(small_spec());
    std::vector<HexMesh> meshes(4);
    {
        std::vector<std::jthread> threads;
        for (HexMesh& mesh : meshes)
            threads.emplace_back([&mesh] { mesh = make_layer_mesh(small_spec()); });
    }
    for (const HexMesh& mesh : meshes) {
        expect_same_topology(mesh, expected);
        EXPECT_EQ(mesh.nodes, expected.nodes);
    }
}

}  // namespace
}  // namespace tricontact::meshes::gmsh_session_test
