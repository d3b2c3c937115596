#pragma once

#include <cstddef>
#include <span>
#include <string>

#include <assimp/DefaultIOSystem.h>

namespace pleura {

/// The files assimp may read: those on disk, or one in memory alone. Each is taken into memory whole, and one
/// that is read many times over throws: some of assimp's readers never see the end of a truncated file
/// otherwise.
class GuardedFiles : public Assimp::DefaultIOSystem {
 public:
  GuardedFiles() = default;
  GuardedFiles(std::string name, std::span<const std::byte> content)
      : name_(std::move(name)), content_(content) {}

  bool Exists(const char* file) const override;
  Assimp::IOStream* Open(const char* file, const char* mode) override;

 private:
  std::string name_;  // empty: the disk
  std::span<const std::byte> content_;
};

}  // namespace pleura
