#include <utility>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <fmt/format.h>

#include <pleura/x3d/browser/render/shaders.h>
#include <pleura/x3d/browser/render/surface_pass.h>

namespace pleura::render {
namespace {

/// lightKind[] of the lights that shine on the item; the headlight, the last, always does.
std::string lightKinds(const DrawItem& item, const Frame& frame) {
  std::string kinds;
  for (std::size_t i = 0; i < frame.lights.size(); ++i) {
    const bool on = (frame.headlight && i + 1 == frame.lights.size()) || (item.lights >> i & 1u) != 0;
    kinds += fmt::format("{}{}", i == 0 ? "" : ", ", on ? static_cast<int>(frame.lights[i]) : 3);
  }
  return kinds.empty() ? "3" : kinds;
}

/// The definitions that make the variant of surfaceFragment for an item.
std::string definitions(const SurfaceDraw& surface, const Frame& frame) {
  const Material& material = surface.item->material;
  const bool lit = material.lit && surface.item->geometry->primitive == Primitive::Triangles;
  std::string text = fmt::format("#define LIT {}\n#define COLORED {}\n", lit, surface.gpu->hasColors());
  const bool specular = lit && material.specularColor != Eigen::Vector3f::Zero();
  const bool faceted = lit && !surface.gpu->hasNormals();
  const std::string kinds = lit ? lightKinds(*surface.item, frame) : "3";
  text += fmt::format("#define SPECULAR {}\n#define FACETED {}\n#define PARALLEL {}\n", specular, faceted,
                      lit && frame.parallelView);
  return text + fmt::format("const int lightKind[] = int[]({});\n#define LIGHTS lightKind.length()\n", kinds);
}

}  // namespace

SurfacePass::Program::Program(const GlFunctions& gl, const std::string& header,
                              const std::string& fragmentSource)
    : shader(gl, header, shaders::surfaceVertex, fragmentSource.c_str()),
      projection(shader.uniform("projection")),
      modelView(shader.uniform("modelView")),
      normalMatrix(shader.uniform("normalMatrix")),
      diffuseAlpha(shader.uniform("diffuseAlpha")),
      specularExponent(shader.uniform("specularExponent")),
      emissiveAmbient(shader.uniform("emissiveAmbient")) {
  shader.bindBlock("Lights", LightBuffer::binding);
}

SurfacePass::SurfacePass(const GlFunctions& gl, std::string header, std::string fragmentSource,
                         Variants variants)
    : gl_(gl), header_(std::move(header)), fragmentSource_(std::move(fragmentSource)), variants_(variants) {}

void SurfacePass::draw(const SurfaceDraw& surface, const Frame& frame) {
  const DrawItem& item = *surface.item;
  const Program& chosen = program(variants_ == Variants::OnlyOne ? "" : definitions(surface, frame));
  chosen.shader.use();
  gl_.UniformMatrix4fv(chosen.projection, 1, GL_FALSE, frame.projection.data());
  setTransform(chosen, item, frame);
  setMaterial(chosen, item.material);
  (item.geometry->solid ? gl_.Enable : gl_.Disable)(GL_CULL_FACE);
  if (item.geometry->primitive == Primitive::Points) gl_.PointSize(item.size);
  surface.gpu->draw(item.geometry->primitive);
}

const SurfacePass::Program& SurfacePass::program(const std::string& definitions) {
  const auto found = programs_.find(definitions);
  if (found != programs_.end()) return found->second;
  return programs_
      .emplace(std::piecewise_construct, std::forward_as_tuple(definitions),
               std::forward_as_tuple(gl_, header_ + definitions, fragmentSource_))
      .first->second;
}

void SurfacePass::setTransform(const Program& to, const DrawItem& item, const Frame& frame) const {
  const Eigen::Matrix4f modelView = frame.view * item.model;
  const Eigen::Matrix3f A = modelView.topLeftCorner<3, 3>();
  // The cofactor matrix, det(A) A^-T: turns normals like A^-T, but also exists where A is flat.
  Eigen::Matrix3f cofactor;
  cofactor << A.col(1).cross(A.col(2)), A.col(2).cross(A.col(0)), A.col(0).cross(A.col(1));
  const bool mirrored = A.determinant() < 0;
  if (mirrored) cofactor = -cofactor;
  gl_.UniformMatrix4fv(to.modelView, 1, GL_FALSE, modelView.data());
  gl_.UniformMatrix3fv(to.normalMatrix, 1, GL_FALSE, cofactor.data());
  gl_.FrontFace(item.geometry->ccw != mirrored ? GL_CCW : GL_CW);
}

void SurfacePass::setMaterial(const Program& to, const Material& m) const {
  const auto set = [this](GLint location, const Eigen::Vector3f& rgb, float a) {
    gl_.Uniform4fv(location, 1, Eigen::Vector4f(rgb.x(), rgb.y(), rgb.z(), a).data());
  };
  set(to.diffuseAlpha, m.diffuseColor, 1 - m.transparency);
  set(to.specularExponent, m.specularColor, 128 * m.shininess);
  set(to.emissiveAmbient, m.emissiveColor, m.ambientIntensity);
}

}  // namespace pleura::render
