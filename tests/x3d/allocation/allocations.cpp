#include <atomic>
#include <cerrno>
#include <cstddef>

#include <pleura/tests/x3d/allocation/allocations.h>

namespace {
std::atomic<std::uint64_t> asked{0};
}

std::uint64_t pleura::allocations() { return asked; }

// The names are those of glibc and of the sanitizers.
// NOLINTBEGIN(bugprone-reserved-identifier)
#ifdef PLEURA_SANITIZE

// A sanitizer has malloc for itself, and tells who wants to know.
extern "C" int __sanitizer_install_malloc_and_free_hooks(void (*)(const volatile void*, std::size_t),
                                                         void (*)(const volatile void*));
namespace {
const int installed = __sanitizer_install_malloc_and_free_hooks(
    [](const volatile void*, std::size_t) { ++asked; }, [](const volatile void*) {});
}

#else

// In the place of glibc's, for the program and all its libraries; new calls malloc.
extern "C" {
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t number, std::size_t size);
void* __libc_realloc(void* old, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);

void* malloc(std::size_t size) {
  ++asked;
  return __libc_malloc(size);
}
void* calloc(std::size_t number, std::size_t size) {
  ++asked;
  return __libc_calloc(number, size);
}
void* realloc(void* old, std::size_t size) {
  ++asked;
  return __libc_realloc(old, size);
}
void* aligned_alloc(std::size_t alignment, std::size_t size) {
  ++asked;
  return __libc_memalign(alignment, size);
}
int posix_memalign(void** out, std::size_t alignment, std::size_t size) {
  ++asked;
  *out = __libc_memalign(alignment, size);
  return *out != nullptr ? 0 : ENOMEM;
}
}

#endif
// NOLINTEND(bugprone-reserved-identifier)
