#include <cstddef>
#include <cstdint>
#include <string>

#include <pleura/tests/x3d/encoding/read_scene.h>
#include <pleura/x3d/encoding/writer.h>

// Any bytes are a scene or faults with their places, and what was read can be written and read again.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace pleura;
  auto scene = ReadScene::ofText(std::string(reinterpret_cast<const char*>(data), size));
  ReadScene::ofText(writeX3d(scene.document));
  return 0;
}
