#include "floating_point.hpp"

#if defined(__x86_64__) || defined(_M_X64)
#include <xmmintrin.h>
#endif

namespace velum {
namespace {

#if defined(__x86_64__) || defined(_M_X64)

// MXCSR: bits 13-14 rounding (00 = nearest), bit 15 flush-to-zero, bit 6 denormals-are-zero.
constexpr unsigned long long what_changes_results = 0xe040u;
unsigned long long control_word() {
  return _mm_getcsr();
}
void set_control_word(unsigned long long word) {
  _mm_setcsr(static_cast<unsigned>(word));
}

#elif defined(__aarch64__)

// FPCR: bits 22-23 rounding (00 = nearest), bit 24 FZ, bit 19 FZ16, bits 0-1 FIZ and AH (Armv8.7).
constexpr unsigned long long what_changes_results = 0x1c80003u;
unsigned long long control_word() {
  unsigned long long word = 0;
  __asm__ __volatile__("mrs %0, fpcr" : "=r"(word));
  return word;
}
void set_control_word(unsigned long long word) {
  __asm__ __volatile__("msr fpcr, %0" : : "r"(word));
}

#else

// No such modes (WebAssembly), or none that is known here.
constexpr unsigned long long what_changes_results = 0;
unsigned long long control_word() {
  return 0;
}
void set_control_word(unsigned long long) {}

#endif

}  // namespace

FloatingPointScope::FloatingPointScope() : saved_(control_word()) {
  set_control_word(saved_ & ~what_changes_results);
}

FloatingPointScope::~FloatingPointScope() {
  // Only the modes go back; exception flags raised meanwhile stay raised, as after any computation.
  set_control_word((control_word() & ~what_changes_results) | (saved_ & what_changes_results));
}

}  // namespace velum
