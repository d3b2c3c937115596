#include <Eigen/Geometry>
#include <Eigen/LU>

#include <pleura/x3d/browser/render/light_buffer.h>
#include <pleura/x3d/browser/render/shaders.h>
#include <pleura/x3d/browser/render/surface_pass.h>

namespace pleura::render {

SurfacePass::SurfacePass(const GlFunctions& gl, const std::string& header, const char* fragmentSource)
    : gl_(gl), program_(gl, header, shaders::surfaceVertex, fragmentSource) {
  const auto at = [this](const char* name) { return program_.uniform(name); };
  at_ = {at("projection"), at("modelView"),    at("normalMatrix"),     at("lightCount"),
         at("lightMask"),  at("diffuseAlpha"), at("specularExponent"), at("emissiveAmbient"),
         at("lit"),        at("faceted"),      at("colored"),          at("parallelView")};
  program_.bindBlock("Lights", LightBuffer::binding);
}

void SurfacePass::begin(const FrameUniforms& frame) {
  program_.use();
  view_ = frame.view;
  alwaysOn_ = frame.headlight ? 1u << (frame.lightCount - 1) : 0u;
  gl_.UniformMatrix4fv(at_.projection, 1, GL_FALSE, frame.projection.data());
  gl_.Uniform1i(at_.lightCount, frame.lightCount);
  gl_.Uniform1i(at_.parallelView, frame.parallelView);
}

void SurfacePass::draw(const SurfaceDraw& surface) {
  const DrawItem& item = *surface.item;
  const Geometry& geometry = *item.geometry;
  const Eigen::Matrix4f modelView = view_ * item.model;
  const Eigen::Matrix3f linear = modelView.topLeftCorner<3, 3>();
  // The cofactor matrix, det(A) A^-T: turns normals like A^-T, but also exists where A is flat.
  Eigen::Matrix3f cofactor;
  cofactor << linear.col(1).cross(linear.col(2)), linear.col(2).cross(linear.col(0)),
      linear.col(0).cross(linear.col(1));
  const bool mirrored = linear.determinant() < 0;
  if (mirrored) cofactor = -cofactor;
  gl_.UniformMatrix4fv(at_.modelView, 1, GL_FALSE, modelView.data());
  gl_.UniformMatrix3fv(at_.normalMatrix, 1, GL_FALSE, cofactor.data());
  setMaterial(item, *surface.gpu);

  gl_.FrontFace(geometry.ccw != mirrored ? GL_CCW : GL_CW);
  (geometry.solid ? gl_.Enable : gl_.Disable)(GL_CULL_FACE);
  if (geometry.primitive == Primitive::Points) gl_.PointSize(item.size);
  surface.gpu->draw(geometry.primitive);
}

void SurfacePass::setMaterial(const DrawItem& item, const GpuGeometry& gpu) const {
  const Material& m = item.material;
  const bool lit = m.lit && item.geometry->primitive == Primitive::Triangles;
  const auto set = [this](GLint location, const Eigen::Vector3f& rgb, float a) {
    gl_.Uniform4fv(location, 1, Eigen::Vector4f(rgb.x(), rgb.y(), rgb.z(), a).data());
  };
  set(at_.diffuseAlpha, m.diffuseColor, 1 - m.transparency);
  set(at_.specularExponent, m.specularColor, 128 * m.shininess);
  set(at_.emissiveAmbient, m.emissiveColor, m.ambientIntensity);
  gl_.Uniform1i(at_.lit, lit);
  gl_.Uniform1i(at_.faceted, !gpu.hasNormals());
  gl_.Uniform1i(at_.colored, gpu.hasColors());
  gl_.Uniform1ui(at_.lightMask, item.lights | alwaysOn_);
}

}  // namespace pleura::render
