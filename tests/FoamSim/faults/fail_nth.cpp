// Preloaded (LD_PRELOAD) into a program: the n-th call of a kind that its main makes fails, and no other.
//
//   FAULT_KIND   write, sync, rename, open (to write) or memory (operator new)
//   FAULT_AT     n; 0: none
//   FAULT_COUNT  a file that gets the number of such calls when main returns
#include <dlfcn.h>
#include <fcntl.h>
#include <sys/uio.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <new>

namespace {

using Main = int (*)(int, char**, char**);

// Only what happens within main counts: a program that cannot even be loaded is nothing to test.
struct Faults {
  Main main = nullptr;
  const char* kind = nullptr;
  long at = 0;
  std::atomic<long> calls{0};
  std::atomic<bool> on{false};
};
Faults faults;

template <class Function>
Function next(const char* name) {
  return reinterpret_cast<Function>(::dlsym(RTLD_NEXT, name));
}

bool fails(const char* kind) {
  return faults.on && std::strcmp(kind, faults.kind) == 0 && ++faults.calls == faults.at;
}

// Standard output and error are the test's.
bool write_fails(int descriptor) {
  if (descriptor <= STDERR_FILENO || !fails("write")) return false;
  errno = ENOSPC;
  return true;
}

bool open_fails(int flags) {
  if ((flags & (O_WRONLY | O_RDWR | O_CREAT)) == 0 || !fails("open")) return false;
  errno = ENOSPC;  // no room for another entry
  return true;
}

mode_t mode_in(va_list arguments, int flags) {
  return (flags & O_CREAT) != 0 ? static_cast<mode_t>(va_arg(arguments, int)) : 0;
}

int counted_main(int argc, char** argv, char** environment) {
  const char* kind = std::getenv("FAULT_KIND");
  const char* at = std::getenv("FAULT_AT");
  const char* count = std::getenv("FAULT_COUNT");
  faults.kind = kind != nullptr ? kind : "";
  faults.at = at != nullptr ? std::atol(at) : 0;
  faults.on = true;
  const int code = faults.main(argc, argv, environment);
  faults.on = false;
  if (count != nullptr)
    if (std::FILE* file = std::fopen(count, "w"); file != nullptr) {
      std::fprintf(file, "%ld\n", faults.calls.load());
      std::fclose(file);
    }
  return code;
}

}  // namespace

// Names and signatures are the C library's.
extern "C" {

// NOLINTNEXTLINE(bugprone-reserved-identifier, readability-identifier-naming)
int __libc_start_main(Main main, int argc, char** argv, void (*begin)(), void (*end)(), void (*unload)(), void* stack) {
  faults.main = main;
  using Start = int (*)(Main, int, char**, void (*)(), void (*)(), void (*)(), void*);
  return next<Start>("__libc_start_main")(counted_main, argc, argv, begin, end, unload, stack);
}

ssize_t write(int descriptor, const void* bytes, size_t size) {
  if (write_fails(descriptor)) return -1;
  return next<ssize_t (*)(int, const void*, size_t)>("write")(descriptor, bytes, size);
}

ssize_t pwrite(int descriptor, const void* bytes, size_t size, off_t offset) {
  if (write_fails(descriptor)) return -1;
  return next<ssize_t (*)(int, const void*, size_t, off_t)>("pwrite")(descriptor, bytes, size, offset);
}

ssize_t writev(int descriptor, const iovec* parts, int count) {
  if (write_fails(descriptor)) return -1;
  return next<ssize_t (*)(int, const iovec*, int)>("writev")(descriptor, parts, count);
}

int fsync(int descriptor) {
  if (fails("sync")) {
    errno = EIO;
    return -1;
  }
  return next<int (*)(int)>("fsync")(descriptor);
}

int rename(const char* from, const char* to) {
  if (fails("rename")) {
    errno = ENOSPC;
    return -1;
  }
  return next<int (*)(const char*, const char*)>("rename")(from, to);
}

int open(const char* path, int flags, ...) {
  va_list arguments;
  va_start(arguments, flags);
  const mode_t mode = mode_in(arguments, flags);
  va_end(arguments);
  if (open_fails(flags)) return -1;
  return next<int (*)(const char*, int, ...)>("open")(path, flags, mode);
}

int openat(int folder, const char* path, int flags, ...) {
  va_list arguments;
  va_start(arguments, flags);
  const mode_t mode = mode_in(arguments, flags);
  va_end(arguments);
  if (open_fails(flags)) return -1;
  return next<int (*)(int, const char*, int, ...)>("openat")(folder, path, flags, mode);
}

// What std::ofstream opens with.
std::FILE* fopen64(const char* path, const char* mode) {
  if (open_fails(std::strpbrk(mode, "wa+") != nullptr ? O_WRONLY : O_RDONLY)) return nullptr;
  return next<std::FILE* (*)(const char*, const char*)>("fopen64")(path, mode);
}

}  // extern "C"

void* operator new(std::size_t size) {
  void* place = fails("memory") ? nullptr : std::malloc(size > 0 ? size : 1);
  if (place == nullptr) throw std::bad_alloc();
  return place;
}

void* operator new(std::size_t size, std::align_val_t alignment) {
  const auto line = static_cast<std::size_t>(alignment);
  void* place = fails("memory") ? nullptr : std::aligned_alloc(line, (size + line - 1) / line * line);
  if (place == nullptr) throw std::bad_alloc();
  return place;
}

void operator delete(void* place) noexcept {
  std::free(place);
}

void operator delete(void* place, std::size_t /*size*/) noexcept {
  std::free(place);
}

void operator delete(void* place, std::align_val_t /*alignment*/) noexcept {
  std::free(place);
}

void operator delete(void* place, std::size_t /*size*/, std::align_val_t /*alignment*/) noexcept {
  std::free(place);
}
