#include <algorithm>
#include <cstdlib>
#include <sstream>

#include <dlfcn.h>

#include <pleura/nodes/core/plugin.h>

namespace pleura {

namespace {

std::filesystem::path folderOfThisLibrary() {
  Dl_info info{};
  if (dladdr(reinterpret_cast<void*>(&folderOfThisLibrary), &info) == 0 || info.dli_fname == nullptr)
    return {};
  std::error_code error;
  const auto file = std::filesystem::canonical(info.dli_fname, error);
  return error ? std::filesystem::path() : file.parent_path();
}

template <class Function>
Function symbol(void* library, const char* name, const std::string& stem) {
  auto* found = reinterpret_cast<Function>(dlsym(library, name));
  if (found == nullptr) throw PluginError("library " + stem + " is no plugin of Pleura: it lacks " + name);
  return found;
}

std::string listed(const std::vector<std::filesystem::path>& folders) {
  std::string text;
  for (const auto& folder : folders) text += (text.empty() ? "" : ", ") + folder.string();
  return text;
}

}  // namespace

std::vector<std::filesystem::path> PluginLoader::defaultSearchPath() {
  std::vector<std::filesystem::path> folders;
  if (const char* path = std::getenv("PLEURA_PLUGIN_PATH"); path != nullptr) {
    std::istringstream parts(path);
    for (std::string folder; std::getline(parts, folder, ':');)
      if (!folder.empty()) folders.emplace_back(folder);
  }
  folders.push_back(folderOfThisLibrary());
  return folders;
}

std::string PluginLoader::stem(std::string_view library) {
  constexpr std::string_view kQuotes = "\"' \t\n";
  const auto first = library.find_first_not_of(kQuotes);
  if (first == std::string_view::npos) return {};
  library = library.substr(first, library.find_last_not_of(kQuotes) - first + 1);
  for (const std::string_view ending : {".dll", ".so", ".dylib"})
    if (library.ends_with(ending)) library.remove_suffix(ending.size());
  if (library.starts_with("libpleura_")) library.remove_prefix(10);
  if (library.starts_with("lib")) library.remove_prefix(3);
  const bool plain = std::all_of(library.begin(), library.end(), [](unsigned char c) {
    return std::isalnum(c) != 0 || c == '_' || c == '-';
  });
  return plain ? std::string(library) : std::string();
}

void PluginLoader::load(std::string_view library, NodeRegistry& registry) {
  const std::string name = stem(library);
  if (name.empty())
    throw PluginError("\"" + std::string(library) +
                      "\" is no name of a library: letters, digits, _ and - only");
  if (std::find(loaded_.begin(), loaded_.end(), name) != loaded_.end()) return;

  std::filesystem::path file;
  for (const auto& folder : searchPath_) {
    file = folder / ("libpleura_" + name + ".so");
    if (std::filesystem::exists(file)) break;
    file.clear();
  }
  if (file.empty())
    throw PluginError("library " + name + " not found (libpleura_" + name + ".so in " + listed(searchPath_) +
                      ")");

  void* handle = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE);
  if (handle == nullptr) throw PluginError("library " + name + " can't be loaded: " + dlerror());
  const int abi = symbol<int (*)()>(handle, "pleura_plugin_abi", name)();
  if (abi != kPluginAbi)
    throw PluginError("library " + name + " was built for plugin ABI " + std::to_string(abi) +
                      ", this Pleura has " + std::to_string(kPluginAbi) + ": build it again");
  const auto registerNodes = symbol<void (*)(NodeRegistry*)>(handle, "pleura_register_nodes", name);
  NodeRegistry with = registry;
  try {
    registerNodes(&with);
  } catch (const DuplicateTypeError& error) {
    throw PluginError("library " + name + ": " + error.what());
  }
  registry = std::move(with);
  loaded_.push_back(name);
}

}  // namespace pleura
