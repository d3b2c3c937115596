#include <pleura/x3d/browser/render/fragment_lists.h>
#include <pleura/x3d/browser/render/shaders.h>

namespace pleura::render {
namespace {

constexpr const char* kListsVersion = "#version 430 core\n";
constexpr std::uint32_t initialCapacity = 1u << 20;
constexpr GLsizeiptr bytesPerFragment = 16;
constexpr GLuint headsBinding = 0, fragmentsBinding = 1;

/// Stands before the fragments in their buffer.
struct ListHeader {
  std::uint32_t count;
  std::uint32_t capacity;
  std::uint32_t width;  // of the picture
  std::uint32_t padding;
};

std::string blenderHeader(int samples) {
  return std::string(kListsVersion) + "#define SAMPLES " + std::to_string(samples) + "\n";
}

}  // namespace

FragmentLists::FragmentLists(const GlFunctions& gl, int samples)
    : gl_(gl),
      lister_(
          gl, kListsVersion,
          std::string(shaders::surfaceFragment) + shaders::fragmentListBuffers + shaders::fragmentListOutput),
      blender_(gl, blenderHeader(samples), shaders::wholePictureVertex,
               (std::string(shaders::fragmentListBuffers) + shaders::fragmentListBlend).c_str()),
      noVertices_(gl),
      heads_(gl),
      fragments_(gl) {}

int FragmentLists::draw(const RenderTarget& target, std::span<const SurfaceDraw> surfaces,
                        const Frame& frame) {
  if (capacity_ == 0) reserve(initialCapacity);
  int draws = static_cast<int>(surfaces.size()) + 1;
  const std::uint32_t count = collect(target, surfaces, frame);
  if (count > capacity_) {
    reserve(count + count / 4);
    collect(target, surfaces, frame);
    draws += static_cast<int>(surfaces.size());
  }
  target.resolve();
  blend(target);
  return draws;
}

void FragmentLists::reserve(std::uint32_t capacity) {
  gl_.BindBuffer(GL_SHADER_STORAGE_BUFFER, fragments_);
  gl_.BufferData(GL_SHADER_STORAGE_BUFFER,
                 static_cast<GLsizeiptr>(sizeof(ListHeader)) + capacity * bytesPerFragment, nullptr,
                 GL_DYNAMIC_COPY);
  capacity_ = capacity;
}

std::uint32_t FragmentLists::collect(const RenderTarget& target, std::span<const SurfaceDraw> surfaces,
                                     const Frame& frame) {
  const int pixels = target.width() * target.height();
  gl_.BindBuffer(GL_SHADER_STORAGE_BUFFER, heads_);
  if (pixels != pixels_)
    gl_.BufferData(GL_SHADER_STORAGE_BUFFER, pixels * static_cast<GLsizeiptr>(sizeof(GLuint)), nullptr,
                   GL_DYNAMIC_COPY);
  pixels_ = pixels;
  gl_.ClearBufferData(GL_SHADER_STORAGE_BUFFER, GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, nullptr);
  gl_.BindBuffer(GL_SHADER_STORAGE_BUFFER, fragments_);
  const ListHeader header{0, capacity_, static_cast<std::uint32_t>(target.width()), 0};
  gl_.BufferSubData(GL_SHADER_STORAGE_BUFFER, 0, sizeof(header), &header);
  gl_.BindBufferBase(GL_SHADER_STORAGE_BUFFER, headsBinding, heads_);
  gl_.BindBufferBase(GL_SHADER_STORAGE_BUFFER, fragmentsBinding, fragments_);

  target.bind(0);
  gl_.ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  gl_.DepthMask(GL_FALSE);
  gl_.DepthFunc(GL_LESS);
  for (const SurfaceDraw& surface : surfaces) lister_.draw(surface, frame);
  gl_.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  gl_.MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
  std::uint32_t count = 0;
  gl_.GetBufferSubData(GL_SHADER_STORAGE_BUFFER, 0, sizeof(count), &count);
  return count;
}

void FragmentLists::blend(const RenderTarget& target) const {
  blender_.use();
  gl_.Uniform1i(blender_.uniform("opaqueColor"), 0);
  gl_.Uniform1i(blender_.uniform("opaqueDepth"), 1);
  gl_.ActiveTexture(GL_TEXTURE1);
  gl_.BindTexture(GL_TEXTURE_2D_MULTISAMPLE, target.depth(0));
  gl_.ActiveTexture(GL_TEXTURE0);
  gl_.BindTexture(GL_TEXTURE_2D_MULTISAMPLE, target.color());
  gl_.BindVertexArray(noVertices_);
  gl_.Disable(GL_DEPTH_TEST);
  gl_.Disable(GL_CULL_FACE);
  gl_.DrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace pleura::render
