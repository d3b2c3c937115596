#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>

#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <libxml/parser.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <pleura/nodes/built_in_nodes.h>
#include <pleura/x3d/browser/scene/scene.h>
#include <pleura/x3d/encoding/source_text.h>

namespace pleura {
namespace {

/// A wavy sheet of 316 x 316 squares: 199,712 triangles, 6.4 MB of X3D, in lines as exporters write them.
const std::string& largeScene() {
  static const std::string text = [] {
    constexpr int kSide = 316;
    std::string out = "<X3D version='4.0'><Scene><Shape><IndexedTriangleSet index='";
    for (int y = 0; y < kSide; ++y)
      for (int x = 0; x < kSide; ++x) {
        const int a = y * (kSide + 1) + x, b = a + 1, c = a + kSide + 1, d = c + 1;
        out += fmt::format("{} {} {} {} {} {}\n", a, b, d, a, d, c);
      }
    out += "'><Coordinate point='";
    for (int y = 0; y <= kSide; ++y)
      for (int x = 0; x <= kSide; ++x)
        out += fmt::format("{:.6f} {:.6f} {:.6f},\n", x * 0.001, y * 0.001,
                           0.01 * std::sin(0.1 * x) * std::cos(0.1 * y));
    return out + "'/></IndexedTriangleSet></Shape></Scene></X3D>\n";
  }();
  return text;
}

void pleuraReader(benchmark::State& state) {
  const SourceText source("large.x3d", largeScene());
  for (auto _ : state) {
    Scene scene;
    NodeRegistry registry;
    registerBuiltInNodes(registry);
    PluginLoader plugins;
    Diagnostics diagnostics;
    const auto document = Reader(registry, plugins, scene, diagnostics).readText(source, ".");
    if (diagnostics.errors() > 0 || document.nodes.size() != 1) state.SkipWithError("not read");
  }
  state.counters["MB"] = static_cast<double>(largeScene().size()) / 1e6;
}
BENCHMARK(pleuraReader)->Unit(benchmark::kMillisecond);

/// The floor: libxml2 parses, nobody listens.
void libxml2Alone(benchmark::State& state) {
  xmlSAXHandler silent{};
  silent.initialized = XML_SAX2_MAGIC;
  silent.startElementNs = [](void*, const xmlChar*, const xmlChar*, const xmlChar*, int, const xmlChar**, int,
                             int, const xmlChar**) {};
  for (auto _ : state)
    if (xmlSAXUserParseMemory(&silent, nullptr, largeScene().data(), static_cast<int>(largeScene().size())) <
        0)
      state.SkipWithError("not read");
}
BENCHMARK(libxml2Alone)->Unit(benchmark::kMillisecond);

/// `pleura check` on the same scene as a file: the whole process, and the most memory that it held at once.
void checkCommand(benchmark::State& state) {
  const auto file = std::filesystem::temp_directory_path() / "pleura_load_benchmark.x3d";
  std::ofstream(file) << largeScene();
  rusage used{};
  for (auto _ : state) {
    const pid_t child = fork();
    if (child == 0) {
      if (std::freopen("/dev/null", "w", stdout) != nullptr)
        execl(PLEURA_PROGRAM, "pleura", "check", file.c_str(), nullptr);
      _exit(127);
    }
    int status = 0;
    if (wait4(child, &status, 0, &used) != child || status != 0) state.SkipWithError("not checked");
  }
  state.counters["peak_MB"] = static_cast<double>(used.ru_maxrss) * 1024 / 1e6;
  std::filesystem::remove(file);
}
BENCHMARK(checkCommand)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace pleura
