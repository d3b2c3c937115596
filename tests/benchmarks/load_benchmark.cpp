#include <cmath>
#include <string>

#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <libxml/parser.h>

#include <pleura/nodes/standard/register.h>
#include <pleura/x3d/browser/scene/scene.h>
#include <pleura/x3d/encoding/source_text.h>

namespace pleura {
namespace {

/// A wavy sheet of 316 x 316 squares: 199,712 triangles, about 7 MB of X3D, in lines as exporters write them.
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
    registerStandardNodes(registry);
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

}  // namespace
}  // namespace pleura
