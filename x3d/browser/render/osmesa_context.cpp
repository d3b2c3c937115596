#include <stdexcept>

#include <pleura/x3d/browser/render/osmesa_context.h>

namespace pleura::render {
namespace {

// From GL/osmesa.h, which newer releases of Mesa no longer have.
constexpr int OSMESA_FORMAT = 0x22;
constexpr int OSMESA_PROFILE = 0x33;
constexpr int OSMESA_CORE_PROFILE = 0x34;
constexpr int OSMESA_CONTEXT_MAJOR_VERSION = 0x36;
constexpr int OSMESA_CONTEXT_MINOR_VERSION = 0x37;
using CreateContextAttribs = void* (*)(const int*, void*);
using MakeCurrent = GLboolean (*)(void*, void*, GLenum, GLsizei, GLsizei);
using GetProcAddress = GlFunction (*)(const char*);
using DestroyContext = void (*)(void*);

}  // namespace

OsmesaContext::OsmesaContext() : library_({"libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so"}) {
  const int attributes[] = {OSMESA_FORMAT,
                            GL_RGBA,
                            OSMESA_PROFILE,
                            OSMESA_CORE_PROFILE,
                            OSMESA_CONTEXT_MAJOR_VERSION,
                            3,
                            OSMESA_CONTEXT_MINOR_VERSION,
                            3,
                            0};
  context_ = library_.function<CreateContextAttribs>("OSMesaCreateContextAttribs")(attributes, nullptr);
  if (!context_) throw std::runtime_error("no OpenGL 3.3 core context");
  makeCurrent();
}

OsmesaContext::~OsmesaContext() { library_.function<DestroyContext>("OSMesaDestroyContext")(context_); }

void OsmesaContext::makeCurrent() {
  if (!library_.function<MakeCurrent>("OSMesaMakeCurrent")(context_, framebuffer_.data(), GL_UNSIGNED_BYTE, 4,
                                                           4))
    throw std::runtime_error("OSMesaMakeCurrent failed");
}

GlFunction OsmesaContext::getProcAddress(const char* name) const {
  return library_.function<GetProcAddress>("OSMesaGetProcAddress")(name);
}

}  // namespace pleura::render
