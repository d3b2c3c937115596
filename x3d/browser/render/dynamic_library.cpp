#include <stdexcept>

#include <dlfcn.h>

#include <pleura/x3d/browser/render/dynamic_library.h>

namespace pleura::render {

DynamicLibrary::DynamicLibrary(const std::vector<std::string>& names) {
  std::string reasons;
  for (const std::string& name : names) {
    handle_ = dlopen(name.c_str(), RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE);
    if (handle_) return;
    reasons += (reasons.empty() ? "" : "; ") + std::string(dlerror());
  }
  throw std::runtime_error(reasons);
}

void* DynamicLibrary::symbol(const char* name) const {
  void* address = dlsym(handle_, name);
  if (!address) throw std::runtime_error(dlerror());
  return address;
}

}  // namespace pleura::render
