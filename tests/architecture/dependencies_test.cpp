#include <filesystem>
#include <fstream>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace {

namespace fs = std::filesystem;

/// One #include of our own: the file that has it and the path it names, both from the source root.
struct Include {
  std::string from, to;
};

void addIncludes(const fs::path& root, const fs::path& file, std::vector<Include>& all) {
  const std::string from = fs::relative(file, root).generic_string();
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) {
    constexpr std::string_view kOurs = "#include <pleura/";
    if (line.starts_with("#include \""))
      all.push_back({from, fs::path(from).parent_path() / line.substr(10, line.rfind('"') - 10)});
    if (line.starts_with(kOurs))
      all.push_back({from, line.substr(kOurs.size(), line.rfind('>') - kOurs.size())});
  }
}

const std::vector<Include>& includes() {
  static const auto found = [] {
    const fs::path root = PLEURA_SOURCE_DIR;
    std::vector<Include> all;
    for (const char* folder : {"fields", "nodes", "haptics", "x3d"}) {
      if (!fs::exists(root / folder)) continue;
      for (const auto& entry : fs::recursive_directory_iterator(root / folder))
        if (const auto kind = entry.path().extension(); kind == ".h" || kind == ".cpp")
          addIncludes(root, entry.path(), all);
    }
    return all;
  }();
  return found;
}

bool isIn(const std::string& file, const std::vector<std::string>& folders) {
  for (const auto& folder : folders)
    if (file.starts_with(folder + "/")) return true;
  return false;
}

/// Every file of `folder` includes nothing of ours but from `allowed`.
void expectOnly(const std::string& folder, const std::vector<std::string>& allowed) {
  std::size_t checked = 0;
  for (const auto& [from, to] : includes()) {
    if (!isIn(from, {folder})) continue;
    ++checked;
    EXPECT_TRUE(isIn(to, allowed)) << from << " includes " << to;
  }
  EXPECT_GT(checked, 0u) << folder << " has no includes: has it moved?";
}

TEST(Architecture, FieldsKnowNothingElse) { expectOnly("fields", {"fields"}); }

TEST(Architecture, HapticsKnowNoScene) { expectOnly("haptics", {"fields", "haptics"}); }

TEST(Architecture, TheNodeModelKnowsFields) { expectOnly("nodes/core", {"fields", "nodes/core"}); }

TEST(Architecture, StandardNodesKnowNoThemeAndNoBrowser) {
  expectOnly("nodes/standard", {"fields", "nodes/core", "nodes/standard", "nodes/deformable"});
}

TEST(Architecture, KernelsKnowKernels) {
  const std::vector<std::string> kernels = {"nodes/deformable/mesh",    "nodes/deformable/chainmail",
                                            "nodes/deformable/contact", "nodes/deformable/springs",
                                            "nodes/deformable/fem",     "nodes/thorax/anatomy",
                                            "nodes/thorax/motion",      "nodes/lung/mechanics",
                                            "nodes/lung/causality",     "nodes/lung/planar",
                                            "nodes/lung/shape"};
  for (const auto& kernel : kernels)
    if (fs::exists(fs::path(PLEURA_SOURCE_DIR) / kernel)) expectOnly(kernel, kernels);
}

TEST(Architecture, NodesKnowNoFilesAndNoBrowser) { expectOnly("nodes", {"fields", "nodes", "haptics"}); }

TEST(Architecture, FilesKnowNoBrowser) {
  expectOnly("x3d/encoding", {"fields", "nodes/core", "nodes/standard", "x3d/encoding"});
  expectOnly("x3d/import", {"fields", "nodes", "x3d/import"});
}

TEST(Architecture, TheRendererKnowsNoSceneGraph) {
  expectOnly("x3d/browser/render", {"fields", "x3d/browser/render"});
}

TEST(Architecture, OnlyTheBrowserKnowsTheRenderer) {
  for (const auto& [from, to] : includes()) {
    const bool isAllowed = isIn(from, {"x3d/browser"}) || !isIn(to, {"x3d/browser/render"});
    EXPECT_TRUE(isAllowed) << from << " includes " << to;
  }
}

TEST(Architecture, NoKernelFolderIsForgotten) {
  const std::set<std::string> known = {"mesh", "chainmail", "contact", "springs", "fem"};
  for (const auto& entry : fs::directory_iterator(fs::path(PLEURA_SOURCE_DIR) / "nodes/deformable"))
    EXPECT_TRUE(!entry.is_directory() || known.contains(entry.path().filename())) << entry.path();
}

TEST(Architecture, OwnHeadersAreThere) {
  for (const auto& [from, to] : includes())
    EXPECT_TRUE(fs::exists(fs::path(PLEURA_SOURCE_DIR) / to)) << from << " includes " << to;
}

}  // namespace
