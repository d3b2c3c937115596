#include <algorithm>

#include <pleura/x3d/encoding/allowed_path.h>

namespace pleura {

std::optional<std::filesystem::path> allowedPath(const std::string& url, const std::filesystem::path& folder,
                                                 const std::filesystem::path& root,
                                                 const ReaderLimits& limits) {
  constexpr std::string_view kAnatomy = "anatomy/";
  const auto& elsewhere = limits.anatomyFolder;
  const bool isMoved = !elsewhere.empty() && url.starts_with(kAnatomy);
  const auto path = isMoved ? elsewhere / url.substr(kAnatomy.size()) : folder / url;
  std::error_code ignored;
  const auto file = std::filesystem::weakly_canonical(path, ignored);
  const auto isBelow = [&](const std::filesystem::path& above) {
    return std::mismatch(above.begin(), above.end(), file.begin(), file.end()).first == above.end();
  };
  const bool isAllowed =
      limits.outsideFolder || isBelow(root) ||
      (!elsewhere.empty() && isBelow(std::filesystem::weakly_canonical(elsewhere, ignored)));
  return isAllowed ? std::optional(path) : std::nullopt;
}

}  // namespace pleura
