#include <pleura/x3d/browser/commands/scene_folder.h>
#include <pleura/x3d/encoding/source_text.h>

namespace pleura {

std::filesystem::path sceneFolder() {
  std::error_code error;
  const auto program = std::filesystem::canonical("/proc/self/exe", error);
  for (const auto& folder : {program.parent_path().parent_path() / "share/pleura/scenes",
                             program.parent_path().parent_path().parent_path().parent_path() / "scenes"})
    if (std::filesystem::exists(folder / "breathing_thorax.x3d", error)) return folder;
  throw FileError("Pleura's scenes are not where the program is installed");
}

}  // namespace pleura
