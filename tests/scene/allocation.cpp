#include "allocation.hpp"

#include <algorithm>
#include <cstdlib>
#include <new>

namespace {

std::size_t alive = 0, highest = 0, at_start = 0;
constexpr std::size_t prefix = alignof(std::max_align_t);

void* counted_new(std::size_t size) {
  void* block = std::malloc(prefix + size);
  if (block == nullptr) throw std::bad_alloc();
  *static_cast<std::size_t*>(block) = size;
  alive += size;
  highest = std::max(highest, alive);
  return static_cast<char*>(block) + prefix;
}

void counted_delete(void* pointer) noexcept {
  if (pointer == nullptr) return;
  void* block = static_cast<char*>(pointer) - prefix;
  alive -= *static_cast<std::size_t*>(block);
  std::free(block);
}

}  // namespace

void* operator new(std::size_t size) {
  return counted_new(size);
}
void* operator new[](std::size_t size) {
  return counted_new(size);
}
void operator delete(void* pointer) noexcept {
  counted_delete(pointer);
}
void operator delete[](void* pointer) noexcept {
  counted_delete(pointer);
}
void operator delete(void* pointer, std::size_t) noexcept {
  counted_delete(pointer);
}
void operator delete[](void* pointer, std::size_t) noexcept {
  counted_delete(pointer);
}

AllocationWatch::AllocationWatch() {
  at_start = alive;
  highest = alive;
}

std::size_t AllocationWatch::peak() const {
  return highest - at_start;
}
