#include <memory>

#include <GL/glu.h>

#include <pleura/x3d/browser/render/tessellate.h>

namespace pleura::render {
namespace {

/// GLU hands vertices back as the pointers it was given: here, an index + 1.
void* handle(std::size_t index) { return reinterpret_cast<void*>(index + 1); }

PlaneMesh& mesh(void* user) { return *static_cast<PlaneMesh*>(user); }

std::size_t addVertex(PlaneMesh& to, double x, double y) {
  to.positions.emplace_back(static_cast<float>(x), static_cast<float>(y));
  return to.positions.size() - 1;
}

void onVertex(void* vertex, void* user) {
  mesh(user).indices.push_back(static_cast<std::uint32_t>(reinterpret_cast<std::size_t>(vertex) - 1));
}

void onCrossing(GLdouble position[3], void* [4], GLfloat[4], void** vertex, void* user) {
  *vertex = handle(addVertex(mesh(user), position[0], position[1]));
}

void onEdgeFlag(GLboolean) {}  // having it makes GLU give triangles only, no strips and fans

using Callback = void (*)();

template <class Function>
void setCallback(GLUtesselator* tess, GLenum which, Function function) {
  gluTessCallback(tess, which, reinterpret_cast<Callback>(function));
}

}  // namespace

PlaneMesh tessellate(const std::vector<std::vector<Eigen::Vector2f>>& contours) {
  PlaneMesh result;
  const std::unique_ptr<GLUtesselator, decltype(&gluDeleteTess)> tess(gluNewTess(), &gluDeleteTess);
  gluTessProperty(tess.get(), GLU_TESS_WINDING_RULE, GLU_TESS_WINDING_NONZERO);
  gluTessNormal(tess.get(), 0, 0, 1);
  setCallback(tess.get(), GLU_TESS_VERTEX_DATA, onVertex);
  setCallback(tess.get(), GLU_TESS_COMBINE_DATA, onCrossing);
  setCallback(tess.get(), GLU_TESS_EDGE_FLAG, onEdgeFlag);
  gluTessBeginPolygon(tess.get(), &result);
  for (const auto& contour : contours) {
    gluTessBeginContour(tess.get());
    for (const Eigen::Vector2f& point : contour) {
      double position[] = {point.x(), point.y(), 0};  // copied by GLU
      gluTessVertex(tess.get(), position, handle(addVertex(result, point.x(), point.y())));
    }
    gluTessEndContour(tess.get());
  }
  gluTessEndPolygon(tess.get());
  return result;
}

}  // namespace pleura::render
