#pragma once

#include <string>
#include <vector>

namespace pleura::render {

/// A shared library opened at run time, so that the program starts on machines without it. Stays open for
/// good: Mesa's drivers leave threads and exit handlers behind that need their code.
class DynamicLibrary {
 public:
  /// Opens the first of `names` that is there. Throws std::runtime_error with the loader's own words.
  explicit DynamicLibrary(const std::vector<std::string>& names);

  /// The function of that name. Throws std::runtime_error if there is none.
  template <class Function>
  Function function(const char* name) const {
    return reinterpret_cast<Function>(symbol(name));
  }

 private:
  void* symbol(const char* name) const;

  void* handle_ = nullptr;
};

}  // namespace pleura::render
