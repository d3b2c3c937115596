#include <stdexcept>
#include <string>

#include <pleura/x3d/browser/render/egl_context.h>
#include <pleura/x3d/browser/render/gl_context.h>
#include <pleura/x3d/browser/render/osmesa_context.h>

namespace pleura::render {
namespace {

template <class Context>
std::unique_ptr<GlContext> tryToMake(const char* name, std::string& failures) {
  try {
    return std::make_unique<Context>();
  } catch (const std::runtime_error& error) {
    failures += std::string(failures.empty() ? "" : "; ") + name + ": " + error.what();
    return nullptr;
  }
}

}  // namespace

std::unique_ptr<GlContext> makeOffscreenContext(OffscreenBackend backend) {
  std::string failures;
  std::unique_ptr<GlContext> context;
  if (backend != OffscreenBackend::Egl) context = tryToMake<OsmesaContext>("OSMesa", failures);
  if (!context && backend != OffscreenBackend::Osmesa) context = tryToMake<EglContext>("EGL", failures);
  if (!context) throw std::runtime_error("no off-screen OpenGL: " + failures);
  return context;
}

}  // namespace pleura::render
