#include <algorithm>
#include <cstdlib>

#include "../x3d/render/shapes.h"
#include <benchmark/benchmark.h>

#include <pleura/x3d/browser/render/gl_objects.h>
#include <pleura/x3d/browser/render/projection.h>
#include <pleura/x3d/browser/render/renderer.h>
#include <pleura/x3d/browser/render/shader_program.h>

namespace pleura::render {
namespace {

constexpr int width = 1280, height = 720, samples = 4;

/// 20,000 lit triangles that cover two fifths of the picture.
struct BallScene {
  test::Shape ball = test::sphere(1, 100);
  DrawList list;

  BallScene() {
    test::lookFrom(list, {0, 0, 3});
    list.items = {{&ball.geometry}};
    list.items[0].material.specularColor = Eigen::Vector3f::Constant(0.5f);
  }
};

constexpr const char* bareVertex = R"(
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
uniform mat4 view;
uniform mat4 projection;
out vec3 P;
out vec3 n;
void main() {
  vec4 p = view * vec4(position, 1);
  P = p.xyz;
  n = mat3(view) * normal;
  gl_Position = projection * p;
}
)";

constexpr const char* bareFragment = R"(
in vec3 P;
in vec3 n;
uniform vec3 diffuse;
uniform vec3 specular;
uniform float exponent;
out vec4 pixel;
void main() {
  vec3 N = normalize(n), V = normalize(-P), L = vec3(0, 0, 1);
  vec3 I = max(dot(N, L), 0) * diffuse + pow(max(dot(N, normalize(L + V)), 0), exponent) * specular;
  pixel = vec4(min(I, 1), 1);
}
)";

/// The same picture by the shortest way through OpenGL.
class BareLoop {
 public:
  BareLoop(const GlFunctions& functions, const BallScene& scene)
      : gl(functions),
        program(gl, "#version 330 core\n", bareVertex, bareFragment),
        count(static_cast<GLsizei>(scene.ball.indices.size())) {
    for (int i = 0; i < 2; ++i) {
      gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffers[i]);
      attach(colors[i], GL_COLOR_ATTACHMENT0, GL_RGBA8, i == 0 ? samples : 0);
    }
    gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffers[0]);
    attach(depth, GL_DEPTH_ATTACHMENT, GL_DEPTH_COMPONENT32F, samples);
    gl.BindVertexArray(vertexArray);
    sendVertices(0, scene.ball.positions);
    sendVertices(1, scene.ball.normals);
    gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers[2]);
    gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, count * static_cast<GLsizeiptr>(sizeof(std::uint32_t)),
                  scene.ball.indices.data(), GL_STATIC_DRAW);
    program.use();
    gl.UniformMatrix4fv(program.uniform("view"), 1, GL_FALSE, scene.list.camera.view.data());
    gl.UniformMatrix4fv(program.uniform("projection"), 1, GL_FALSE,
                        projectionMatrix(scene.list.camera, width, height).data());
    const Material& m = scene.list.items[0].material;
    gl.Uniform3fv(program.uniform("diffuse"), 1, m.diffuseColor.data());
    gl.Uniform3fv(program.uniform("specular"), 1, m.specularColor.data());
    gl.Uniform1f(program.uniform("exponent"), 128 * m.shininess);
    gl.Viewport(0, 0, width, height);
    gl.Enable(GL_DEPTH_TEST);
    gl.Enable(GL_CULL_FACE);
  }

  void draw() {
    gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffers[0]);
    gl.ClearColor(0, 0, 0, 1);
    gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    gl.DrawElements(GL_TRIANGLES, count, GL_UNSIGNED_INT, nullptr);
    gl.BindFramebuffer(GL_READ_FRAMEBUFFER, framebuffers[0]);
    gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffers[1]);
    gl.BlitFramebuffer(0, 0, width, height, 0, 0, width, height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  }

  /// The most by which a byte differs from the renderer's picture.
  int difference(const Image& image) {
    std::vector<std::uint8_t> rgba(static_cast<std::size_t>(width) * height * 4);
    gl.BindFramebuffer(GL_READ_FRAMEBUFFER, framebuffers[1]);
    gl.ReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
    int most = 0;
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x)
        for (int c = 0; c < 3; ++c) {
          const std::size_t pixel =
              static_cast<std::size_t>(height - 1 - y) * width + static_cast<std::size_t>(x);
          most = std::max(most, std::abs(rgba[4 * pixel + static_cast<std::size_t>(c)] - image.at(x, y)[c]));
        }
    return most;
  }

 private:
  void attach(GLuint buffer, GLenum attachment, GLenum format, int count4) {
    gl.BindRenderbuffer(GL_RENDERBUFFER, buffer);
    gl.RenderbufferStorageMultisample(GL_RENDERBUFFER, count4, format, width, height);
    gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, buffer);
  }
  void sendVertices(GLuint attribute, const std::vector<Eigen::Vector3f>& values) {
    gl.BindBuffer(GL_ARRAY_BUFFER, buffers[attribute]);
    gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(values.size() * sizeof(Eigen::Vector3f)),
                  values.data(), GL_STATIC_DRAW);
    gl.VertexAttribPointer(attribute, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
    gl.EnableVertexAttribArray(attribute);
  }

  const GlFunctions& gl;
  ShaderProgram program;
  GLsizei count;
  GlVertexArray vertexArray{gl};
  GlBuffer buffers[3]{GlBuffer(gl), GlBuffer(gl), GlBuffer(gl)};
  GlRenderbuffer colors[2]{GlRenderbuffer(gl), GlRenderbuffer(gl)};
  GlRenderbuffer depth{gl};
  GlFramebuffer framebuffers[2]{GlFramebuffer(gl), GlFramebuffer(gl)};
};

void opaqueByRenderer(benchmark::State& state) {
  const auto context = makeOffscreenContext();
  const GlFunctions gl = loadGlFunctions(*context);
  const BallScene scene;
  Renderer renderer(*context, {samples});
  renderer.draw(scene.list, width, height);  // compiles
  gl.Finish();
  for (auto _ : state) {
    renderer.draw(scene.list, width, height);
    gl.Finish();
  }
}

void opaqueByBareLoop(benchmark::State& state) {
  const auto context = makeOffscreenContext();
  const GlFunctions gl = loadGlFunctions(*context);
  const BallScene scene;
  Renderer renderer(*context, {samples});
  renderer.draw(scene.list, width, height);
  const Image image = renderer.readImage();
  BareLoop loop(gl, scene);
  loop.draw();  // compiles
  gl.Finish();
  for (auto _ : state) {
    loop.draw();
    gl.Finish();
  }
  state.counters["largest difference"] = loop.difference(image);
}

/// Two translucent, two-sided lungs of 20,000 triangles each over a diaphragm, behind and before 24 ribs;
/// they move each frame.
void breathingThorax(benchmark::State& state) {
  const auto context = makeOffscreenContext();
  const GlFunctions gl = loadGlFunctions(*context);
  test::Shape lungs[] = {test::sphere(1, 100), test::sphere(1, 100)};
  test::Shape diaphragm = test::sphere(1, 60);
  const test::Shape rib = test::rod(0.08f, 3);
  DrawList list;
  test::lookFrom(list, {1, 1, 5});
  for (int i = 0; i < 2; ++i) {
    lungs[i].geometry.solid = false;
    list.items.push_back({&lungs[i].geometry, test::translation(i == 0 ? -0.9f : 0.9f, 0, 0)});
    list.items.back().material.transparency = 0.6f;
  }
  diaphragm.geometry.solid = false;
  list.items.push_back({&diaphragm.geometry, test::translation(0, -1.2f, 0)});
  list.items.back().material.transparency = 0.4f;
  for (int i = 0; i < 24; ++i)
    list.items.push_back(
        {&rib.geometry, test::translation(-1.8f + 0.3f * static_cast<float>(i / 2), 0, i % 2 == 0 ? 1 : -1)});
  Renderer renderer(*context, {samples});
  renderer.draw(list, width, height);  // compiles
  gl.Finish();
  for (auto _ : state) {
    for (test::Shape& lung : lungs) {
      ++lung.geometry.positionsRevision;
      ++lung.geometry.normalsRevision;
    }
    renderer.draw(list, width, height);
    gl.Finish();
  }
}

BENCHMARK(opaqueByBareLoop)->Unit(benchmark::kMillisecond)->UseRealTime()->MeasureProcessCPUTime();
BENCHMARK(opaqueByRenderer)->Unit(benchmark::kMillisecond)->UseRealTime()->MeasureProcessCPUTime();
BENCHMARK(breathingThorax)->Unit(benchmark::kMillisecond)->UseRealTime()->MeasureProcessCPUTime();

}  // namespace
}  // namespace pleura::render
