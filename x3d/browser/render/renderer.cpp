#include <cstring>
#include <optional>
#include <stdexcept>
#include <vector>

#include <fmt/format.h>

#include <pleura/x3d/browser/render/background_pass.h>
#include <pleura/x3d/browser/render/depth_peeling.h>
#include <pleura/x3d/browser/render/fragment_lists.h>
#include <pleura/x3d/browser/render/geometry_cache.h>
#include <pleura/x3d/browser/render/light_buffer.h>
#include <pleura/x3d/browser/render/overlay_pass.h>
#include <pleura/x3d/browser/render/projection.h>
#include <pleura/x3d/browser/render/render_target.h>
#include <pleura/x3d/browser/render/renderer.h>
#include <pleura/x3d/browser/render/shaders.h>
#include <pleura/x3d/browser/render/surface_pass.h>
#include <pleura/x3d/browser/render/validate.h>

namespace pleura::render {
namespace {

constexpr const char* version = "#version 330 core\n";

bool hasExtension(const GlFunctions& gl, const char* name) {
  GLint count = 0;
  gl.GetIntegerv(GL_NUM_EXTENSIONS, &count);
  for (GLint i = 0; i < count; ++i)
    if (std::strcmp(reinterpret_cast<const char*>(gl.GetStringi(GL_EXTENSIONS, static_cast<GLuint>(i))),
                    name) == 0)
      return true;
  return false;
}

/// Depth peeling compares sample by sample, which OpenGL 3.3 can do with this extension; all of OpenGL 4 has
/// it.
constexpr const char* sampleShading = "GL_ARB_sample_shading";

std::unique_ptr<TransparencyPass> makeTransparency(const GlFunctions& gl, bool depthPeeling, int samples) {
  if (gl.version >= 43 && !depthPeeling) return std::make_unique<FragmentLists>(gl, samples);
  return std::make_unique<DepthPeeling>(gl, hasExtension(gl, sampleShading));
}

int usableSamples(const GlFunctions& gl, int wanted) {
  return gl.version >= 43 || hasExtension(gl, sampleShading) ? supportedSamples(gl, wanted) : 1;
}

void checkSize(int width, int height) {
  if (width < 1 || height < 1 || width > 8192 || height > 8192)
    throw std::invalid_argument(fmt::format("picture of {} x {}: sides must be in [1, 8192]", width, height));
}

GlContext& madeCurrent(GlContext& context) {
  context.makeCurrent();
  return context;
}

}  // namespace

struct Renderer::Implementation {
  Implementation(GlContext& glContext, const RendererOptions& options)
      : context(madeCurrent(glContext)),
        gl(loadGlFunctions(context)),
        samples(usableSamples(gl, options.samples)),
        geometries(gl),
        lights(gl),
        background(gl, version),
        shaded(gl, version, std::string(shaders::surfaceFragment) + shaders::surfaceOutput),
        transparency(makeTransparency(gl, options.depthPeeling, samples)),
        overlay(gl, version) {}

  void collectSurfaces(const DrawList& list);
  void drawOpaque(const DrawList& list, const Frame& frame);

  GlContext& context;
  GlFunctions gl;
  int samples;
  GeometryCache geometries;
  LightBuffer lights;
  BackgroundPass background;
  SurfacePass shaded;
  std::unique_ptr<TransparencyPass> transparency;
  OverlayPass overlay;
  std::optional<RenderTarget> target;
  std::vector<SurfaceDraw> opaque, transparent;
  RenderStats stats;
};

Renderer::Renderer(GlContext& context, const RendererOptions& options) {
  if (options.samples < 1) throw std::invalid_argument("samples must be at least 1");
  implementation_ = std::make_unique<Implementation>(context, options);
}

Renderer::~Renderer() { implementation_->context.makeCurrent(); }

void Renderer::Implementation::collectSurfaces(const DrawList& list) {
  opaque.clear();
  transparent.clear();
  stats = {};
  for (const DrawItem& item : list.items) {
    GpuGeometry& gpu = geometries.find(*item.geometry);
    stats.uploads += gpu.update(*item.geometry);
    const SurfaceDraw surface{&item, &gpu};
    (surface.transparent() ? transparent : opaque).push_back(surface);
  }
  geometries.collect();
}

void Renderer::Implementation::drawOpaque(const DrawList& list, const Frame& frame) {
  target->bind(0);
  gl.Viewport(0, 0, target->width(), target->height());
  gl.Enable(GL_DEPTH_TEST);
  gl.DepthMask(GL_TRUE);
  gl.DepthFunc(GL_LESS);
  const Eigen::Vector3f& sky = list.background.skyColor.front();
  gl.ClearColor(sky.x(), sky.y(), sky.z(), 1);
  gl.ClearDepth(1);
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  for (const SurfaceDraw& surface : opaque) shaded.draw(surface, frame);
  gl.DepthFunc(GL_LEQUAL);
  background.draw(list.background, list.camera, target->width(), target->height());
}

void Renderer::draw(const DrawList& list, int width, int height) {
  Implementation& self = *implementation_;
  checkSize(width, height);
  validate(list);
  const Eigen::Matrix4f projection = projectionMatrix(list.camera, width, height);
  self.context.makeCurrent();
  self.collectSurfaces(list);
  if (!self.target || self.target->width() != width || self.target->height() != height)
    self.target.emplace(self.gl, width, height, self.samples);

  const Frame frame{list.camera.view, projection, list.camera.orthographic.has_value(), list.headlight,
                    self.lights.update(list)};
  self.drawOpaque(list, frame);
  self.stats.draws = static_cast<int>(self.opaque.size());
  if (self.transparent.empty())
    self.target->resolve();
  else
    self.stats.draws += self.transparency->draw(*self.target, self.transparent, frame);
  self.overlay.draw(list.overlay, width, height);
}

Image Renderer::readImage() {
  if (!implementation_->target) throw std::logic_error("there is no picture before the first draw()");
  implementation_->context.makeCurrent();
  return implementation_->target->read();
}

void Renderer::present() {
  if (!implementation_->target) throw std::logic_error("there is no picture before the first draw()");
  implementation_->context.makeCurrent();
  implementation_->target->present();
}

const RenderStats& Renderer::stats() const { return implementation_->stats; }

}  // namespace pleura::render
